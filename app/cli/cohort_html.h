#pragma once
// Purpose: cohort.html of `evaluate --cohort`: Tables 2, 3 and 5 of Palomar et al. 2016 for many patients, and who is missing. One
// file that needs nothing else; every text from outside is escaped.

#include <string>

#include "app/cli/gathered_cohort.h"

namespace glisson::cli {

/// At least one patient was evaluated. What may differ from run to run stands between the lines "<!-- times -->" and "<!-- end of
/// times -->".
std::string cohortHtml(const GatheredCohort& cohort);

}  // namespace glisson::cli
