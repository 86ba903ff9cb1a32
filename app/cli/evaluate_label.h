#pragma once
// Purpose: the paper's experiment on one label, from its file to models.csv, summary.json and report.html.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/choose.h"
#include "app/cli/command.h"
#include "reconstruction/evaluation/evaluation.h"

namespace glisson::cli {

struct LabelToEvaluate {
  std::string segmentation;  ///< label map or folder of masks
  ReadOptions reading;
  MaskChoice choice;
  ExperimentOptions options;
  std::vector<ModelRecipe> recipes;
  std::filesystem::path folder;  ///< of the results; made where it is missing
};

/// Makes and measures the models that the folder does not hold yet, writes the three files and prints a summary. Nothing where the
/// user interrupted it while models were made, which stderr says then. Throws InputError, ReconstructionError, UsageError,
/// CheckFailed where no model could be made, and Cancelled before the first. Polls cancel.
std::optional<Evaluation> evaluateLabel(const LabelToEvaluate& wanted, const ExecutionContext& context);

/// "DIR/" is DIR.
std::filesystem::path withoutSlash(const std::string& text);

}  // namespace glisson::cli
