#include "planning/resection/resection_plan.h"

#include <Eigen/Geometry>

#include "reconstruction/errors.h"

namespace glisson {

ResectionPlan apply(const ResectionPlan& plan, const MovePlane& edit) {
  if (edit.resection >= plan.resections.size() || edit.plane >= plan.resections[edit.resection].planes.size()) {
    throw PlanningError("The plan has no such plane; choose one of its resections first.");
  }
  const double length = edit.to.normal.norm();
  if (!edit.to.origin.allFinite() || !std::isfinite(length) || length < 1e-12) {
    throw PlanningError("The plane's origin and normal must be finite numbers and the normal must not be zero.");
  }
  ResectionPlan edited = plan;
  edited.resections[edit.resection].planes[edit.plane] = {edit.to.origin, edit.to.normal / length};
  return edited;
}

HalfSpace movedAlongNormal(const HalfSpace& plane, double mm) { return {plane.origin + mm * plane.normal, plane.normal}; }

HalfSpace turned(const HalfSpace& plane, const Vec3& axis, double radians) {
  return {plane.origin, (Eigen::AngleAxisd(radians, axis.normalized()) * plane.normal).normalized()};
}

HalfSpace planeFromCamera(const Vec3& centre, const Vec3& viewDirection, const Vec3& viewUp) {
  const Vec3 right = viewDirection.cross(viewUp);
  if (!(right.norm() > 1e-9)) {
    throw PlanningError("The camera looks along its own up direction; turn the view first.");
  }
  return {centre, right.normalized()};
}

}  // namespace glisson
