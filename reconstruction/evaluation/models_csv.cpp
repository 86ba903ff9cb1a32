#include "reconstruction/evaluation/models_csv.h"

#include <array>
#include <functional>

#include "reconstruction/csv.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

struct Row {
  const Evaluation& evaluation;
  std::size_t place;
  double voxelVolumeMl;

  [[nodiscard]] const EvaluatedModel& model() const { return evaluation.models[place]; }
  [[nodiscard]] const ModelScore* score() const { return evaluation.finalScore(place); }
};

struct Column {
  const char* name;
  std::function<std::string(const Row&)> text;
};

std::string numberOf(std::optional<double> value) { return value ? formatExact(*value) : std::string(); }

Column text(const char* name, std::string (*of)(const Row&)) { return {name, of}; }

/// Of a family alone.
Column parameter(const char* name, int ModelRecipe::*value, bool (*belongs)(ModelFamily)) {
  return {name, [value, belongs](const Row& row) {
            const ModelRecipe& recipe = row.model().recipe;
            return belongs(recipe.family) ? std::to_string(recipe.*value) : std::string();
          }};
}

Column measure(const char* name, std::optional<double> (*of)(const ModelMeasures&)) {
  return {name, [of](const Row& row) { return row.model().measures ? numberOf(of(*row.model().measures)) : std::string(); }};
}

Column count(const char* name, std::size_t (*of)(const ModelMeasures&)) {
  return {name, [of](const Row& row) { return row.model().measures ? std::to_string(of(*row.model().measures)) : std::string(); }};
}

Column score(const char* name, double (*of)(const ModelScore&)) {
  return {name, [of](const Row& row) { return row.score() != nullptr ? formatExact(of(*row.score())) : std::string(); }};
}

Column seconds(const char* name, double ModelSeconds::*stage) {
  return {name, [stage](const Row& row) { return formatExact(row.model().seconds.*stage); }};
}

bool isMcsd(ModelFamily family) { return family == ModelFamily::Mcsd; }
bool isPoisson(ModelFamily family) { return family == ModelFamily::Psr || family == ModelFamily::SimplifiedPsr; }
bool isSimplified(ModelFamily family) { return family == ModelFamily::SimplifiedPsr; }

/// "bestPsr bestOfAll": what the formulas chose this model for.
std::string rolesOf(const Row& row) {
  const Evaluation& all = row.evaluation;
  std::string roles;
  if (!all.publishedComplete) {
    return roles;
  }
  for (const auto& [role, place] : {std::pair("bestPsr", all.bestPsr),
                                    {"bestMcsd", all.bestMcsd},
                                    {"bestOfAll", all.bestOfAll},
                                    {"mostSimilar", all.mostSimilar},
                                    {"bestSimplified", all.bestSimplified},
                                    {"bestOther", all.bestOther}}) {
    if (place == row.place) {
      roles += (roles.empty() ? "" : " ") + std::string(role);
    }
  }
  return roles;
}

std::string defectsOf(const Row& row) {
  std::string list;
  if (row.model().measures) {
    for (const std::string& name : row.model().measures->defects) {
      list += (list.empty() ? "" : "; ") + name;
    }
  }
  return list;
}

std::string deviationOf(const Row& row) {
  const auto& measures = row.model().measures;
  return measures && measures->volumeMl ? formatExact(100.0 * (*measures->volumeMl - row.voxelVolumeMl) / row.voxelVolumeMl)
                                        : std::string();
}

void add(std::vector<Column>& columns, std::vector<Column> more) {
  columns.insert(columns.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

using M = ModelMeasures;
using Number = std::optional<double>;

std::vector<Column> recipeColumns() {
  return {text("family", [](const Row& row) { return std::string(familyId(row.model().recipe.family)); }),
          text("method", [](const Row& row) { return std::string(methodId(row.model().recipe)); }),
          parameter("depth", &ModelRecipe::depth, isPoisson),
          parameter("smoothing", &ModelRecipe::smoothing, isMcsd),
          {"decimation",
           [](const Row& row) {
             const ModelRecipe& recipe = row.model().recipe;
             return isMcsd(recipe.family) ? formatExact(recipe.decimationPercent / 100.0) : std::string();
           }},
          parameter("divisor", &ModelRecipe::divisor, isSimplified),
          text("variant", [](const Row& row) { return row.model().recipe.variant; }),
          text("model", [](const Row& row) { return modelId(row.model().recipe); }),
          {"usedDepth", [](const Row& row) { return row.model().usedDepth > 0 ? std::to_string(row.model().usedDepth) : ""; }}};
}

std::vector<Column> errorColumns() {
  return {measure("meanErrorMm", [](const M& m) -> Number { return m.paperErrorMm.mean; }),
          measure("medianErrorMm", [](const M& m) -> Number { return m.paperErrorMm.median; }),
          measure("p95ErrorMm", [](const M& m) -> Number { return m.paperErrorMm.p95; }),
          measure("maxErrorMm", [](const M& m) -> Number { return m.paperErrorMm.max; }),
          measure("lowWhiskerErrorMm", [](const M& m) -> Number { return m.paperErrorBoxMm.lowWhisker; }),
          measure("lowQuartileErrorMm", [](const M& m) -> Number { return m.paperErrorBoxMm.lowQuartile; }),
          measure("highQuartileErrorMm", [](const M& m) -> Number { return m.paperErrorBoxMm.highQuartile; }),
          measure("highWhiskerErrorMm", [](const M& m) -> Number { return m.paperErrorBoxMm.highWhisker; }),
          measure("meanVoxelErrorMm", [](const M& m) -> Number { return m.voxelErrorMm.mean; }),
          measure("medianVoxelErrorMm", [](const M& m) -> Number { return m.voxelErrorMm.median; }),
          measure("p95VoxelErrorMm", [](const M& m) -> Number { return m.voxelErrorMm.p95; }),
          measure("maxVoxelErrorMm", [](const M& m) -> Number { return m.voxelErrorMm.max; }),
          measure("meanMeshToVoxelsMm", [](const M& m) -> Number { return m.meshToVoxelsMm.mean; }),
          measure("medianMeshToVoxelsMm", [](const M& m) -> Number { return m.meshToVoxelsMm.median; }),
          measure("p95MeshToVoxelsMm", [](const M& m) -> Number { return m.meshToVoxelsMm.p95; }),
          measure("maxMeshToVoxelsMm", [](const M& m) -> Number { return m.meshToVoxelsMm.max; }),
          measure("meanVoxelsToMeshMm", [](const M& m) -> Number { return m.voxelsToMeshMm.mean; }),
          measure("medianVoxelsToMeshMm", [](const M& m) -> Number { return m.voxelsToMeshMm.median; }),
          measure("p95VoxelsToMeshMm", [](const M& m) -> Number { return m.voxelsToMeshMm.p95; }),
          measure("maxVoxelsToMeshMm", [](const M& m) -> Number { return m.voxelsToMeshMm.max; })};
}

std::vector<Column> shapeColumns() {
  return {measure("volumeMl", [](const M& m) { return m.volumeMl; }),
          {"voxelVolumeMl", [](const Row& row) { return formatExact(row.voxelVolumeMl); }},
          text("volumeDeviationPercent", deviationOf),
          measure("gaussianCurvaturePerMm2", [](const M& m) -> Number { return m.curvature.trimmedPerMm2; }),
          measure("gaussianCurvatureUntrimmedPerMm2", [](const M& m) -> Number { return m.curvature.untrimmedPerMm2; }),
          measure("gaussianCurvatureAsShippedPerMm2", [](const M& m) -> Number { return m.shipped.curvature.trimmedPerMm2; }),
          measure("gaussianCurvatureAsShippedUntrimmedPerMm2",
                  [](const M& m) -> Number { return m.shipped.curvature.untrimmedPerMm2; }),
          count("verticesAsShipped", [](const M& m) { return m.shipped.vertices; }),
          count("tinyTriangles", [](const M& m) { return m.curvature.tinyTriangles; })};
}

std::vector<Column> scoreColumns() {
  return {score("normalisedError", [](const ModelScore& s) { return s.normalised.error; }),
          score("normalisedTriangles", [](const ModelScore& s) { return s.normalised.triangles; }),
          score("score", [](const ModelScore& s) { return s.score; }),
          score("pareto", [](const ModelScore& s) { return s.pareto ? 1.0 : 0.0; }),
          score("paretoOfAll", [](const ModelScore& s) { return s.paretoOfAll ? 1.0 : 0.0; }),
          text("roles", rolesOf),
          text("defects", defectsOf),
          text("failure", [](const Row& row) { return row.model().failure; })};
}

std::vector<Column> timedColumns() {
  return {{kFirstTimedColumn, [](const Row& row) { return formatExact(row.model().seconds.total()); }},
          seconds("sampleSeconds", &ModelSeconds::sample),
          seconds("solveSeconds", &ModelSeconds::solve),
          seconds("extractSeconds", &ModelSeconds::extract),
          seconds("decimateSeconds", &ModelSeconds::decimate),
          seconds("smoothSeconds", &ModelSeconds::smooth),
          seconds("simplifySeconds", &ModelSeconds::simplify),
          seconds("measureSeconds", &ModelSeconds::measure),
          {"peakMemoryMb", [](const Row& row) { return numberOf(row.model().peakMemoryMb); }}};
}

std::vector<Column> allColumns() {
  std::vector<Column> columns = recipeColumns();
  add(columns,
      {count("triangles", [](const M& m) { return m.triangles; }), count("vertices", [](const M& m) { return m.vertices; })});
  add(columns, errorColumns());
  add(columns, shapeColumns());
  add(columns, scoreColumns());
  add(columns, timedColumns());
  return columns;
}

}  // namespace

std::string modelsCsv(const Evaluation& evaluation, double voxelVolumeMl) {
  const std::vector<Column> columns = allColumns();
  std::string csv = csvLine(modelsCsvColumns());
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    std::vector<std::string> cells;
    cells.reserve(columns.size());
    for (const Column& column : columns) {
      cells.push_back(column.text({evaluation, n, voxelVolumeMl}));
    }
    csv += csvLine(cells);
  }
  return csv;
}

std::vector<std::string> modelsCsvColumns() {
  std::vector<std::string> names;
  for (const Column& column : allColumns()) {
    names.emplace_back(column.name);
  }
  return names;
}

}  // namespace glisson
