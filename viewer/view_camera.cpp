#include "viewer/view_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace glisson {

namespace {
constexpr double kNearestMm = 1e-3;
}

bool Pose::operator==(const Pose& other) const {
  constexpr double kTold = 1e-9;  // mm, and of the length of `up`
  return (position - other.position).norm() <= kTold && (focus - other.focus).norm() <= kTold && (up - other.up).norm() <= kTold;
}

Vec3 ViewCamera::right() const { return forward.cross(up).normalized(); }

Pixel ViewCamera::toPixel(const Vec3& world) const {
  const Vec3 offset = world - position;
  const double perMm = 1.0 / mmPerPixel(world);
  return {0.5 * width + offset.dot(right()) * perMm, 0.5 * height - offset.dot(up) * perMm};
}

Ray ViewCamera::rayAt(const Pixel& pixel) const {
  const double tangentPerPixel = 2.0 * std::tan(0.5 * viewAngle) / height;
  const Vec3 direction =
      forward + (pixel.x() - 0.5 * width) * tangentPerPixel * right() - (pixel.y() - 0.5 * height) * tangentPerPixel * up;
  return {position, direction.normalized()};
}

double ViewCamera::mmPerPixel(const Vec3& world) const {
  const double depth = std::max((world - position).dot(forward), kNearestMm);
  return 2.0 * depth * std::tan(0.5 * viewAngle) / height;
}

}  // namespace glisson
