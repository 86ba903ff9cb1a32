#include "planning/volumetry/tumour_margin.h"

#include <cmath>

namespace glisson {

Margin marginOf(const TumourBoxes& tumour, const Vec3& spacing, const CutDistance& cut) {
  const CutDistance::Way way = cut.shortest(tumour);
  if (!std::isfinite(way.mm)) {
    return {way.mm, way.mm, way.from, way.to};
  }
  const CutPiece& piece = cut.pieces()[way.piece];
  const Vec3 along = way.mm > kOnPlaneMm ? Vec3((way.to - way.from) / way.mm) : piece.normal;
  return {way.mm, cut.atLeast(tumour, way) - resolutionMm(along, spacing), way.from, way.to};
}

double resolutionMm(const Vec3& direction, const Vec3& spacing) { return 0.5 * direction.cwiseAbs().dot(spacing); }

}  // namespace glisson
