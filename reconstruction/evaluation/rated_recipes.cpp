#include "reconstruction/evaluation/rated_recipes.h"

#include <utility>

namespace glisson {

namespace {

std::vector<RatedRecipe> gradedRecipes() {
  std::vector<RatedRecipe> recipes;
  int depth = kDeepestPublished;
  for (const auto& [smoothing, percent] : {std::pair(22, 20), std::pair(45, 40), std::pair(67, 60), std::pair(90, 80)}) {
    const ModelRecipe psr{.family = ModelFamily::Psr, .depth = depth--};
    const ModelRecipe mcsd{.family = ModelFamily::Mcsd, .smoothing = smoothing, .decimationPercent = percent};
    const std::string grade = modelName(psr) + " / " + modelName(mcsd);
    recipes.push_back({.recipe = psr, .method = "PSR", .grade = grade});
    recipes.push_back({.recipe = mcsd, .method = "MCSD", .grade = grade});
  }
  return recipes;
}

}  // namespace

bool hasRatedGroups(const Evaluation& experiment) {
  return experiment.publishedComplete && experiment.bestPsr && experiment.bestMcsd && experiment.mostSimilar;
}

std::vector<RatedRecipe> ratedRecipes(const Evaluation& experiment) {
  if (!hasRatedGroups(experiment)) {
    return gradedRecipes();
  }
  const auto recipe = [&](std::size_t place) { return experiment.models[place].recipe; };
  return {{.recipe = recipe(*experiment.bestPsr), .method = "PSR (P_best)", .group = "P_best"},
          {.recipe = recipe(*experiment.bestMcsd), .method = "MCSD (C_best)", .group = "C_best"},
          {.recipe = recipe(*experiment.mostSimilar), .method = "MCSD (C_sim)", .group = "C_sim"}};
}

}  // namespace glisson
