#include "planning/resection/resection_plan.h"

#include <Eigen/Geometry>
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

HalfSpace movedAlongNormal(const HalfSpace& plane, double mm) { return {plane.origin + mm * plane.normal, plane.normal}; }

HalfSpace flipped(const HalfSpace& plane) { return {plane.origin, -plane.normal}; }

HalfSpace turned(const HalfSpace& plane, const Vec3& axis, double radians) {
  return {plane.origin, (Eigen::AngleAxisd(radians, axis.normalized()) * plane.normal).normalized()};
}

}  // namespace glisson
