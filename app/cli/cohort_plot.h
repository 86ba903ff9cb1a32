#pragma once
// Purpose: the picture in cohort.html of `evaluate --cohort`, as an SVG element.

#include <string>

#include "app/cli/gathered_cohort.h"

namespace glisson::cli {

/// Objective score over depth: a line for each evaluated patient, and a mark for its best MCSD model. At least one patient was
/// evaluated.
std::string scorePlot(const GatheredCohort& cohort);

}  // namespace glisson::cli
