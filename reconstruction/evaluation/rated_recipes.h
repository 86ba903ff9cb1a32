#pragma once
// Purpose: which models of one structure are rated blindly against each other [Palomar 2016, 3.4].

#include <string>
#include <vector>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

struct RatedRecipe {
  ModelRecipe recipe;
  std::string method;      ///< RatedModel::method
  std::string grade = {};  ///< RatedModel::grade
  /// One recipe may be in two groups (the best MCSD and the most similar one): its models are two. Empty: there are no groups.
  std::string group = {};
};

/// All published models are there, and each of the paper's three groups has one.
bool hasRatedGroups(const Evaluation& experiment);

/// The paper's three groups, P_best, C_best and C_sim of the experiment, where hasRatedGroups(). Else, of an
/// experiment that is not there or not complete, a depth of PSR and a smoothing of MCSD for each of four grades, from nearly raw to
/// strongly reduced.
std::vector<RatedRecipe> ratedRecipes(const Evaluation& experiment);

}  // namespace glisson
