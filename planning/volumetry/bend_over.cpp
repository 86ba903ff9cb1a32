#include "planning/volumetry/bend_over.h"

#include <Eigen/Geometry>
#include <cmath>

#include "planning/volumetry/resected.h"

namespace glisson {

ResectionPlane bendOver(const LiverVoxels& liver, const HalfSpace& plane) {
  constexpr double kUnknownMm = 100;
  constexpr double kBeyond = 1.05;
  ResectionPlane bent = checkedPlane(plane);
  bent.bend = flatBend(bent, kUnknownMm);
  const Vec3 u = bent.bend->u;
  const Vec3 v = bent.normal.cross(u);
  Eigen::AlignedBox2d cut;
  const std::vector<ImageResection> flat{{{toImage(plane, liver.geometry)}}};
  for (const CutPiece& piece : cutSurface(rowsOf(liver.liver), liver.geometry.spacing, flat)) {
    for (const Vec3& p : piece.polygon) {
      const Vec3 from = liver.geometry.origin + liver.geometry.direction * p - bent.origin;
      cut.extend(Eigen::Vector2d(u.dot(from), v.dot(from)));
    }
  }
  if (cut.isEmpty()) {
    return bent;
  }
  bent.origin += cut.center().x() * u + cut.center().y() * v;
  bent.bend->halfSizeMm = std::clamp(std::ceil(0.5 * kBeyond * cut.sizes().maxCoeff()), kLeastBendHalfSizeMm, kMostBendMm);
  return bent;
}

}  // namespace glisson
