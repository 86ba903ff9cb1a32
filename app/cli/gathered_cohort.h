#pragma once
// Purpose: what cohort.csv, cohort.json and cohort.html say a cohort came to.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cohort_outcome.h"

namespace glisson::cli {

enum class PatientState : std::uint8_t { Evaluated, Failed, Missing };

struct GatheredPatient {
  CohortEntry entry;
  std::optional<PatientOutcome> outcome;  ///< nothing where the patient has no result

  [[nodiscard]] PatientState state() const {
    return !outcome ? PatientState::Missing : outcome->failure.empty() ? PatientState::Evaluated : PatientState::Failed;
  }
};

struct GatheredCohort {
  std::string list;  ///< the list's file without its folder, so that a run elsewhere writes the same bytes
  ExperimentOptions options;
  std::vector<GatheredPatient> patients;  ///< in the list's order
  CohortStatistics statistics;            ///< of those that were evaluated

  [[nodiscard]] std::size_t count(PatientState state) const;
};

/// "evaluated", "failed", "missing": for files.
std::string_view stateId(PatientState state);
/// One sentence that names the patient: why it failed, or that it has no result, and the way out. The patient was not evaluated.
std::string sentenceOf(const GatheredPatient& patient, const std::string& list);

}  // namespace glisson::cli
