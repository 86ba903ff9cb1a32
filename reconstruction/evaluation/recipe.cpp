#include "reconstruction/evaluation/recipe.h"

#include "reconstruction/errors.h"

namespace glisson {

void ExperimentOptions::validate() const {
  poissonOf({.depth = kDeepestPublished}, *this).validate();
  if (timings < 1 || timings > 100) {
    throw UsageError("The number of timed runs is " + std::to_string(timings) + "; choose 1 to 100.");
  }
}

std::vector<ModelRecipe> allRecipes() {
  std::vector<ModelRecipe> recipes;
  for (int depth = 5; depth <= kDeepestPublished; ++depth) {
    recipes.push_back({.family = ModelFamily::Psr, .depth = depth});
  }
  for (const int smoothing : {0, 22, 45, 67, 90}) {
    for (int percent = 0; percent < 100; percent += 10) {
      recipes.push_back({.family = ModelFamily::Mcsd, .smoothing = smoothing, .decimationPercent = percent});
    }
  }
  for (const int divisor : {4, 16, 32, 64}) {
    recipes.push_back({.family = ModelFamily::SimplifiedPsr, .depth = kDeepestPublished, .divisor = divisor});
  }
  return recipes;
}

bool isPublished(ModelFamily family) { return family != ModelFamily::SimplifiedPsr; }

std::string_view familyId(ModelFamily family) { return family == ModelFamily::SimplifiedPsr ? "simplified" : methodId(family); }

std::string_view methodId(ModelFamily family) { return family == ModelFamily::Mcsd ? "mcsd" : "psr"; }

std::string modelId(const ModelRecipe& recipe) {
  const std::string family(familyId(recipe.family));
  switch (recipe.family) {
    case ModelFamily::Psr:
      return family + "_d" + std::to_string(recipe.depth);
    case ModelFamily::Mcsd:
      return family + "_s" + std::to_string(recipe.smoothing) + "_e" + std::to_string(recipe.decimationPercent);
    case ModelFamily::SimplifiedPsr:
      break;
  }
  return family + "_" + std::to_string(recipe.divisor);
}

std::string modelName(const ModelRecipe& recipe) {
  switch (recipe.family) {
    case ModelFamily::Psr:
      return "PSR d=" + std::to_string(recipe.depth);
    case ModelFamily::Mcsd:
      return "MCSD s=" + std::to_string(recipe.smoothing) + " e=" + std::to_string(recipe.decimationPercent) + " %";
    case ModelFamily::SimplifiedPsr:
      break;
  }
  return "PSR d=" + std::to_string(recipe.depth) + ", 1/" + std::to_string(recipe.divisor);
}

PoissonParameters poissonOf(const ModelRecipe& recipe, const ExperimentOptions& options) {
  return {.depth = recipe.depth, .sampling = options.sampling, .scale = options.scale};
}

McsdParameters mcsdOf(const ModelRecipe& recipe) {
  return {.smoothing = recipe.smoothing,
          .filter = SmoothingFilter::Laplacian,
          .decimation = recipe.decimationPercent / 100.0,
          .order = McsdOrder::DecimateFirst};
}

}  // namespace glisson
