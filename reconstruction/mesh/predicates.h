#pragma once
// Purpose: on which side of a line or plane a point lies, exact for every finite double (short of underflow).
// A floating-point filter answers most calls; the rest is summed exactly as an expansion of doubles.
// Source: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997.

#include <Eigen/Core>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

using Vec2 = Eigen::Vector2d;

/// +1 where a, b, c turn counter-clockwise, -1 clockwise, 0 on one line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// +1 where d lies on the side of the plane a, b, c that its counter-clockwise normal points to, -1 on the other, 0 on the plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// True where d lies inside the circle through a, b, c (counter-clockwise) beyond any doubt of rounding. Not exact: it only picks
/// between two valid triangulations.
bool surelyInCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

}  // namespace glisson
