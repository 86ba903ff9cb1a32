#include "planning/resection/plan_edit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "planning/resection/plan_list.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {
void requireResection(const ResectionPlan& plan, std::size_t resection) {
  if (resection >= plan.resections.size()) {
    throw PlanningError("The plan has no such resection; choose one of its resections first.");
  }
}

void requirePlane(const ResectionPlan& plan, std::size_t resection, std::size_t plane) {
  if (resection >= plan.resections.size() || plane >= plan.resections[resection].planes.size()) {
    throw PlanningError("The plan has no such plane; choose one of its resections first.");
  }
}

void requireFinite(const Vec3& point) {
  if (!point.allFinite()) {
    throw PlanningError("The point's coordinates must be finite numbers.");
  }
}

template <typename Named>
std::vector<std::string> namesOf(const std::vector<Named>& items, std::size_t without = static_cast<std::size_t>(-1)) {
  std::vector<std::string> names;
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (n != without) {
      names.push_back(items[n].name);
    }
  }
  return names;
}

template <typename Value>
void eraseAt(std::vector<Value>& values, std::size_t index) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(index));
}

/// Each edits its own copy of the plan.
struct Applier {
  ResectionPlan plan;

  void operator()(const MovePlane& edit) {
    requirePlane(plan, edit.resection, edit.plane);
    ResectionPlane& plane = plan.resections[edit.resection].planes[edit.plane];
    plane = movedTo(plane, checkedPlane(edit.to));
  }
  void operator()(const AddResection& edit) {
    if (edit.resection.planes.empty()) {
      throw PlanningError("A resection needs at least one plane; place it first.");
    }
    Resection added{edit.resection.name, {}};
    for (const ResectionPlane& plane : edit.resection.planes) {
      added.planes.push_back(checkedPlane(plane));
    }
    added.name =
        added.name.empty() ? nextName("Resection", namesOf(plan.resections)) : checkedName(added.name, namesOf(plan.resections));
    plan.resections.push_back(std::move(added));
  }
  void operator()(const RemoveResection& edit) {
    requireResection(plan, edit.resection);
    eraseAt(plan.resections, edit.resection);
  }
  void operator()(const RenameResection& edit) {
    requireResection(plan, edit.resection);
    plan.resections[edit.resection].name = checkedName(edit.name, namesOf(plan.resections, edit.resection));
  }
  void operator()(const AddPlane& edit) {
    requireResection(plan, edit.resection);
    plan.resections[edit.resection].planes.push_back(checkedPlane(edit.plane));
  }
  void operator()(const RemovePlane& edit) {
    requirePlane(plan, edit.resection, edit.plane);
    eraseAt(plan.resections[edit.resection].planes, edit.plane);
    if (plan.resections[edit.resection].planes.empty()) {
      eraseAt(plan.resections, edit.resection);
    }
  }
  void operator()(const BendPlane& edit) {
    requirePlane(plan, edit.resection, edit.plane);
    ResectionPlane& plane = plan.resections[edit.resection].planes[edit.plane];
    const Bend bend = checkedBend(plane, edit.bend);
    if (edit.origin) {
      requireFinite(*edit.origin);
      plane.origin = *edit.origin - plane.normal.dot(*edit.origin - plane.origin) * plane.normal;
    }
    plane.bend = bend;
  }
  void operator()(const SpinPlane& edit) {
    requirePlane(plan, edit.resection, edit.plane);
    const ResectionPlane& plane = plan.resections[edit.resection].planes[edit.plane];
    if (!plane.bend) {
      throw PlanningError("A flat plane is the same however it is turned about its normal; bend it first.");
    }
    Bend bend = *plane.bend;
    bend.u = edit.u;
    (*this)(BendPlane{edit.resection, edit.plane, bend, edit.origin});
  }
  void operator()(const FlattenPlane& edit) {
    requirePlane(plan, edit.resection, edit.plane);
    plan.resections[edit.resection].planes[edit.plane].bend.reset();
  }
  void operator()(const SetSafetyMargin& edit) {
    if (!(std::isfinite(edit.mm) && edit.mm >= 0)) {
      throw PlanningError("The safety margin must be a number of millimetres, 0 or more.");
    }
    plan.safetyMarginMm = edit.mm;
  }
  void operator()(const AssignIsland& edit) {
    requireFinite(edit.island.point);
    const auto same = std::find_if(plan.islands.begin(), plan.islands.end(),
                                   [&](const IslandAssignment& known) { return known.point == edit.island.point; });
    if (same != plan.islands.end()) {
      *same = edit.island;
    } else {
      plan.islands.push_back(edit.island);
    }
  }
  void operator()(const ReleaseIsland& edit) {
    std::set<std::size_t> places(edit.islands.begin(), edit.islands.end());
    if (places.empty() || *places.rbegin() >= plan.islands.size()) {
      throw PlanningError("The plan has no such assigned island; choose one of those it has.");
    }
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
      eraseAt(plan.islands, *place);
    }
  }
  void operator()(const AddMeasure& edit) {
    requireFinite(edit.measure.from);
    requireFinite(edit.measure.to);
    Measure added = edit.measure;
    added.name =
        added.name.empty() ? nextName("Distance", namesOf(plan.measures)) : checkedName(added.name, namesOf(plan.measures));
    plan.measures.push_back(std::move(added));
  }
  void operator()(const RemoveMeasure& edit) {
    if (edit.measure >= plan.measures.size()) {
      throw PlanningError("The plan has no such measured distance; choose one of those it has.");
    }
    eraseAt(plan.measures, edit.measure);
  }
};

/// The words behind Undo, of a plan before the edit.
struct Namer {
  const ResectionPlan& plan;

  [[nodiscard]] std::string resectionName(std::size_t resection) const {
    return resection < plan.resections.size() ? plan.resections[resection].name : std::string();
  }
  [[nodiscard]] bool hasOnePlane() const { return plan.resections.size() == 1 && plan.resections[0].planes.size() == 1; }

  /// As much as is needed to tell one plane from the others.
  [[nodiscard]] std::string fitting(const std::string& only, const std::string& ofOneResection,
                                    const std::string& ofSeveral) const {
    if (plan.resections.size() != 1) {
      return ofSeveral;
    }
    return hasOnePlane() ? only : ofOneResection;
  }

  std::string operator()(const MovePlane& edit) const {
    const std::string number = std::to_string(edit.plane + 1);
    return fitting("move plane", "move plane " + number, "move plane " + number + " of " + resectionName(edit.resection));
  }
  std::string operator()(const RemovePlane& edit) const {
    const std::string number = std::to_string(edit.plane + 1);
    return fitting("remove plane", "remove plane " + number, "remove plane " + number + " of " + resectionName(edit.resection));
  }
  std::string operator()(const BendPlane& edit) const {
    const std::string number = std::to_string(edit.plane + 1);
    return fitting("bend plane", "bend plane " + number, "bend plane " + number + " of " + resectionName(edit.resection));
  }
  std::string operator()(const FlattenPlane& edit) const {
    const std::string number = std::to_string(edit.plane + 1);
    return fitting("flatten plane", "flatten plane " + number, "flatten plane " + number + " of " + resectionName(edit.resection));
  }
  std::string operator()(const SpinPlane& edit) const {
    const std::string number = std::to_string(edit.plane + 1);
    return fitting("spin plane", "spin plane " + number, "spin plane " + number + " of " + resectionName(edit.resection));
  }
  std::string operator()(const AddPlane& edit) const {
    return plan.resections.size() == 1 ? "add plane" : "add plane to " + resectionName(edit.resection);
  }
  std::string operator()(const AddResection& /*edit*/) const { return "add resection"; }
  std::string operator()(const RemoveResection& edit) const { return "remove " + resectionName(edit.resection); }
  std::string operator()(const RenameResection& edit) const { return "rename " + resectionName(edit.resection); }
  std::string operator()(const SetSafetyMargin& /*edit*/) const { return "change safety margin"; }
  std::string operator()(const AssignIsland& edit) const {
    return edit.island.to == PlanSide::Resected ? "add island to the resected side" : "add island to the remnant";
  }
  std::string operator()(const ReleaseIsland& /*edit*/) const { return "give island back"; }
  std::string operator()(const AddMeasure& /*edit*/) const { return "measure distance"; }
  std::string operator()(const RemoveMeasure& /*edit*/) const { return "remove distance"; }
};
}  // namespace

ResectionPlan apply(const ResectionPlan& plan, const MovePlane& edit) { return apply(plan, PlanEdit(edit)); }

ResectionPlan apply(const ResectionPlan& plan, const PlanEdit& edit) {
  Applier applier{plan};
  std::visit(applier, edit.what);
  return std::move(applier.plan);
}

std::string nameOf(const ResectionPlan& before, const PlanEdit& edit) { return std::visit(Namer{before}, edit.what); }

}  // namespace glisson
