#pragma once
// Purpose: a plan as disjoint convex parts of space, for drawing: what cannot be said with one clipping plane (a wedge, its
// complement) is said with several parts. Frame: mm LPS.

#include <vector>

#include "planning/resection/resection_plan.h"

namespace glisson {

/// The points inside all of `bounds`; their normals point into the part. No bounds: all of space.
struct PlanCell {
  PlanSide side = PlanSide::Remnant;
  std::vector<HalfSpace> bounds;
};

/// Parts that cover space once, up to their borders. A plan without planes is one part, the remnant's. Islands given to another
/// side are not cut out. A part may lie outside the liver. Throws PlanningError where a plane is bent: such parts are not convex.
std::vector<PlanCell> cellsOf(const ResectionPlan& plan);

}  // namespace glisson
