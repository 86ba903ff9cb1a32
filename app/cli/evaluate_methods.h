#pragma once
// Purpose: which methods beside the published ones an experiment has: --methods of `evaluate`.

#include <string>
#include <vector>

#include "reconstruction/evaluation/recipe.h"

namespace glisson::cli {

/// Those of the experiment, of the other methods only the wanted ones: "all", "none" or ids separated by commas. Throws UsageError.
std::vector<ModelRecipe> recipesOf(const std::string& methods);

/// The ids there are: "psr_knn,mpu,vessels".
std::string otherMethodsText();

}  // namespace glisson::cli
