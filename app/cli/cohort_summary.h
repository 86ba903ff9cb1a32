#pragma once
// Purpose: cohort.json of `evaluate --cohort` (keys are a contract: README, "The command line"), and the same in a few lines for a
// person.

#include <string>

#include "app/cli/gathered_cohort.h"
#include "app/cli/report.h"

namespace glisson::cli {

/// What may differ from run to run stands under its last key, "seconds".
Json cohortJson(const GatheredCohort& cohort);

/// "0.184 ± 0.037": the mean and, of two patients and more, the standard deviation; "-" of none.
std::string withSpread(const Distribution& numbers, int decimals);

/// How many patients there are, a table of the depths and the chosen models, and the reduction in triangles.
std::string cohortText(const GatheredCohort& cohort);

}  // namespace glisson::cli
