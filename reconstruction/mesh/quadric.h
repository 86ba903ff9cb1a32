#pragma once
// Purpose: the sum of squared distances to planes, weighted by area: x^T A x + 2 b.x + c, mm^4 for x in mm.
// Source: Garland, Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.

#include "reconstruction/image/image_geometry.h"

namespace glisson {

struct Quadric {
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;
  double area = 0;  ///< mm^2 of all planes together

  /// The plane through p with unit normal n.
  static Quadric ofPlane(const Vec3& n, const Vec3& p, double area) {
    const double d = -n.dot(p);
    return {area * n * n.transpose(), area * d * n, area * d * d, area};
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    area += other.area;
    return *this;
  }
  [[nodiscard]] double at(const Vec3& x) const { return x.dot(a * x) + 2 * b.dot(x) + c; }
};

}  // namespace glisson
