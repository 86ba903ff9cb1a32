#pragma once
// Purpose: what the evaluation of one patient of a cohort came to, as the file DIR/NAME/outcome.json: patients may be evaluated by
// different programs on different machines, and are gathered from these files.

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/cohort_list.h"
#include "reconstruction/evaluation/cohort.h"

namespace glisson::cli {

struct PatientOutcome {
  std::string failure;  ///< one sentence where there are no figures
  PatientFigures figures;
};

/// Nothing where the file is not there, unreadable, or of something else: of other options, another line or another version.
/// `folder` is DIR; the entry has the flags of the command where its line leaves them empty.
std::optional<PatientOutcome> loadOutcome(const std::filesystem::path& folder, const CohortEntry& entry,
                                          const ExperimentOptions& options);
/// Makes the patient's folder where it is missing. Throws InputError.
void saveOutcome(const std::filesystem::path& folder, const CohortEntry& entry, const ExperimentOptions& options,
                 const PatientOutcome& outcome);

}  // namespace glisson::cli
