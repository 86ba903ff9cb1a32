// MPU implicits of a mask's boundary samples: quadrics in the cells of an octree, blended (mpu/).
#include <cmath>

#include "reconstruction/methods/method.h"
#include "reconstruction/methods/mpu/surface.h"
#include "reconstruction/poisson/frame.h"
#include "reconstruction/stopwatch.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

/// Of the cells that carry the surface, where the label carries it.
constexpr int kUsualDepth = 7;

/// The diagonal of the samples' box, of which the tolerance is a share.
double diagonalOf(const OrientedPoints& points) {
  Vec3 low = points.positions.front();
  Vec3 high = low;
  for (const Vec3& p : points.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// `tolerance` is the paper's eps0, of the diagonal. The polygons are those of a PSR model of `depth`: of the same cube and cells.
MethodSurface reconstructWithin(double tolerance, int depth, const MethodInput& input, const ExecutionContext& context) {
  MethodSurface surface;
  Stopwatch stopwatch;
  context.report(0.0, "sample");
  const OrientedPoints points = sampleBoundary(input.mask, input.geometry, input.sampling, context);
  const poisson::Frame frame =
      poisson::chooseFrame(points, input.geometry, {.depth = depth, .sampling = input.sampling, .scale = input.scale});
  const mpu::Cube cube{frame.corner, frame.cellMm * (1 << frame.depth)};
  surface.cellMm = frame.cellMm;
  surface.usedDepth = frame.depth;
  surface.sampleSeconds = stopwatch.seconds();

  stopwatch.restart();
  const double widest = input.geometry.spacing.maxCoeff();
  const std::vector<mpu::Patch> patches =
      mpu::fitPatches(points.positions, points.normals, cube,
                      {.toleranceMm = tolerance * diagonalOf(points), .leastSideMm = widest}, context.range(0.1, 0.7));
  surface.solveSeconds = stopwatch.seconds();

  stopwatch.restart();
  context.report(0.7, "extract");
  const auto isInside = [&](const Vec3& at) {
    const Vec3 index = input.geometry.toIndex(at);
    return input.mask.at(static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
                         static_cast<int>(std::lround(index[2])));
  };
  surface.mesh = mpu::polygonise(patches, points.positions, cube, {.depth = frame.depth, .bandMm = widest + 2 * frame.cellMm},
                                 isInside, context.range(0.7, 1.0));
  surface.extractSeconds = stopwatch.seconds();
  return surface;
}

}  // namespace

ReconstructionMethod mpuImplicits() {
  ReconstructionMethod method{
      .id = "mpu",
      .name = "MPU implicits",
      .description =
          "Quadrics fitted in the cells of an octree until they are within a tolerance of the boundary samples, and blended.",
      .citation =
          "Y. Ohtake, A. Belyaev, M. Alexa, G. Turk, H.-P. Seidel: Multi-level partition of unity implicits. ACM Transactions on "
          "Graphics (SIGGRAPH), 2003.",
      .usual = "e0.0025"};
  const auto add = [&](double tolerance, const std::string& idEnd, const std::string& nameEnd, int depth, int neededDepth) {
    method.variants.push_back({.id = "e" + formatExact(tolerance) + idEnd,
                               .name = "eps=" + formatExact(tolerance) + nameEnd,
                               .depth = neededDepth,
                               .make = [tolerance, depth](const MethodInput& input, const ExecutionContext& context) {
                                 return reconstructWithin(tolerance, depth, input, context);
                               }});
  };
  for (const double tolerance : {0.01, 0.005, 0.0025}) {
    add(tolerance, "", "", kUsualDepth, 0);
  }
  add(0.0025, "_d8", " d=8", 8, 8);
  return method;
}

}  // namespace glisson
