// Poisson surface reconstruction: Kazhdan, Bolitho, Hoppe 2006; Palomar et al. 2016, section 2.2. The stages stand in samples.cpp,
// splatting.cpp, hierarchy.cpp (operators.cpp), extraction.cpp; this file chooses cube, depth and iso value and runs them.
#include "reconstruction/poisson/poisson.h"

#include <chrono>
#include <stdexcept>

#include "reconstruction/errors.h"
#include "reconstruction/poisson/extraction.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The cube, the depth in use and the level on which V is splatted.
struct Frame {
  Vec3 corner;
  double cellMm = 0;
  int depth = 0;
  int kernelLevel = 0;
};

constexpr int kPaddingVoxels = 2;  // around tiny bodies, where scale x extent would leave no room for the kernel

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
  Frame frame;
  frame.corner = 0.5 * (low + high) - Vec3::Constant(0.5 * side);
  frame.depth = parameters.depth;
  // A cell far below the sample spacing would tear small bodies apart [method.md 2].
  while (frame.depth > poisson::kCoarsestLevel && side / (1 << frame.depth) < parameters.finestCell * geometry.spacing.minCoeff()) {
    --frame.depth;
  }
  frame.cellMm = side / (1 << frame.depth);
  frame.kernelLevel = frame.depth;
  while (frame.kernelLevel > poisson::kCoarsestLevel && side / (1 << frame.kernelLevel) < 0.5 * widest) {
    --frame.kernelLevel;
  }
  return frame;
}

/// Faces wider than the kernel's cell are spread over sub-faces, so that V has no gaps between slices. `paper` points stay points.
OrientedPoints spreadOverFaces(const OrientedPoints& points, const ImageGeometry& geometry, double kernelCell) {
  Index3 parts{};
  for (std::size_t a = 0; a < 3; ++a) {
    parts[a] = std::max(1, static_cast<int>(std::ceil(geometry.spacing[static_cast<int>(a)] / kernelCell - 0.01)));
  }
  if (parts == Index3{1, 1, 1}) {
    return points;
  }
  OrientedPoints spread;
  for (std::size_t n = 0; n < points.positions.size(); ++n) {
    // The face's axis is the one along which its centre lies between two voxel centres.
    const Vec3 index = geometry.toIndex(points.positions[n]);
    const Vec3 offGrid = (index - Vec3(std::round(index[0]), std::round(index[1]), std::round(index[2]))).cwiseAbs();
    Eigen::Index axis = 0;
    offGrid.maxCoeff(&axis);
    const Eigen::Index u = (axis + 1) % 3;
    const Eigen::Index v = (axis + 2) % 3;
    const int nu = parts[static_cast<std::size_t>(u)];
    const int nv = parts[static_cast<std::size_t>(v)];
    for (int b = 0; b < nv; ++b) {
      for (int a = 0; a < nu; ++a) {
        Vec3 at = index;
        at[u] += (a + 0.5) / nu - 0.5;
        at[v] += (b + 0.5) / nv - 0.5;
        spread.positions.push_back(geometry.toWorld(at));
        spread.normals.push_back(points.normals[n]);
        spread.weights.push_back(points.weights[n] / (nu * nv));
      }
    }
  }
  return spread;
}

/// `paper` points carry no area: the surface area of a point is that of a cell over the number of points near it.
void weighByDensity(poisson::CubeSamples& samples, int kernelLevel, double kernelCell, const ExecutionContext& context) {
  poisson::BlockGrid grid(kernelLevel);
  for (const std::size_t first : samples.blockRanges(kernelLevel)) {
    if (first < samples.positions.size()) {
      const poisson::Coord b = samples.blockOf(first, kernelLevel);
      for (int c = 0; c < 8; ++c) {
        grid.mark({b[0] + (c & 1), b[1] + ((c >> 1) & 1), b[2] + (c >> 2)});
      }
    }
  }
  grid.number();
  poisson::Field density(grid.nodeCount(), 0.0F);
  poisson::splat(samples, grid, 3, 1.0F, density, context);
  const auto values = poisson::valuesAt(samples, grid, density, context);
  for (std::size_t n = 0; n < values.size(); ++n) {
    // A plane of s points a cell gives 2/3 s where it is splatted and read with the same hat function.
    samples.weights[n] = static_cast<float>(kernelCell * kernelCell * 2.0 / 3.0) / values[n];
  }
}

float isoValue(const poisson::CubeSamples& samples, const poisson::Level& finest, const ExecutionContext& context) {
  const auto values = poisson::valuesAt(samples, finest.grid, finest.x, context);
  double sum = 0;
  double weight = 0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    sum += static_cast<double>(values[n]) * samples.weights[n];
    weight += samples.weights[n];
  }
  return static_cast<float>(sum / weight);
}

}  // namespace

void PoissonParameters::validate() const {
  if (depth < 5 || depth > 10) {
    throw UsageError("The depth must lie between 5 and 10, not " + std::to_string(depth) + ".");
  }
  if (!(pointWeight >= 0) || !std::isfinite(pointWeight)) {
    throw UsageError("The point weight must be a number of 0 or more.");
  }
  if (!(scale > 1.0 && scale <= 4.0)) {
    throw UsageError("The scale must be above 1 and at most 4, not " + formatNumber(scale, 3) + ".");
  }
  if (!(finestCell >= 0.5) || !std::isfinite(finestCell)) {
    throw std::invalid_argument("PoissonParameters::finestCell is below half a voxel");
  }
}

PoissonResult reconstructPoisson(const Mask& mask, const ImageGeometry& geometry, const PoissonParameters& parameters,
                                 const ExecutionContext& context) {
  parameters.validate();
  PoissonResult result;
  auto start = Clock::now();
  context.report(0.0, "sample");
  const OrientedPoints points = sampleBoundary(mask, geometry, parameters.sampling, context);
  result.samples = points.positions.size();
  const Frame frame = chooseFrame(points, geometry, parameters);
  const double kernelCell = frame.cellMm * (1 << (frame.depth - frame.kernelLevel));
  const bool paper = parameters.sampling == Sampling::Paper;
  auto samples =
      poisson::toCube(paper ? points : spreadOverFaces(points, geometry, kernelCell), frame.corner, frame.cellMm, frame.depth);
  if (paper) {
    weighByDensity(samples, frame.kernelLevel, kernelCell, context);
  }
  result.sampleSeconds = secondsSince(start);

  start = Clock::now();
  context.report(0.2, "solve");
  poisson::HierarchyOptions options;
  options.kernelLevel = frame.kernelLevel;
  options.cellMm = frame.cellMm;
  options.bandCells = std::max(3.0F, static_cast<float>(0.75 * geometry.spacing.maxCoeff() / frame.cellMm + 2.0));
  options.pointWeight = parameters.pointWeight;
  auto levels = poisson::solveIndicator(samples, options, context.range(0.2, 0.8));
  const float iso = isoValue(samples, levels.back(), context);
  result.solveSeconds = secondsSince(start);

  start = Clock::now();
  context.report(0.8, "extract");
  result.mesh = poisson::extractSurface(levels, iso, frame.corner, frame.cellMm, context);
  result.extractSeconds = secondsSince(start);
  result.usedDepth = frame.depth;
  result.cellMm = frame.cellMm;
  context.report(1.0, "extract");
  return result;
}

}  // namespace glisson
