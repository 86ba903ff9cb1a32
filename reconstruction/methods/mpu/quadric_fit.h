#pragma once
// Purpose: the local shape functions of MPU implicits: quadrics fitted to the oriented points of a ball (Ohtake, Belyaev, Alexa,
// Turk, Seidel, Multi-level partition of unity implicits, SIGGRAPH 2003, section 4). The pieces with sharp edges and corners (4.3)
// are left out: an organ has none, and a voxel's stairs are not to be kept.

#include <span>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson::mpu {

struct Ball {
  Vec3 centre = Vec3::Zero();  ///< mm
  double radius = 0;           ///< mm
};

/// The weight of a ball at a distance from its centre: b(3 distance / (2 radius)) with the quadratic B-spline b [section 3], which
/// falls from 3/4 at the centre smoothly to 0 at the radius.
double weightAt(double distance, double radius);

/// y^T A y + b . y + c of y = (x - centre) / radius, about the signed distance over the radius near the surface; positive outside.
struct Quadric {
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;

  [[nodiscard]] double value(const Vec3& y) const { return y.dot(a * y) + b.dot(y) + c; }
  [[nodiscard]] Vec3 gradient(const Vec3& y) const { return 2 * (a * y) + b; }
};

/// The points of a ball, by their places in the whole cloud.
struct BallPoints {
  std::span<const Vec3> positions;  ///< of the whole cloud, mm
  std::span<const Vec3> normals;    ///< unit, outward
  std::span<const std::uint32_t> places;
};

/// The mean normal, weighted; the normal of the first point where they cancel out.
Vec3 meanNormal(const Ball& ball, const BallPoints& points);

/// A height over the plane across `up`, quadratic in both directions [4.2]: for points on one sheet.
Quadric fitHeight(const Ball& ball, const BallPoints& points, const Vec3& up);

/// A place off the surface with its signed distance, mm.
struct AuxiliaryPoint {
  Vec3 position;
  double distance = 0;
};
/// A general quadric [4.1]: 0 at the points, the distance at the auxiliary ones (one at least): for sheets that face each other.
Quadric fitGeneral(const Ball& ball, const BallPoints& points, std::span<const AuxiliaryPoint> auxiliary);

/// The greatest distance of a point of the ball to the quadric, to first order |q| / |grad q| [5], mm.
double greatestError(const Ball& ball, const BallPoints& points, const Quadric& quadric);

}  // namespace glisson::mpu
