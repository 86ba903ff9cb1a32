#pragma once
// Purpose: plane geometry that pictures and pointers need.

#include <Eigen/Core>
#include <algorithm>

namespace glisson {

/// From a point to the nearest one of the segment from a to b, in their unit.
inline double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

}  // namespace glisson
