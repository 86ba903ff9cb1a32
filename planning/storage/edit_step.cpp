#include "planning/storage/edit_step.h"

#include <utility>

namespace glisson {

namespace {
/// Both are edits of the same kind, and `undo` ends where `step` began.
bool leadsBack(const EditStep& undo, const EditStep& step) {
  const auto meets = [](const auto& back, const auto& forth) { return back && forth && forth->before == back->after; };
  if (undo.patient || step.patient) {
    return meets(undo.patient, step.patient);
  }
  if (undo.territories || step.territories) {
    return meets(undo.territories, step.territories);
  }
  if (undo.structures || step.structures) {
    return meets(undo.structures, step.structures);
  }
  return step.before == undo.after;
}

bool changesNothing(const EditStep& step) {
  return !step.patient && !step.territories && !step.structures && step.before == step.after;
}
}  // namespace

std::vector<EditStep> standingEdits(std::vector<EditStep> records) {
  std::vector<EditStep> standing;
  for (EditStep& record : records) {
    if (changesNothing(record)) {
      continue;
    }
    if (record.name.empty() && !standing.empty() && leadsBack(record, standing.back())) {
      standing.pop_back();
    } else {
      standing.push_back(std::move(record));
    }
  }
  return standing;
}

}  // namespace glisson
