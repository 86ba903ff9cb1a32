#include "planning/volumetry/convex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace glisson {

namespace {
/// Calls keep(corner) for the corners of the polygon's part with distance >= 0.
template <typename Keep>
void clip(std::span<const Vec3> polygon, const ImagePlane& plane, const Keep& keep) {
  double da = polygon.empty() ? 0.0 : plane.distance(polygon[0]);
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const Vec3& a = polygon[n];
    const Vec3& b = polygon[(n + 1) % polygon.size()];
    const double db = plane.distance(b);
    if (da >= 0) {
      keep(a);
    }
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      keep(a + (da / (da - db)) * (b - a));
    }
    da = db;
  }
}

/// A quadrangle that is clipped twice: made without asking for memory.
struct FewCorners {
  std::array<Vec3, 12> corners;  ///< no more than 9, with rounding
  std::size_t count = 0;
  [[nodiscard]] std::span<const Vec3> all() const { return {corners.data(), count}; }
};
}  // namespace

Polygon clipped(const Polygon& polygon, const ImagePlane& plane) {
  Polygon kept;
  kept.reserve(polygon.size() + 1);
  clip(polygon, plane, [&](const Vec3& corner) { kept.push_back(corner); });
  return kept.size() < 3 ? Polygon() : kept;
}

double areaOf(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t n = 2; n < polygon.size(); ++n) {
    sum += (polygon[n - 1] - polygon[0]).cross(polygon[n] - polygon[0]);
  }
  return 0.5 * sum.norm();
}

Polygon sectionOf(const Box& box, const ImagePlane& plane) {
  const double distance = plane.distance(box.centre);
  if (std::abs(distance) > plane.support(box.half) + kOnPlaneMm) {
    return {};
  }
  // Along the axis of the largest normal component the plane is a graph over the other two: clip the box's footprint there.
  Eigen::Index axis = 0;
  plane.normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index u = (axis + 1) % 3;
  const Eigen::Index v = (axis + 2) % 3;
  FewCorners section{{box.centre, box.centre, box.centre, box.centre}, 4};
  for (std::size_t n = 0; n < 4; ++n) {
    Vec3& corner = section.corners[n];
    corner[u] += n == 1 || n == 2 ? box.half[u] : -box.half[u];
    corner[v] += n >= 2 ? box.half[v] : -box.half[v];
    corner[axis] -= plane.distance(corner) / plane.normal[axis];
  }
  for (const double side : {1.0, -1.0}) {
    const ImagePlane face{side * Vec3::Unit(axis), box.half[axis] - side * box.centre[axis]};
    // A section that lies in the face itself must not be lost to rounding.
    const std::span<const Vec3> before = section.all();
    const bool onFace =
        std::all_of(before.begin(), before.end(), [&](const Vec3& p) { return std::abs(face.distance(p)) <= kOnPlaneMm; });
    if (!onFace) {
      FewCorners kept;
      clip(before, face, [&](const Vec3& corner) { kept.corners[kept.count++] = corner; });
      section.corners = kept.corners;
      section.count = kept.count < 3 ? 0 : kept.count;
    }
  }
  return {section.all().begin(), section.all().end()};
}

Coplanar coplanar(const ImagePlane& a, const ImagePlane& b, const Vec3& point, double reach) {
  const double way = a.normal.dot(b.normal) > 0 ? 1 : -1;
  const double turn = (a.normal - way * b.normal).norm() * reach;
  const double shift = std::abs(a.distance(point) - way * b.distance(point));
  if (turn + shift > kOnPlaneMm) {
    return Coplanar::No;
  }
  return way > 0 ? Coplanar::Same : Coplanar::Opposite;
}

double volumeOf(const Box& box, std::span<const ImagePlane> planes) {
  std::vector<ImagePlane> sides;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      sides.push_back({side * Vec3::Unit(axis), box.half[axis] - side * box.centre[axis]});
    }
  }
  sides.insert(sides.end(), planes.begin(), planes.end());
  const double reach = 2 * box.half.norm();
  const Box larger{box.centre, 2 * box.half};
  double sum = 0;
  for (std::size_t n = 0; n < sides.size(); ++n) {
    Polygon face = sectionOf(larger, sides[n]);
    for (std::size_t m = 0; m < sides.size() && !face.empty(); ++m) {
      const Coplanar same = m == n ? Coplanar::No : coplanar(sides[n], sides[m], box.centre, reach);
      if (same == Coplanar::Opposite) {
        return 0;
      }
      if (same == Coplanar::Same ? m < n : false) {
        face.clear();  // two half-spaces share this face: the first one has it
      } else if (m != n && same == Coplanar::No) {
        face = clipped(face, sides[m]);
      }
    }
    sum += areaOf(face) * sides[n].distance(box.centre);
  }
  return std::max(sum / 3, 0.0);
}

}  // namespace glisson
