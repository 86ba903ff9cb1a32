#include "planning/resection/resection_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "reconstruction/errors.h"

namespace glisson {

HalfSpace checkedPlane(const HalfSpace& plane) {
  const double length = plane.normal.norm();
  if (!plane.origin.allFinite() || !std::isfinite(length) || length < 1e-12) {
    throw PlanningError("The plane's origin and normal must be finite numbers and the normal must not be zero.");
  }
  return {plane.origin, plane.normal / length};
}

ResectionPlane checkedPlane(const ResectionPlane& plane) {
  const HalfSpace flat = checkedPlane(static_cast<const HalfSpace&>(plane));
  return {flat, plane.bend ? std::optional(checkedBend(flat, *plane.bend)) : std::nullopt};
}

bool hasBends(const ResectionPlan& plan) {
  return std::any_of(plan.resections.begin(), plan.resections.end(), [](const Resection& resection) {
    return std::any_of(resection.planes.begin(), resection.planes.end(),
                       [](const ResectionPlane& p) { return p.bend.has_value(); });
  });
}

HalfSpace movedAlongNormal(const HalfSpace& plane, double mm) { return {plane.origin + mm * plane.normal, plane.normal}; }

HalfSpace flipped(const HalfSpace& plane) { return {plane.origin, -plane.normal}; }

HalfSpace turned(const HalfSpace& plane, const Vec3& axis, double radians) {
  return {plane.origin, (Eigen::AngleAxisd(radians, axis.normalized()) * plane.normal).normalized()};
}

}  // namespace glisson
