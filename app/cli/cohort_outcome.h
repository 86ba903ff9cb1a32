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

/// What an outcome is of.
struct OutcomeSubject {
  const CohortEntry& entry;  ///< with the flags of the command where its line leaves them empty
  const ExperimentOptions& options;
  const std::vector<ModelRecipe>& recipes;
};

/// Nothing where the file is not there, unreadable, or of something else: of other options or methods, another line or another
/// version. `folder` is DIR.
std::optional<PatientOutcome> loadOutcome(const std::filesystem::path& folder, const OutcomeSubject& subject);
/// Before the patient is evaluated anew: whatever becomes of that, the former outcome does not stand for it. Throws InputError.
void removeOutcome(const std::filesystem::path& folder, const CohortEntry& entry);
/// Makes the patient's folder where it is missing. Throws InputError.
void saveOutcome(const std::filesystem::path& folder, const OutcomeSubject& subject, const PatientOutcome& outcome);

}  // namespace glisson::cli
