#pragma once
// Purpose: the paper's experiment on many patients: each in a folder of its own, as `evaluate` leaves it, and what they say
// together in cohort.csv, cohort.json and cohort.html. Patients fail each for itself; the others go on.

#include <filesystem>
#include <vector>

#include "app/cli/cohort_list.h"
#include "reconstruction/evaluation/recipe.h"

namespace glisson::cli {

struct CohortToEvaluate {
  CohortList list;
  ExperimentOptions options;
  std::vector<ModelRecipe> recipes = {};
  std::filesystem::path folder = {};  ///< DIR; made where it is missing
};

/// Gives each entry the command's flags for what its line leaves empty.
void leaveToFlags(CohortList& list, const MaskChoice& choice, const InputFlags& input);

// Each returns an exit code: 0 where every patient that was asked for is evaluated; 4 where some of them failed or are missing,
// each named in a line on stderr; 3 where there is nobody to tell of, and then no file of the cohort is written; 130 after an
// interrupt.

/// One patient after the other, then gatherCohort(). Throws InputError. Polls cancel.
int evaluateCohort(const CohortToEvaluate& cohort, const ExecutionContext& context);
/// The patient of this number alone, from 1. Throws InputError, UsageError where there is none. Polls cancel.
int evaluatePatient(const CohortToEvaluate& cohort, int number, const ExecutionContext& context);
/// Evaluates nobody: puts together what is in the folder. Throws InputError.
int gatherCohort(const CohortToEvaluate& cohort);

}  // namespace glisson::cli
