#pragma once
// Purpose: what is to be resected. A resection is the intersection of its planes' half-spaces; a plan is the union of its
// resections. Frame: mm LPS. A plane's unit normal points to the RESECTED side.

#include <string>
#include <vector>

#include "reconstruction/mesh/cut.h"

namespace glisson {

struct Resection {
  std::string name;               ///< "Resection 1"
  std::vector<HalfSpace> planes;  ///< resected = inside all of them
};

struct ResectionPlan {
  std::string name;  ///< "Plan 1"
  std::vector<Resection> resections;
  double safetyMarginMm = 10.0;
};

/// One edit of a plane: a pure value. The undo step keeps the plan before and after.
struct MovePlane {
  std::size_t resection = 0;
  std::size_t plane = 0;
  HalfSpace to;
};
/// Throws PlanningError where the indices do not exist or the normal is not finite and non-zero; the normal is made unit.
ResectionPlan apply(const ResectionPlan& plan, const MovePlane& edit);

/// Translates along the plane's own normal (mm), or within the plane.
HalfSpace movedAlongNormal(const HalfSpace& plane, double mm);
/// Turned by `radians` about a world axis through the plane's origin.
HalfSpace turned(const HalfSpace& plane, const Vec3& axis, double radians);

/// The first plane as the user sees it: through the liver's centre `centre`, its normal to the right of the picture seen from the
/// camera (perpendicular to view direction and up), so the cut is seen edge-on. Throws PlanningError where direction and up are
/// parallel.
HalfSpace planeFromCamera(const Vec3& centre, const Vec3& viewDirection, const Vec3& viewUp);

}  // namespace glisson
