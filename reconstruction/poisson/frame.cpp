#include "reconstruction/poisson/frame.h"

#include <algorithm>

#include "reconstruction/poisson/hierarchy.h"

namespace glisson::poisson {

namespace {
constexpr double kPaddingVoxels = 2;  // around tiny bodies, where scale x extent would leave no room for the kernel
// Faces are spread over the kernel's cells, so a cell of half a slice is as fine as they carry; points are not, and their error
// falls down to a quarter (paper error of a liver at d=9: 0.275 mm with half a slice, 0.221 with a quarter).
constexpr double kLeastKernelOfFaces = 0.5;  // of the widest spacing
constexpr double kLeastKernelOfPoints = 0.25;
// Narrower cells count the points of one slice here and none there (paper error of the same liver at d=8: at most 3.52 mm, and
// 3.18 mm where each cell sees two slices; wider ones blur the density at d=5 and 6).
constexpr double kLeastDensityCell = 1.0;
}  // namespace

Frame chooseFrame(const OrientedPoints& points, const ImageGeometry& geometry, const PoissonParameters& parameters) {
  Vec3 low = points.positions.front();
  Vec3 high = low;
  for (const Vec3& p : points.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double widest = geometry.spacing.maxCoeff();
  const double extent = (high - low).maxCoeff();
  const double side = std::max(parameters.scale * extent, extent + 2 * kPaddingVoxels * widest);
  const auto deepest = [&](int level, double leastMm) {
    while (level > kCoarsestLevel && side / (1 << level) < leastMm) {
      --level;
    }
    return level;
  };
  Frame frame;
  frame.corner = 0.5 * (low + high) - Vec3::Constant(0.5 * side);
  frame.depth = deepest(parameters.depth, parameters.finestCell * geometry.spacing.minCoeff());
  frame.cellMm = side / (1 << frame.depth);
  const bool faces = parameters.sampling == Sampling::Unbiased;
  frame.kernelLevel = deepest(frame.depth, (faces ? kLeastKernelOfFaces : kLeastKernelOfPoints) * widest);
  frame.densityLevel = deepest(frame.kernelLevel, kLeastDensityCell * widest);
  return frame;
}

}  // namespace glisson::poisson
