#include "reconstruction/evaluation/recipe.h"

#include "reconstruction/errors.h"
#include "reconstruction/methods/methods.h"

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
  for (const ReconstructionMethod& method : listedMethods()) {
    for (const MethodVariant& variant : method.variants) {
      recipes.push_back({.family = ModelFamily::Other, .method = method.id, .variant = variant.id});
    }
  }
  return recipes;
}

bool isPublished(ModelFamily family) { return family == ModelFamily::Psr || family == ModelFamily::Mcsd; }

std::string_view familyId(ModelFamily family) {
  switch (family) {
    case ModelFamily::Psr:
      return "psr";
    case ModelFamily::Mcsd:
      return "mcsd";
    case ModelFamily::SimplifiedPsr:
      return "simplified";
    case ModelFamily::Other:
      break;
  }
  return "other";
}

std::string_view methodId(const ModelRecipe& recipe) {
  if (recipe.family == ModelFamily::Other) {
    return recipe.method;
  }
  return recipe.family == ModelFamily::Mcsd ? "mcsd" : "psr";
}

std::string modelId(const ModelRecipe& recipe) {
  const std::string family(familyId(recipe.family));
  switch (recipe.family) {
    case ModelFamily::Psr:
      return family + "_d" + std::to_string(recipe.depth);
    case ModelFamily::Mcsd:
      return family + "_s" + std::to_string(recipe.smoothing) + "_e" + std::to_string(recipe.decimationPercent);
    case ModelFamily::SimplifiedPsr:
      return family + "_" + std::to_string(recipe.divisor);
    case ModelFamily::Other:
      break;
  }
  return recipe.method + "_" + recipe.variant;
}

std::string modelName(const ModelRecipe& recipe) {
  switch (recipe.family) {
    case ModelFamily::Psr:
      return "PSR d=" + std::to_string(recipe.depth);
    case ModelFamily::Mcsd:
      return "MCSD s=" + std::to_string(recipe.smoothing) + " e=" + std::to_string(recipe.decimationPercent) + " %";
    case ModelFamily::SimplifiedPsr:
      return "PSR d=" + std::to_string(recipe.depth) + ", 1/" + std::to_string(recipe.divisor);
    case ModelFamily::Other:
      break;
  }
  const ReconstructionMethod& method = listedMethod(recipe.method);
  return method.name + " " + variantOf(method, recipe.variant).name;
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
