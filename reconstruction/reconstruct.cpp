#include "reconstruction/reconstruct.h"

#include <chrono>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/untangle.h"
#include "reconstruction/representation.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The side of a PSR cell, 0 for MCSD.
double makeSurface(const Mask& mask, const ImageGeometry& geometry, Reconstruction& made, const ExecutionContext& context) {
  if (made.parameters.method == Method::Psr) {
    PoissonResult psr = reconstructPoisson(mask, geometry, made.parameters.psr, context);
    made.mesh = std::move(psr.mesh);
    made.usedDepth = psr.usedDepth;
    made.samples = psr.samples;
    made.seconds.sample = psr.sampleSeconds;
    made.seconds.solve = psr.solveSeconds;
    made.seconds.extract = psr.extractSeconds;
    return psr.cellMm;
  }
  McsdResult mcsd = reconstructMcsd(mask, geometry, made.parameters.mcsd, context);
  made.mesh = std::move(mcsd.mesh);
  made.seconds.extract = mcsd.extractSeconds;
  made.seconds.smooth = mcsd.smoothSeconds;
  made.seconds.decimate = mcsd.decimateSeconds;
  return 0.0;
}

/// Smoothing behind decimation leaves a few triangles that pass through each other; they are moved apart where they are few.
void removeSelfIntersections(Reconstruction& made, const ExecutionContext& context) {
  constexpr std::size_t kTrianglesPerPair = 200;
  if (made.parameters.method != Method::Mcsd || made.parameters.mcsd.smoothing == 0 || made.parameters.mcsd.splitNormals) {
    return;
  }
  const Untangled untangled = untangle(made.mesh, made.mesh.triangles.size() / kTrianglesPerPair, context);
  made.defects.selfIntersections = untangled.after;
  if (untangled.movedVertices > 0) {
    made.notes.push_back(std::to_string(untangled.before - std::min(untangled.before, untangled.after)) + " of " +
                         std::to_string(untangled.before) + " self-intersections of smoothing undone by moving " +
                         std::to_string(untangled.movedVertices) + " vertices");
  }
}
}  // namespace

void ReconstructionParameters::validate() const {
  if (method == Method::Psr) {
    psr.validate();
  } else {
    mcsd.validate();
  }
}

std::string ReconstructionParameters::describe() const {
  if (method == Method::Psr) {
    std::string text = "PSR d=" + std::to_string(psr.depth) + (psr.sampling == Sampling::Paper ? " paper" : " unbiased");
    if (psr.pointWeight > 0) {
      text += " screened " + formatExact(psr.pointWeight);
    }
    return text;
  }
  std::string text = "MCSD";
  text += mcsd.smoothing == 0 ? " unsmoothed" : mcsd.filter == SmoothingFilter::Sinc ? " sinc " : " Laplacian ";
  if (mcsd.smoothing > 0) {
    text += std::to_string(mcsd.smoothing);
  }
  text += " decimation " + formatExact(std::round(1000.0 * mcsd.decimation) / 10.0) + " %";
  if (mcsd.order == McsdOrder::SmoothFirst) {
    text += " smooth-first";
  }
  return mcsd.splitNormals ? text + " split normals" : text;
}

ReconstructionParameters ReconstructionParameters::defaultsFor(StructureKind kind) {
  ReconstructionParameters parameters;
  parameters.method = kind == StructureKind::Liver ? Method::Psr : Method::Mcsd;
  return parameters;
}

double Reconstruction::volumeDeviation() const { return meshVolumeMl / voxelVolumeMl - 1.0; }

Reconstruction reconstruct(const Mask& mask, const ImageGeometry& geometry, StructureKind kind,
                           const ReconstructionParameters& parameters, const ExecutionContext& context) {
  parameters.validate();
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  Reconstruction made;
  made.parameters = parameters;
  const double cellMm = makeSurface(mask, geometry, made, context.range(0.0, 0.85));
  context.report(0.85, "checks");
  const Stopwatch check;
  removeSelfIntersections(made, context);
  context.report(0.95, "checks");
  checkAgainstMask(mask, geometry, kind, cellMm, made, context);
  made.seconds.check = check.seconds();
  context.report(1.0, "checks");
  return made;
}

}  // namespace glisson
