#include "app/cli/gathered_cohort.h"

#include <algorithm>

namespace glisson::cli {

std::size_t GatheredCohort::count(PatientState state) const {
  return static_cast<std::size_t>(std::count_if(patients.begin(), patients.end(),
                                                [state](const GatheredPatient& patient) { return patient.state() == state; }));
}

std::string_view stateId(PatientState state) {
  switch (state) {
    case PatientState::Evaluated:
      return "evaluated";
    case PatientState::Failed:
      return "failed";
    case PatientState::Missing:
      break;
  }
  return "missing";
}

std::string sentenceOf(const GatheredPatient& patient, const std::string& list) {
  const std::string who = patient.entry.name + " (line " + std::to_string(patient.entry.line) + " of " + list + ")";
  if (patient.outcome) {
    return who + ": " + patient.outcome->failure;
  }
  return who + " has no result with these parameters; run it again with --task " + std::to_string(patient.entry.number);
}

}  // namespace glisson::cli
