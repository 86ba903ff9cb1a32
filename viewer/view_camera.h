#pragma once
// Purpose: the 3D view's camera as plain numbers: world mm LPS <-> logical pixels of the widget (y down). Perspective.

#include <Eigen/Core>
#include <numbers>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

using Pixel = Eigen::Vector2d;

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< in radians

struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< unit
};

/// Where the camera stands. Poses are equal where no picture could tell them apart: VTK normalises `up` whenever it is set, which
/// may change its last bit.
struct Pose {
  Vec3 position = Vec3::Zero();
  Vec3 focus = Vec3::Zero();
  Vec3 up = Vec3::UnitZ();
  bool operator==(const Pose& other) const;
};

struct ViewCamera {
  Vec3 position = Vec3::Zero();
  Vec3 forward = Vec3::UnitY();  ///< unit
  Vec3 up = Vec3::UnitZ();       ///< unit, perpendicular to forward
  double viewAngle = 0.5;        ///< vertical, radians
  double width = 1;              ///< logical pixels
  double height = 1;

  [[nodiscard]] Vec3 right() const;
  /// Where a world point is seen. Points behind the camera give pixels far outside.
  [[nodiscard]] Pixel toPixel(const Vec3& world) const;
  /// The line of sight through a pixel.
  [[nodiscard]] Ray rayAt(const Pixel& pixel) const;
  /// Length in mm of one pixel in the plane through `world` parallel to the picture.
  [[nodiscard]] double mmPerPixel(const Vec3& world) const;
};

}  // namespace glisson
