#pragma once
// Purpose: summary.json of `evaluate` (keys are a contract: README, "The command line"), and the same in a few lines for a person.

#include <string>

#include "app/cli/evaluated_label.h"
#include "app/cli/report.h"

namespace glisson::cli {

/// `sampling`, `scale`, `timings`.
Json parametersJson(const ExperimentOptions& options);

/// What may differ from run to run stands under its last key, "seconds".
Json summaryJson(const EvaluatedLabel& label, const Evaluation& evaluation);

/// A table of the models the formulas chose, and a line for each model that failed.
std::string summaryText(const Evaluation& evaluation);

}  // namespace glisson::cli
