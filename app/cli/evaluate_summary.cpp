#include "app/cli/evaluate_summary.h"

#include <algorithm>
#include <functional>

#include "app/cli/table.h"
#include "planning/exchange/version.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

using Place = std::optional<std::size_t>;

Json modelJson(const Evaluation& evaluation, Place place) {
  if (!place) {
    return nullptr;
  }
  const EvaluatedModel& model = evaluation.models[*place];
  const ModelMeasures& measures = *model.measures;
  const ModelScore& score = *evaluation.scores[*place];
  Json json;
  json["model"] = modelId(model.recipe);
  json["name"] = model.name();
  json["triangles"] = measures.triangles;
  json["paperErrorMm"] = toJson(measures.paperErrorMm);
  json["voxelErrorMm"] = toJson(measures.voxelErrorMm);
  json["volumeMl"] = measures.volumeMl ? Json(*measures.volumeMl) : Json(nullptr);
  json["gaussianCurvaturePerMm2"] = measures.curvature.trimmedPerMm2;
  json["normalisedError"] = score.normalised.error;
  json["normalisedTriangles"] = score.normalised.triangles;
  json["score"] = score.score;
  json["pareto"] = score.pareto;
  json["defects"] = measures.defects;
  return json;
}

/// How the second model stands to the first.
Json comparisonJson(const Evaluation& evaluation, Place of, Place against) {
  if (!of || !against) {
    return nullptr;
  }
  const ModelMeasures& fewer = *evaluation.models[*of].measures;
  const ModelMeasures& more = *evaluation.models[*against].measures;
  return {{"model", modelId(evaluation.models[*of].recipe)},
          {"against", modelId(evaluation.models[*against].recipe)},
          {"fewerTrianglesPercent", reductionPercent(static_cast<double>(fewer.triangles), static_cast<double>(more.triangles))},
          {"meanErrorDifferenceMm", fewer.paperErrorMm.mean - more.paperErrorMm.mean}};
}

Json labelJson(const EvaluatedLabel& label) {
  return {{"file", label.file},
          {"name", label.chosen.name},
          {"kind", kindId(label.chosen.kind)},
          {"size", label.geometry.size},
          {"spacingMm", vectorJson(label.geometry.spacing)},
          {"regionOfInterest", label.chosen.mask->box().size},
          {"voxels", label.chosen.mask->count()},
          {"voxelVolumeMl", label.voxelVolumeMl},
          {"errorPoints", label.points}};
}

Json boundsJson(const Evaluation& evaluation) {
  if (!evaluation.bounds) {
    return nullptr;
  }
  const auto& [least, greatest] = *evaluation.bounds;
  return {{"meanErrorMm", {least.errorMm, greatest.errorMm}}, {"triangles", {least.triangles, greatest.triangles}}};
}

/// Of the models whose family belongs to it.
Json frontJson(const Evaluation& evaluation, bool ModelScore::*mark, const std::function<bool(ModelFamily)>& belongs) {
  Json front = Json::array();
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    if (belongs(evaluation.models[n].recipe.family) && evaluation.scores[n] && (*evaluation.scores[n]).*mark) {
      front.push_back(modelId(evaluation.models[n].recipe));
    }
  }
  return front;
}

/// Those that models were made by.
Json otherMethodsJson(const Evaluation& evaluation) {
  Json methods = Json::array();
  for (const ReconstructionMethod& method : listedMethods()) {
    if (std::any_of(evaluation.models.begin(), evaluation.models.end(),
                    [&](const EvaluatedModel& model) { return model.recipe.method == method.id; })) {
      methods.push_back(
          {{"id", method.id}, {"name", method.name}, {"description", method.description}, {"citation", method.citation}});
    }
  }
  return methods;
}

Json failedJson(const Evaluation& evaluation) {
  Json failed = Json::array();
  for (const EvaluatedModel& model : evaluation.models) {
    if (!model.measures) {
      failed.push_back({{"model", modelId(model.recipe)}, {"reason", model.failure}});
    }
  }
  return failed;
}

Json secondsJson(const Evaluation& evaluation) {
  const auto of = [&](Place place) { return place ? Json(evaluation.models[*place].seconds.total()) : Json(nullptr); };
  return {{"bestPsr", of(evaluation.bestPsr)},
          {"mostSimilarMcsd", of(evaluation.mostSimilar)},
          {"bestMcsd", of(evaluation.bestMcsd)},
          {"bestSimplified", of(evaluation.bestSimplified)},
          {"bestOther", of(evaluation.bestOther)}};
}

}  // namespace

Json parametersJson(const ExperimentOptions& options) {
  return {{"sampling", options.sampling == Sampling::Paper ? "paper" : "unbiased"},
          {"scale", options.scale},
          {"timings", options.timings}};
}

Json summaryJson(const EvaluatedLabel& label, const Evaluation& evaluation) {
  Json json;
  json["program"] = "glisson " + std::string(glissonVersion());
  json["label"] = labelJson(label);
  json["parameters"] = parametersJson(label.options);
  json["models"] = evaluation.models.size();
  json["failed"] = failedJson(evaluation);
  json["bounds"] = boundsJson(evaluation);
  json["bestPsr"] = modelJson(evaluation, evaluation.bestPsr);
  json["bestMcsd"] = modelJson(evaluation, evaluation.bestMcsd);
  json["bestOfAll"] = modelJson(evaluation, evaluation.bestOfAll);
  json["mostSimilarMcsd"] = modelJson(evaluation, evaluation.mostSimilar);
  json["bestSimplified"] = modelJson(evaluation, evaluation.bestSimplified);
  json["bestOther"] = modelJson(evaluation, evaluation.bestOther);
  const auto only = [](ModelFamily wanted) { return [wanted](ModelFamily family) { return family == wanted; }; };
  json["paretoFront"] = frontJson(evaluation, &ModelScore::pareto, isPublished);
  json["paretoFrontSimplified"] = frontJson(evaluation, &ModelScore::pareto, only(ModelFamily::SimplifiedPsr));
  json["paretoFrontOther"] = frontJson(evaluation, &ModelScore::pareto, only(ModelFamily::Other));
  json["paretoFrontOfAll"] = frontJson(evaluation, &ModelScore::paretoOfAll, [](ModelFamily /*family*/) { return true; });
  json["otherMethods"] = otherMethodsJson(evaluation);
  json["reductions"] = {{"mostSimilarMcsd", comparisonJson(evaluation, evaluation.bestPsr, evaluation.mostSimilar)},
                        {"bestMcsd", comparisonJson(evaluation, evaluation.bestPsr, evaluation.bestMcsd)},
                        {"simplified", comparisonJson(evaluation, evaluation.bestSimplified, evaluation.bestPsr)}};
  json["notes"] = {
      "The errors that scores and tables use are the paper error: from all inside-surface voxel centres to the mesh.",
      "There is no true error: it needs an analytic body, and a label map has none.",
      "Normalisation, best models and paretoFront are of PSR and MCSD alone; simplified models and those of other methods "
      "are on the same scale."};
  json["seconds"] = secondsJson(evaluation);
  return json;
}

std::string summaryText(const Evaluation& evaluation) {
  std::vector<std::vector<std::string>> rows{{"", "model", "triangles", "mean mm", "score", "K per mm2", "seconds"}};
  for (const auto& [role, place] : {std::pair("best PSR", evaluation.bestPsr),
                                    {"most similar MCSD", evaluation.mostSimilar},
                                    {"best MCSD", evaluation.bestMcsd},
                                    {"best of both", evaluation.bestOfAll},
                                    {"best simplified", evaluation.bestSimplified},
                                    {"best other", evaluation.bestOther}}) {
    if (place) {
      const EvaluatedModel& model = evaluation.models[*place];
      rows.push_back({role, model.name(), std::to_string(model.measures->triangles),
                      formatNumber(model.measures->paperErrorMm.mean, 3), formatNumber(evaluation.scores[*place]->score, 3),
                      formatNumber(model.measures->curvature.trimmedPerMm2, 5), formatNumber(model.seconds.total(), 2)});
    }
  }
  std::string text = alignedTable(rows);
  for (const EvaluatedModel& model : evaluation.models) {
    if (!model.measures) {
      text += "note: " + model.name() + ": " + model.failure + "\n";
    }
  }
  return text;
}

}  // namespace glisson::cli
