#pragma once
// Purpose: the cube that is divided, the depth in use and the level on which V lives (method.md 2).

#include "reconstruction/image/image_geometry.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson::poisson {

struct Frame {
  Vec3 corner = Vec3::Zero();  ///< low corner of the cube, mm LPS
  double cellMm = 0;           ///< cell of the finest level
  int depth = 0;
  int kernelLevel = 0;
  int densityLevel = 0;  ///< the finest, up to kernelLevel, whose cells are no narrower than the widest spacing

  [[nodiscard]] double cellMmOf(int level) const { return cellMm * (1 << (depth - level)); }
  /// Cells of the level below the finest are narrower than the slices lie apart: some between the slices hold no `paper` sample.
  [[nodiscard]] bool hasEmptyCells() const { return densityLevel < depth - 1; }
};

/// The cube is scale x the samples' largest extent, with room for the kernel around tiny bodies. Depth and kernel are kept from
/// cells far below the sample spacing, which would tear small bodies apart.
Frame chooseFrame(const OrientedPoints& points, const ImageGeometry& geometry, const PoissonParameters& parameters);

}  // namespace glisson::poisson
