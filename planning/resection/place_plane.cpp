#include "planning/resection/place_plane.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
/// What is shorter than this, in mm or as a sine, has no direction.
constexpr double kLeast = 1e-9;
}  // namespace

HalfSpace planeFromCamera(const Vec3& point, const Vec3& viewDirection, const Vec3& viewUp) {
  const Vec3 right = viewDirection.cross(viewUp);
  if (!(right.norm() > kLeast)) {
    throw PlanningError("The camera looks along its own up direction; turn the view first.");
  }
  return checkedPlane(HalfSpace{point, right});
}

HalfSpace planeThroughPoints(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  // The height of the triangle over its longest side: what it takes to say how the plane is turned.
  constexpr double kLeastHeightMm = 1e-3;
  if (!(normal.norm() > kLeastHeightMm * longest)) {
    throw PlanningError("The three points lie on one line, so they give no plane; click one of them elsewhere.");
  }
  return checkedPlane(HalfSpace{(a + b + c) / 3, normal});
}

HalfSpace planeOfLine(const Vec3& a, const Vec3& b, const Vec3& viewDirection) {
  const Vec3 normal = viewDirection.normalized().cross(b - a);
  if (!(normal.norm() > kLeast)) {
    throw PlanningError("The line has no length in the view, so it gives no plane; draw it again across the liver.");
  }
  return checkedPlane(HalfSpace{0.5 * (a + b), normal});
}

HalfSpace planeOfLineFromEye(const Vec3& a, const Vec3& b, const Vec3& eye) { return planeOfLine(a, b, 0.5 * (a + b) - eye); }

std::string_view idOf(SlicePlane slice) {
  switch (slice) {
    case SlicePlane::Axial:
      return "axial";
    case SlicePlane::Coronal:
      return "coronal";
    case SlicePlane::Sagittal:
      break;
  }
  return "sagittal";
}

HalfSpace planeParallelToSlice(const ImageGeometry& geometry, SlicePlane slice, const Vec3& point) {
  const Eigen::Index world = slice == SlicePlane::Axial ? 2 : slice == SlicePlane::Coronal ? 1 : 0;
  const auto axis = static_cast<Eigen::Index>(nearestIndexAxes(geometry.direction)[static_cast<std::size_t>(world)]);
  const Vec3 normal = geometry.direction.col(axis);
  return checkedPlane(HalfSpace{point, normal[world] < 0 ? Vec3(-normal) : normal});
}

}  // namespace glisson
