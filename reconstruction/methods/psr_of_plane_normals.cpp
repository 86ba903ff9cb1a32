// PSR whose normals come from planes through neighbouring boundary voxels instead of the mask's gradient.

#include "reconstruction/methods/method.h"
#include "reconstruction/methods/plane_normals.h"
#include "reconstruction/poisson/poisson.h"
#include "reconstruction/stopwatch.h"

namespace glisson {

namespace {

constexpr int kManyNeighbours = 40;

MethodSurface reconstructAt(int depth, int neighbours, const MethodInput& input, const ExecutionContext& context) {
  const Stopwatch stopwatch;
  context.report(0.0, "sample");
  const OrientedPoints points =
      withPlaneNormals(sampleBoundary(input.mask, input.geometry, input.sampling, context), input.geometry, neighbours, context);
  const double sampleSeconds = stopwatch.seconds();
  const PoissonParameters parameters{.depth = depth, .sampling = input.sampling, .scale = input.scale};
  PoissonResult made = reconstructPoisson(points, input.geometry, parameters, context.range(0.4, 1.0));
  return {.mesh = std::move(made.mesh),
          .cellMm = made.cellMm,
          .usedDepth = made.usedDepth,
          .sampleSeconds = sampleSeconds + made.sampleSeconds,
          .solveSeconds = made.solveSeconds,
          .extractSeconds = made.extractSeconds};
}

}  // namespace

ReconstructionMethod psrOfPlaneNormals() {
  ReconstructionMethod method{
      .id = "psr_knn",
      .name = "PSR, k-NN normals",
      .description =
          "Poisson reconstruction with normals from planes fitted to the 10 (or 40) nearest boundary samples, turned outward by "
          "the "
          "mask.",
      .citation =
          "V. Leonardi, V. Vidal, J.-L. Mari, M. Daniel: 3D reconstruction from CT-scan volume dataset application to kidney "
          "modeling. Spring Conference on Computer Graphics, 2011.",
      .usual = "d7"};
  const auto add = [&](int depth, int neighbours, const std::string& idEnd, const std::string& nameEnd) {
    const std::string number = std::to_string(depth);
    method.variants.push_back({.id = "d" + number + idEnd,
                               .name = "d=" + number + nameEnd,
                               .depth = depth,
                               .make = [depth, neighbours](const MethodInput& input, const ExecutionContext& context) {
                                 return reconstructAt(depth, neighbours, input, context);
                               }});
  };
  for (int depth = 5; depth <= 8; ++depth) {
    add(depth, kUsualNeighbours, "", "");
  }
  // Thick slices want more: the ten nearest voxels may all lie in one slice, whose plane then is what is fitted.
  add(7, kManyNeighbours, "_k" + std::to_string(kManyNeighbours), " k=" + std::to_string(kManyNeighbours));
  return method;
}

}  // namespace glisson
