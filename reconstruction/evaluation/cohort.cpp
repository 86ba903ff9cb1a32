#include "reconstruction/evaluation/cohort.h"

#include <algorithm>

#include "reconstruction/evaluation/statistics.h"

namespace glisson {

namespace {

using Patients = std::span<const PatientFigures>;

ModelFigures modelFigures(const Evaluation& evaluation, std::size_t place) {
  const EvaluatedModel& model = evaluation.models[place];
  return {.id = modelId(model.recipe),
          .triangles = static_cast<double>(model.measures->triangles),
          .meanErrorMm = model.measures->paperErrorMm.mean,
          .score = evaluation.scores[place]->score,
          .gaussianCurvaturePerMm2 = model.measures->curvature.trimmedPerMm2,
          .seconds = model.seconds.total()};
}

/// `of` gives a patient's number, or nothing.
template <typename Of>
Distribution over(Patients patients, const Of& of) {
  std::vector<double> values;
  for (const PatientFigures& patient : patients) {
    if (const std::optional<double> value = of(patient)) {
      values.push_back(*value);
    }
  }
  return distributionOf(values);
}

/// `chosen` gives a patient's model, or nothing.
template <typename Chosen>
ModelDistributions modelsOver(Patients patients, const Chosen& chosen) {
  const auto number = [&](double ModelFigures::*value) {
    return over(patients, [&](const PatientFigures& patient) -> std::optional<double> {
      const std::optional<ModelFigures> model = chosen(patient);
      return model ? std::optional((*model).*value) : std::nullopt;
    });
  };
  return {.score = number(&ModelFigures::score),
          .meanErrorMm = number(&ModelFigures::meanErrorMm),
          .triangles = number(&ModelFigures::triangles),
          .gaussianCurvaturePerMm2 = number(&ModelFigures::gaussianCurvaturePerMm2),
          .seconds = number(&ModelFigures::seconds)};
}

ComparisonDistributions comparisonsOver(Patients patients, std::optional<Comparison> (*compare)(const PatientFigures&)) {
  const auto number = [&](double Comparison::*value) {
    return over(patients, [&](const PatientFigures& patient) -> std::optional<double> {
      const std::optional<Comparison> comparison = compare(patient);
      return comparison ? std::optional((*comparison).*value) : std::nullopt;
    });
  };
  return {.fewerTrianglesPercent = number(&Comparison::fewerTrianglesPercent),
          .meanErrorDifferenceMm = number(&Comparison::meanErrorDifferenceMm)};
}

std::size_t countOf(Patients patients, bool (*holds)(const PatientFigures&, int depth), int depth) {
  return static_cast<std::size_t>(
      std::count_if(patients.begin(), patients.end(), [&](const PatientFigures& patient) { return holds(patient, depth); }));
}

DepthDistributions depthOver(Patients patients, int depth) {
  const auto ofDepth = [depth](const PatientFigures& patient) {
    const auto found = patient.psr.find(depth);
    return found == patient.psr.end() ? std::nullopt : std::optional(found->second);
  };
  const auto isBest = [](const PatientFigures& patient, int wanted) { return patient.bestDepth == wanted; };
  const auto isBestOfAll = [](const PatientFigures& patient, int wanted) {
    return patient.bestDepth == wanted && patient.psrIsBestOfAll();
  };
  return {.depth = depth,
          .models = modelsOver(patients, ofDepth),
          .bestOfPsr = countOf(patients, isBest, depth),
          .bestOfAll = countOf(patients, isBestOfAll, depth)};
}

std::vector<OtherDistributions> othersOver(Patients patients) {
  std::vector<OtherDistributions> others;
  for (const ModelRecipe& recipe : allRecipes()) {
    const std::string id = modelId(recipe);
    const auto ofId = [&](const PatientFigures& patient) { return patient.other(id); };
    if (std::any_of(patients.begin(), patients.end(), [&](const PatientFigures& patient) { return ofId(patient).has_value(); })) {
      others.push_back({id, modelName(recipe), modelsOver(patients, ofId)});
    }
  }
  return others;
}

}  // namespace

std::optional<ModelFigures> PatientFigures::bestPsr() const { return bestDepth ? std::optional(psr.at(*bestDepth)) : std::nullopt; }

bool PatientFigures::psrIsBestOfAll() const {
  const std::optional<ModelFigures> best = bestPsr();
  return best && (!bestMcsd || best->score <= bestMcsd->score);
}

std::optional<ModelFigures> PatientFigures::other(const std::string& id) const {
  const auto found = std::find_if(others.begin(), others.end(), [&](const ModelFigures& model) { return model.id == id; });
  return found == others.end() ? std::nullopt : std::optional(*found);
}

PatientFigures figuresOf(const Evaluation& evaluation) {
  PatientFigures figures;
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    const EvaluatedModel& model = evaluation.models[n];
    if (!model.measures) {
      figures.failures.push_back(model.name() + ": " + model.failure);
    } else if (model.recipe.family == ModelFamily::Psr && evaluation.scores[n]) {
      figures.psr[model.recipe.depth] = modelFigures(evaluation, n);
    } else if (model.recipe.family == ModelFamily::Other && evaluation.scores[n]) {
      figures.others.push_back(modelFigures(evaluation, n));
    }
  }
  if (evaluation.bestPsr) {
    figures.bestDepth = evaluation.models[*evaluation.bestPsr].recipe.depth;
  }
  const auto chosen = [&](std::optional<std::size_t> place) {
    return place ? std::optional(modelFigures(evaluation, *place)) : std::nullopt;
  };
  figures.mostSimilarMcsd = chosen(evaluation.mostSimilar);
  figures.bestMcsd = chosen(evaluation.bestMcsd);
  figures.bestSimplified = chosen(evaluation.bestSimplified);
  return figures;
}

std::optional<Comparison> compared(const std::optional<ModelFigures>& model, const std::optional<ModelFigures>& against) {
  if (!model || !against) {
    return std::nullopt;
  }
  return Comparison{.fewerTrianglesPercent = reductionPercent(model->triangles, against->triangles),
                    .meanErrorDifferenceMm = model->meanErrorMm - against->meanErrorMm};
}

std::optional<Comparison> againstMostSimilar(const PatientFigures& patient) {
  return compared(patient.bestPsr(), patient.mostSimilarMcsd);
}
std::optional<Comparison> againstBestMcsd(const PatientFigures& patient) { return compared(patient.bestPsr(), patient.bestMcsd); }
std::optional<Comparison> simplifiedAgainstPsr(const PatientFigures& patient) {
  return compared(patient.bestSimplified, patient.bestPsr());
}

Distribution distributionOf(std::span<const double> values) {
  if (values.empty()) {
    return {};
  }
  const Spread spread = spreadOf(values);
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {.patients = values.size(),
          .mean = spread.mean,
          .deviation = values.size() > 1 ? std::optional(spread.deviation) : std::nullopt,
          .least = *least,
          .greatest = *greatest};
}

CohortStatistics statisticsOf(std::span<const PatientFigures> patients) {
  CohortStatistics statistics;
  statistics.patients = patients.size();
  std::vector<int> depths;
  for (const PatientFigures& patient : patients) {
    for (const auto& [depth, model] : patient.psr) {
      depths.push_back(depth);
    }
    statistics.mcsdBestOfAll += patient.bestMcsd && !patient.psrIsBestOfAll() ? 1 : 0;
  }
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  for (const int depth : depths) {
    statistics.depths.push_back(depthOver(patients, depth));
  }
  statistics.bestPsr = modelsOver(patients, [](const PatientFigures& patient) { return patient.bestPsr(); });
  statistics.mostSimilarMcsd = modelsOver(patients, [](const PatientFigures& patient) { return patient.mostSimilarMcsd; });
  statistics.bestMcsd = modelsOver(patients, [](const PatientFigures& patient) { return patient.bestMcsd; });
  statistics.bestSimplified = modelsOver(patients, [](const PatientFigures& patient) { return patient.bestSimplified; });
  statistics.others = othersOver(patients);
  statistics.againstMostSimilar = comparisonsOver(patients, againstMostSimilar);
  statistics.againstBestMcsd = comparisonsOver(patients, againstBestMcsd);
  statistics.simplifiedAgainstPsr = comparisonsOver(patients, simplifiedAgainstPsr);
  return statistics;
}

}  // namespace glisson
