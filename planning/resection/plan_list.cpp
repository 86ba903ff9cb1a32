#include "planning/resection/plan_list.h"

#include <algorithm>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
void require(const Plans& plans, std::size_t index) {
  if (index >= plans.size()) {
    throw PlanningError("The case has no such plan; choose one of its plans first.");
  }
}

std::vector<std::string> namesWithout(const Plans& plans, std::size_t index) {
  std::vector<std::string> names;
  for (std::size_t n = 0; n < plans.size(); ++n) {
    if (n != index) {
      names.push_back(plans[n].name);
    }
  }
  return names;
}

std::vector<std::string> namesOf(const Plans& plans) { return namesWithout(plans, plans.size()); }

bool isTaken(const std::string& name, std::span<const std::string> taken) {
  return std::find(taken.begin(), taken.end(), name) != taken.end();
}
}  // namespace

std::string checkedName(const std::string& name, std::span<const std::string> taken) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = name.find_first_not_of(kBlanks);
  if (first == std::string::npos) {
    throw PlanningError("A name cannot be empty; type another one.");
  }
  std::string kept = name.substr(first, name.find_last_not_of(kBlanks) - first + 1);
  if (isTaken(kept, taken)) {
    throw PlanningError("The name \"" + kept + "\" is taken; type another one.");
  }
  return kept;
}

std::string nextName(const std::string& stem, std::span<const std::string> taken) {
  for (std::size_t number = 1;; ++number) {
    std::string name = stem + " " + std::to_string(number);
    if (!isTaken(name, taken)) {
      return name;
    }
  }
}

Plans withDuplicate(const Plans& plans, std::size_t index, const std::string& name) {
  require(plans, index);
  const std::vector<std::string> taken = namesOf(plans);
  ResectionPlan copy = plans[index];
  if (!name.empty()) {
    copy.name = checkedName(name, taken);
  } else {
    copy.name = plans[index].name + " copy";
    for (std::size_t number = 2; isTaken(copy.name, taken); ++number) {
      copy.name = plans[index].name + " copy " + std::to_string(number);
    }
  }
  Plans edited = plans;
  edited.insert(edited.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(copy));
  return edited;
}

Plans withRenamed(const Plans& plans, std::size_t index, const std::string& name) {
  require(plans, index);
  Plans edited = plans;
  edited[index].name = checkedName(name, namesWithout(plans, index));
  return edited;
}

Plans without(const Plans& plans, std::size_t index) {
  require(plans, index);
  if (plans.size() == 1) {
    throw PlanningError("A case keeps at least one plan; make another one before this one is deleted.");
  }
  Plans edited = plans;
  edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(index));
  return edited;
}

Plans withNew(const Plans& plans, const std::string& name) {
  ResectionPlan added;
  added.name = name.empty() ? nextName("Plan", namesOf(plans)) : checkedName(name, namesOf(plans));
  Plans edited = plans;
  edited.push_back(std::move(added));
  return edited;
}

}  // namespace glisson
