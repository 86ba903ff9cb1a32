#include "planning/volumetry/convex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace glisson {

Polygon clipped(const Polygon& polygon, const ImagePlane& plane) {
  Polygon kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const Vec3& a = polygon[n];
    const Vec3& b = polygon[(n + 1) % polygon.size()];
    const double da = plane.distance(a);
    const double db = plane.distance(b);
    if (da >= 0) {
      kept.push_back(a);
    }
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      kept.push_back(a + (da / (da - db)) * (b - a));
    }
  }
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
  Polygon polygon(4, box.centre);
  for (std::size_t n = 0; n < 4; ++n) {
    polygon[n][u] += n == 1 || n == 2 ? box.half[u] : -box.half[u];
    polygon[n][v] += n >= 2 ? box.half[v] : -box.half[v];
    polygon[n][axis] -= plane.distance(polygon[n]) / plane.normal[axis];
  }
  for (const double side : {1.0, -1.0}) {
    const ImagePlane face{side * Vec3::Unit(axis), box.half[axis] - side * box.centre[axis]};
    // A section that lies in the face itself must not be lost to rounding.
    const bool onFace =
        std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& p) { return std::abs(face.distance(p)) <= kOnPlaneMm; });
    if (!onFace) {
      polygon = clipped(polygon, face);
    }
  }
  return polygon;
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
