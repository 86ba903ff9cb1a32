#include "reconstruction/evaluation/evaluation.h"

#include <algorithm>

namespace glisson {

namespace {

using Places = std::vector<std::size_t>;

template <typename Belongs>
Places placesOf(const std::vector<EvaluatedModel>& models, const Belongs& belongs) {
  Places places;
  for (std::size_t n = 0; n < models.size(); ++n) {
    if (models[n].measures && belongs(models[n].recipe.family)) {
      places.push_back(n);
    }
  }
  return places;
}

std::vector<Objectives> objectivesOf(const std::vector<EvaluatedModel>& models, const Places& places) {
  std::vector<Objectives> objectives;
  objectives.reserve(places.size());
  for (const std::size_t place : places) {
    const ModelMeasures& measures = *models[place].measures;
    objectives.push_back({measures.paperErrorMm.mean, static_cast<double>(measures.triangles)});
  }
  return objectives;
}

/// The first of `places` with the least score.
std::optional<std::size_t> bestOf(const Evaluation& evaluation, const Places& places) {
  std::vector<double> scores;
  scores.reserve(places.size());
  for (const std::size_t place : places) {
    scores.push_back(evaluation.scores[place]->score);
  }
  const auto least = placeOfLeast(scores);
  return least ? std::optional(places[*least]) : std::nullopt;
}

std::optional<std::size_t> mostSimilarTo(const Evaluation& evaluation, std::size_t wanted, const Places& places) {
  std::vector<double> curvatures;
  curvatures.reserve(places.size());
  for (const std::size_t place : places) {
    curvatures.push_back(evaluation.models[place].measures->curvature.trimmedPerMm2);
  }
  const auto nearest = placeOfNearest(curvatures, evaluation.models[wanted].measures->curvature.trimmedPerMm2);
  return nearest ? std::optional(places[*nearest]) : std::nullopt;
}

bool holdsAllPublished(const std::vector<EvaluatedModel>& models) {
  const std::vector<ModelRecipe> recipes = allRecipes();
  return std::ranges::all_of(recipes, [&](const ModelRecipe& recipe) {
    return !isPublished(recipe.family) || std::ranges::find(models, recipe, &EvaluatedModel::recipe) != models.end();
  });
}

void markFront(Evaluation& evaluation, const Places& places, bool ModelScore::*mark) {
  const std::vector<bool> front = onParetoFront(objectivesOf(evaluation.models, places));
  for (std::size_t n = 0; n < places.size(); ++n) {
    (*evaluation.scores[places[n]]).*mark = front[n];
  }
}

}  // namespace

std::string EvaluatedModel::name() const {
  ModelRecipe used = recipe;
  used.depth = measures && usedDepth > 0 ? usedDepth : recipe.depth;
  return modelName(used);
}

std::size_t Evaluation::failed() const {
  return static_cast<std::size_t>(
      std::count_if(models.begin(), models.end(), [](const EvaluatedModel& model) { return !model.measures; }));
}

const ModelScore* Evaluation::finalScore(std::size_t place) const {
  return publishedComplete && scores[place] ? &*scores[place] : nullptr;
}

Evaluation evaluated(std::vector<EvaluatedModel> models) {
  Evaluation evaluation;
  evaluation.publishedComplete = holdsAllPublished(models);
  evaluation.scores.resize(models.size());
  evaluation.models = std::move(models);
  const Places published = placesOf(evaluation.models, isPublished);
  if (published.empty()) {
    return evaluation;
  }
  evaluation.bounds = boundsOf(objectivesOf(evaluation.models, published));
  const Places all = placesOf(evaluation.models, [](ModelFamily /*family*/) { return true; });
  const std::vector<Objectives> objectives = objectivesOf(evaluation.models, all);
  for (std::size_t n = 0; n < all.size(); ++n) {
    ModelScore& score = evaluation.scores[all[n]].emplace();
    score.normalised = normalised(objectives[n], *evaluation.bounds);
    score.score = score.normalised.score();
  }
  const auto placesOfFamily = [&](ModelFamily wanted) {
    return placesOf(evaluation.models, [wanted](ModelFamily family) { return family == wanted; });
  };
  const Places simplified = placesOfFamily(ModelFamily::SimplifiedPsr);
  markFront(evaluation, published, &ModelScore::pareto);
  const Places others = placesOfFamily(ModelFamily::Other);
  markFront(evaluation, simplified, &ModelScore::pareto);
  markFront(evaluation, others, &ModelScore::pareto);
  markFront(evaluation, all, &ModelScore::paretoOfAll);
  evaluation.bestPsr = bestOf(evaluation, placesOfFamily(ModelFamily::Psr));
  evaluation.bestMcsd = bestOf(evaluation, placesOfFamily(ModelFamily::Mcsd));
  evaluation.bestOfAll = bestOf(evaluation, published);
  evaluation.bestSimplified = bestOf(evaluation, simplified);
  evaluation.bestOther = bestOf(evaluation, others);
  if (evaluation.bestPsr) {
    evaluation.mostSimilar = mostSimilarTo(evaluation, *evaluation.bestPsr, placesOfFamily(ModelFamily::Mcsd));
  }
  return evaluation;
}

}  // namespace glisson
