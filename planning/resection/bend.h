#pragma once
// Purpose: a resection plane that can be bent: a height field over it, the tensor-product cubic Bezier surface of 4x4 control
// points. Frame: mm LPS. With v = normal x u, the control points stand over the points (i, j) / 3 of the square of 2 x halfSizeMm
// around the plane's origin, so heights of 0 are the plane itself. Beside the square the surface goes on without a kink and levels
// out: d beyond the border the height is that of the cubic at d - d^2 / (2 w) beyond it, w = kBendEase x halfSizeMm, and from w on
// at w / 2; so it stands still from there. Resected is {p : normal . (p - origin) >= h(u, v)}. The bounds follow from the control
// points: a Bezier surface lies in their hull. Source: G. Farin, Curves and Surfaces for CAGD, 2002. Throws PlanningError where a
// bend is no such surface.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "reconstruction/mesh/cut.h"

namespace glisson {

struct Bend {
  Vec3 u = Vec3::UnitX();  ///< unit, within the plane
  double halfSizeMm = 100;
  std::array<double, 16> heightsMm{};  ///< along the normal; [4 j + i] at u = halfSize (2 i / 3 - 1), v = halfSize (2 j / 3 - 1)
  bool operator==(const Bend&) const = default;
};

/// Which height is which, for files that leave the program.
inline constexpr const char* kBendOrder = "[4 j + i]: i along u, j along v";

inline constexpr double kLeastBendHalfSizeMm = 10;
inline constexpr double kMostBendMm = 1000;  ///< of half size and heights
/// Over which width beside the square the surface levels out, as a share of the half size.
inline constexpr double kBendEase = 1.0 / 3;

/// A plane of a resection; one without a bend is flat, and a HalfSpace is one.
struct ResectionPlane : HalfSpace {
  ResectionPlane() = default;
  ResectionPlane(const HalfSpace& plane, std::optional<Bend> bent = {})
      : HalfSpace(plane), bend(std::move(bent)) {}  // a flat plane is one
  ResectionPlane(const Vec3& at, const Vec3& towards) : HalfSpace{at, towards} {}

  std::optional<Bend> bend;
  bool operator==(const ResectionPlane&) const = default;
};

struct Range {
  double low = 0;
  double high = 0;
  [[nodiscard]] double most() const { return std::max(-low, high); }
};

/// The heights as a function of u and v, mm. Cheap to evaluate, some hundred bytes.
class BendShape {
 public:
  explicit BendShape(const Bend& bend);

  [[nodiscard]] double height(double u, double v) const {
    const double s = parameter(u);
    const double t = parameter(v);
    const double* p = power_.data();
    const auto along = [s](const double* c) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); };
    return along(p) + t * (along(p + 4) + t * (along(p + 8) + t * along(p + 12)));
  }
  struct Local {
    double height = 0;
    double du = 0;  ///< slopes, without unit
    double dv = 0;
    double duu = 0;  ///< 1/mm; they jump at the square's border
    double duv = 0;
    double dvv = 0;
  };
  [[nodiscard]] Local at(double u, double v) const;

  /// Of the control points; the heights over the square are within.
  [[nodiscard]] const Range& heights() const { return heights_; }
  /// What bounds the slopes everywhere; holds 0.
  [[nodiscard]] const Range& slopesU() const { return slopesU_; }
  [[nodiscard]] const Range& slopesV() const { return slopesV_; }
  /// The largest second derivative in any direction is at most this, 1/mm: over the square, and everywhere.
  [[nodiscard]] double mostCurvedInside() const { return mostCurvedInside_; }
  [[nodiscard]] double mostCurved() const { return mostCurved_; }
  [[nodiscard]] double halfSizeMm() const { return halfSizeMm_; }

 private:
  /// The cubic's parameter at a place along u or v: 0..1 over the square, and kBendEase / 4 beyond that far beside it.
  [[nodiscard]] double parameter(double mm) const {
    const double beyond = std::abs(mm) - halfSizeMm_;
    if (!(beyond > 0)) {
      return 0.5 + perMm_ * mm;
    }
    const double width = kBendEase * halfSizeMm_;
    const double d = std::min(beyond, width);
    return 0.5 + perMm_ * std::copysign(halfSizeMm_ + d * (1 - 0.5 * d / width), mm);
  }

  double perMm_ = 0;  ///< from mm to the square's parameter, 0..1
  double halfSizeMm_ = 0;
  std::array<double, 16> power_{};  ///< [4 l + k] of t^l s^k
  Range heights_;
  Range slopesU_;
  Range slopesV_;
  double mostCurvedInside_ = 0;
  double mostCurved_ = 0;
};

/// A bent plane ready to be evaluated at many points, in the world or, by inFrame(), in an image's frame. Const and thread-safe.
class BentSurface {
 public:
  /// Throws PlanningError where the plane has no bend.
  explicit BentSurface(const ResectionPlane& plane);
  /// The same in the frame p = direction^T (world - origin), an isometry that may mirror.
  [[nodiscard]] BentSurface inFrame(const ImageGeometry& geometry) const;

  /// Millimetres above the surface along the normal: >= 0 is resected. Zero exactly on the surface, and no distance elsewhere.
  [[nodiscard]] double above(const Vec3& p) const {
    const Vec3 from = p - origin_;
    return normal_.dot(from) - shape_.height(u_.dot(from), v_.dot(from));
  }
  /// The surface's point over or under `p`.
  [[nodiscard]] Vec3 foot(const Vec3& p) const { return p - above(p) * normal_; }
  /// The plane that touches the surface at foot(p).
  [[nodiscard]] HalfSpace tangentAt(const Vec3& p) const;
  [[nodiscard]] BendShape::Local localAt(const Vec3& p) const { return shape_.at(u_.dot(p - origin_), v_.dot(p - origin_)); }
  /// How far above() can be from its value at a box's centre, anywhere in the box of these half extents along the frame's axes.
  [[nodiscard]] double reach(const Vec3& half) const;

  [[nodiscard]] const Vec3& origin() const { return origin_; }
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  [[nodiscard]] const Vec3& u() const { return u_; }
  [[nodiscard]] const Vec3& v() const { return v_; }
  [[nodiscard]] const BendShape& shape() const { return shape_; }

 private:
  Vec3 origin_;
  Vec3 normal_;
  Vec3 u_;
  Vec3 v_;
  BendShape shape_;
};

/// Above `plane`, bent or not: >= 0 is resected. Many points: make a BentSurface.
double heightAbove(const ResectionPlane& plane, const Vec3& p);

/// A flat start: heights 0, u the LPS axis that is most nearly in the plane (of equal ones the first), projected into it.
Bend flatBend(const HalfSpace& plane, double halfSizeMm);
/// The bend with its u made unit and perpendicular to the plane's normal. Throws PlanningError where a number is not finite, the
/// half size is not from 10 to 1000 mm, a height is beyond 1000 mm, or u has no direction within the plane.
Bend checkedBend(const HalfSpace& plane, const Bend& bend);
/// Where control point [4 j + i] stands, mm LPS. The plane has a bend.
Vec3 controlPoint(const ResectionPlane& plane, std::size_t index);
/// Whether one unit normal is the other's opposite, as far as numbers rounded to 3 decimals say.
bool isOpposite(const Vec3& normal, const Vec3& other);
/// `from` with origin and normal of `to`: its bend goes along, u turned by the smallest rotation from normal to normal. Opposite
/// normals swap the sides and leave the surface where it is, seen from the plane, but for the small rest of the turn.
ResectionPlane movedTo(const ResectionPlane& from, const HalfSpace& to);
/// Turned by `radians` about the axis along its normal through `pivot`, right-handed: its square turns along. A flat plane is the
/// same however it is turned.
ResectionPlane spun(const ResectionPlane& plane, const Vec3& pivot, double radians);
/// The other side resected; the surface stays.
ResectionPlane flipped(const ResectionPlane& plane);

/// The control points of one group with point `index`: the 4 corners, the 8 others on the border, or the 4 inner ones.
std::array<bool, 16> groupOf(std::size_t index);

}  // namespace glisson
