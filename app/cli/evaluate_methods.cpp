#include "app/cli/evaluate_methods.h"

#include <set>
#include <sstream>

#include "reconstruction/errors.h"
#include "reconstruction/methods/methods.h"

namespace glisson::cli {

namespace {

/// The ids of a comma separated list, all, or none of the listed methods.
std::set<std::string, std::less<>> otherMethodsOf(const std::string& text) {
  std::set<std::string, std::less<>> ids;
  if (text == "none") {
    return ids;
  }
  if (text == "all") {
    for (const ReconstructionMethod& method : listedMethods()) {
      ids.insert(method.id);
    }
    return ids;
  }
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    ids.insert(listedMethod(part).id);
  }
  if (ids.empty()) {
    throw UsageError("--methods takes all, none or names of other methods separated by commas, not \"" + text + "\"");
  }
  return ids;
}

}  // namespace

std::string otherMethodsText() {
  std::string text;
  for (const ReconstructionMethod& method : listedMethods()) {
    text += (text.empty() ? "" : ",") + method.id;
  }
  return text;
}

std::vector<ModelRecipe> recipesOf(const std::string& methods) {
  const auto wanted = otherMethodsOf(methods);
  std::vector<ModelRecipe> recipes = allRecipes();
  std::erase_if(recipes,
                [&](const ModelRecipe& recipe) { return recipe.family == ModelFamily::Other && !wanted.contains(recipe.method); });
  return recipes;
}

}  // namespace glisson::cli
