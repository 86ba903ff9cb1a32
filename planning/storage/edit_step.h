#pragma once
// Purpose: the undo records of the case file: what each edit replaced, of whatever kind it was, and which of them stand.

#include <optional>
#include <string>
#include <vector>

#include "planning/case/patient_facts.h"
#include "planning/case/structure_state.h"
#include "planning/case/territory_marks.h"
#include "planning/resection/resection_plan.h"

namespace glisson {

template <typename Value>
struct Change {
  Value before;
  Value after;
  bool operator==(const Change&) const = default;
};

/// The undo record of one edit: of the plans, or of what the last three hold, of which there is at most one.
struct EditStep {
  std::string name;  ///< "move plane 2"; empty where the edit had none or takes one back, and in records of version 1
  std::vector<ResectionPlan> before;
  std::vector<ResectionPlan> after;
  std::optional<Change<PatientFacts>> patient{};  ///< the plans stayed as they were; so with those that follow
  std::optional<Change<TerritoryMarks>> territories{};
  /// Of the structures that the edit changed, in the same order.
  std::optional<Change<std::vector<StructureState>>> structures{};
  bool operator==(const EditStep&) const = default;
};

/// The edits that stand, oldest first. An undo is recorded as an edit without a name that leads back: it and what it took back are
/// left out. So is what changes nothing, which an older program made of an edit it does not know.
std::vector<EditStep> standingEdits(std::vector<EditStep> records);

}  // namespace glisson
