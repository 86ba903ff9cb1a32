#pragma once
// Purpose: where a plane begins to be bent: the square of the control points over its cut through the liver. Frame: mm LPS.

#include "planning/case/case.h"

namespace glisson {

/// The same plane with a bend of heights 0. Its origin is moved within the plane to the middle of the rectangle around the cut of L
/// (along u and v), and the square reaches 5 % beyond that rectangle. A plane beside the liver keeps its origin and gets a square
/// of 200 mm. Throws PlanningError where the plane is not finite.
ResectionPlane bendOver(const LiverVoxels& liver, const HalfSpace& plane);

}  // namespace glisson
