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

void simplifyMesh(Reconstruction& made, const ExecutionContext& context) {
  const Stopwatch watch;
  const std::size_t before = made.mesh.triangles.size();
  made.mesh = simplify(made.mesh, *made.parameters.simplify, context);
  const std::size_t after = made.mesh.triangles.size();
  made.notes.push_back("simplified from " + std::to_string(before) + " to " + std::to_string(after) + " triangles");
  if (after > made.parameters.simplify->triangles.value_or(after)) {
    made.notes.push_back("more than " + std::to_string(*made.parameters.simplify->triangles) +
                         " triangles are kept: with fewer the surface would cross itself or lose a piece");
  }
  made.seconds.simplify = watch.seconds();
}

std::string describeMethod(const ReconstructionParameters& p) {
  if (p.method == Method::Psr) {
    const std::string text = "PSR d=" + std::to_string(p.psr.depth) + (p.psr.sampling == Sampling::Paper ? " paper" : " unbiased");
    return p.psr.pointWeight > 0 ? text + " screened " + formatExact(p.psr.pointWeight) : text;
  }
  const std::string filter = p.mcsd.filter == SmoothingFilter::Sinc ? "sinc " : "Laplacian ";
  const std::string smoothed = p.mcsd.smoothing == 0 ? "unsmoothed" : filter + std::to_string(p.mcsd.smoothing);
  std::string text = "MCSD " + smoothed + " decimation " + formatExact(std::round(1000.0 * p.mcsd.decimation) / 10.0) + " %";
  if (p.mcsd.order == McsdOrder::SmoothFirst) {
    text += " smooth-first";
  }
  return p.mcsd.splitNormals ? text + " split normals" : text;
}
}  // namespace

void ReconstructionParameters::validate() const {
  if (method == Method::Psr) {
    psr.validate();
  } else {
    mcsd.validate();
  }
  if (simplify) {
    simplify->validate();
  }
}

std::string ReconstructionParameters::describe() const {
  std::string text = describeMethod(*this);
  if (simplify && simplify->triangles) {
    text += ", simplified to " + std::to_string(*simplify->triangles) + " triangles";
  } else if (simplify) {
    text += ", simplified to " + formatExact(*simplify->distanceMm) + " mm";
  }
  return text;
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
  if (parameters.simplify) {
    simplifyMesh(made, context.range(0.88, 0.95));
  }
  context.report(0.95, "checks");
  checkAgainstMask(mask, geometry, kind, cellMm, made, context);
  made.seconds.check = check.seconds() - made.seconds.simplify;
  context.report(1.0, "checks");
  return made;
}

}  // namespace glisson
