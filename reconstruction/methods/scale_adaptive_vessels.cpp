// Vessels: the engine's scale-aware Poisson surface (docs/vessels.md), then triangles that follow the calibre.

#include "reconstruction/methods/graded_triangles.h"
#include "reconstruction/methods/method.h"
#include "reconstruction/reconstruct.h"
#include "reconstruction/stopwatch.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

/// Keeps thin branches whole (docs/vessels.md).
constexpr double kScreening = 16;

/// Of the triangles' edges over the local radius, which is found some 20 % short: about 10 corners around a vessel.
constexpr double kEdgeOverRadius = 0.8;

MethodSurface reconstructWithin(double shareOfVoxel, const MethodInput& input, const ExecutionContext& context) {
  ReconstructionParameters parameters;
  parameters.autoDepth = true;
  parameters.psr.pointWeight = kScreening;
  parameters.psr.scale = input.scale;
  PoissonResult made = reconstructPoisson(input.mask, input.geometry, parameters.usedPsr(), context.range(0.0, 0.5));
  MethodSurface surface{.cellMm = made.cellMm,
                        .usedDepth = made.usedDepth,
                        .sampleSeconds = made.sampleSeconds,
                        .solveSeconds = made.solveSeconds,
                        .extractSeconds = made.extractSeconds};
  const Stopwatch stopwatch;
  surface.mesh =
      gradeTriangles(made.mesh, kEdgeOverRadius, shareOfVoxel * input.geometry.spacing.minCoeff(), context.range(0.5, 1.0));
  surface.simplifySeconds = stopwatch.seconds();
  return surface;
}

}  // namespace

ReconstructionMethod scaleAdaptiveVessels() {
  ReconstructionMethod method{
      .id = "vessels",
      .name = "Scale-adaptive PSR",
      .description =
          "Screened Poisson reconstruction of unbiased samples with cells of 0.8 voxels, then triangles sized by the local "
          "curvature.",
      .citation =
          "J. Wu, M. Wei, Y. Li, X. Ma, F. Jia, Q. Hu: Scale-adaptive surface modeling of vascular structures. BioMedical "
          "Engineering OnLine, 2010.",
      .usual = "v0.2"};
  for (const double share : {0.2, 1.0}) {
    method.variants.push_back({.id = "v" + formatExact(share),
                               .name = formatExact(share) + " voxel",
                               .make = [share](const MethodInput& input, const ExecutionContext& context) {
                                 return reconstructWithin(share, input, context);
                               }});
  }
  return method;
}

}  // namespace glisson
