#pragma once
// Purpose: the edits of one plan as pure values: apply(plan, edit) -> plan. The undo step keeps the plan before and after, and is
// called what nameOf() says. Every edit throws PlanningError, and leaves the plan as it is, where what it names does not exist or
// what it brings is not finite.

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "planning/resection/resection_plan.h"

namespace glisson {

/// One plane elsewhere; its normal is made unit, its bend goes along (movedTo()).
struct MovePlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
  HalfSpace to;
};
/// A resection of one or more planes; without a name it gets the next free "Resection N".
struct AddResection {
  Resection resection;
};
struct RemoveResection {
  std::size_t resection = 0;
};
/// Names of resections are not empty and differ within a plan.
struct RenameResection {
  std::size_t resection = 0;
  std::string name;
};
struct AddPlane {
  std::size_t resection = 0;
  ResectionPlane plane;
};
/// With its last plane a resection goes too.
struct RemovePlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
};
/// One plane bent so, whether it was bent or not.
struct BendPlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
  Bend bend;
  std::optional<Vec3> origin{};  ///< mm LPS: the middle of the square, moved into the plane; else the plane's origin as it is
};
/// A bent plane becomes the plane again.
struct FlattenPlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
};
/// A bent plane turned about its normal (spun()): where u of its bend and its origin, moved into the plane, are then.
struct SpinPlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
  Vec3 u = Vec3::UnitX();
  Vec3 origin = Vec3::Zero();
};
/// 0 mm or more.
struct SetSafetyMargin {
  double mm = 0;
};
/// An assignment of the same point takes the place of the one before.
struct AssignIsland {
  IslandAssignment island;
};
/// Takes assignments back, by their places in the plan.
struct ReleaseIsland {
  std::vector<std::size_t> islands;
};
/// Without a name it gets the next free "Distance N".
struct AddMeasure {
  Measure measure;
};
struct RemoveMeasure {
  std::size_t measure = 0;
};

using AnyEdit = std::variant<MovePlane, AddResection, RemoveResection, RenameResection, AddPlane, RemovePlane, BendPlane,
                             FlattenPlane, SpinPlane, SetSafetyMargin, AssignIsland, ReleaseIsland, AddMeasure, RemoveMeasure>;
/// Any of them. A class of its own: std::apply must not be found beside apply().
struct PlanEdit {
  template <typename Edit>
  requires std::constructible_from<AnyEdit, Edit> PlanEdit(Edit edit) : what(std::move(edit)) {}  // every edit is one

  AnyEdit what;
};

ResectionPlan apply(const ResectionPlan& plan, const MovePlane& edit);
ResectionPlan apply(const ResectionPlan& plan, const PlanEdit& edit);

/// "move plane 2", in lower case, as it stands behind Undo. Numbers count from 1 and stand only where the plan before the edit has
/// more than one.
std::string nameOf(const ResectionPlan& before, const PlanEdit& edit);

}  // namespace glisson
