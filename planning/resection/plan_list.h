#pragma once
// Purpose: the edits of a case's list of plans, as pure values: list in, list out. Plans are told apart by their names, so names
// are not empty and differ. Each throws PlanningError, and leaves the list as it is, where the plan does not exist or the name will
// not do.

#include <span>
#include <string>
#include <vector>

#include "planning/resection/resection_plan.h"

namespace glisson {

using Plans = std::vector<ResectionPlan>;

/// A copy behind the plan, called `name`, or without one "Plan 1 copy", "Plan 1 copy 2", ...
Plans withDuplicate(const Plans& plans, std::size_t index, const std::string& name = {});
Plans withRenamed(const Plans& plans, std::size_t index, const std::string& name);
/// The last plan of a case is not removed.
Plans without(const Plans& plans, std::size_t index);
/// An empty plan at the end, called the next free "Plan N" where no name is given.
Plans withNew(const Plans& plans, const std::string& name = {});

/// `name` without blanks around it. Throws PlanningError where it is then empty or among `taken`.
std::string checkedName(const std::string& name, std::span<const std::string> taken);
/// "Plan 1": `stem` and the first number, from 1, that is not among `taken`.
std::string nextName(const std::string& stem, std::span<const std::string> taken);

}  // namespace glisson
