#pragma once
// Purpose: cohort.csv of `evaluate --cohort`: a row for each patient of the list. Column names are a contract (README, "The command
// line"): units in the names, '.' as the decimal sign, numbers exact, a cell left empty where there is no such number. What may
// differ from run to run stands in the last columns, from "bestPsrSeconds" on.

#include <string>

#include "app/cli/gathered_cohort.h"

namespace glisson::cli {

std::string cohortCsv(const GatheredCohort& cohort);

}  // namespace glisson::cli
