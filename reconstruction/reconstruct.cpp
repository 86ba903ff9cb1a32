#include "reconstruction/reconstruct.h"

#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/mesh/untangle.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/representation.h"
#include "reconstruction/stopwatch.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
/// Takes over a Poisson surface; returns the side of its cells.
double take(PoissonResult psr, Reconstruction& made) {
  made.mesh = std::move(psr.mesh);
  made.usedDepth = psr.usedDepth;
  made.samples = psr.samples;
  made.seconds.sample = psr.sampleSeconds;
  made.seconds.solve = psr.solveSeconds;
  made.seconds.extract = psr.extractSeconds;
  return psr.cellMm;
}

/// Takes over a surface of marching cubes, which has no cells of its own: 0.
double take(McsdResult mcsd, Reconstruction& made) {
  made.mesh = std::move(mcsd.mesh);
  made.seconds.extract = mcsd.extractSeconds;
  made.seconds.smooth = mcsd.smoothSeconds;
  made.seconds.decimate = mcsd.decimateSeconds;
  return 0.0;
}

/// Takes over a listed method's surface; returns the side of its cells.
double take(MethodSurface surface, Reconstruction& made) {
  made.mesh = std::move(surface.mesh);
  made.usedDepth = surface.usedDepth;
  made.notes = std::move(surface.notes);
  made.seconds.sample = surface.sampleSeconds;
  made.seconds.solve = surface.solveSeconds;
  made.seconds.extract = surface.extractSeconds;
  made.seconds.simplify = surface.simplifySeconds;
  return surface.cellMm;
}

/// Smoothing behind decimation leaves a few triangles that pass through each other; they are moved apart where they are few. Those
/// of decimation alone are counted. Marching cubes alone has none, and apart at its doubled vertices a surface has no neighbours to
/// tell.
void removeSelfIntersections(Reconstruction& made, const ExecutionContext& context) {
  constexpr std::size_t kTrianglesPerPair = 200;
  const McsdParameters& mcsd = made.parameters.mcsd;
  if (made.parameters.method != Method::Mcsd || (mcsd.smoothing == 0 && mcsd.decimation == 0) || mcsd.splitNormals) {
    return;
  }
  const Stopwatch watch;
  const std::size_t mostPairs = mcsd.smoothing == 0 ? 0 : made.mesh.triangles.size() / kTrianglesPerPair;
  const Untangled untangled = untangle(made.mesh, mostPairs, context);
  made.defects.selfIntersections = untangled.after;
  if (untangled.movedVertices > 0) {
    made.notes.push_back(std::to_string(untangled.before - std::min(untangled.before, untangled.after)) + " of " +
                         std::to_string(untangled.before) + " self-intersections of smoothing undone by moving " +
                         std::to_string(untangled.movedVertices) + " vertices");
  }
  made.seconds.selfIntersection += watch.seconds();
}

/// A surface that cannot be simplified stays as it is, and a note says why: the other sets of a sweep go on.
void simplifyMesh(Reconstruction& made, const ExecutionContext& context) {
  const Stopwatch watch;
  const SimplifyTarget& target = *made.parameters.simplify;
  const std::size_t before = made.mesh.triangles.size();
  try {
    made.mesh = simplify(made.mesh, target, context);
  } catch (const CheckFailed&) {
    made.notes.emplace_back("not simplified: only a closed manifold surface can be");
    made.seconds.simplify += watch.seconds();
    return;
  }
  const std::size_t after = made.mesh.triangles.size();
  made.notes.push_back("simplified from " + std::to_string(before) + " to " + std::to_string(after) + " triangles");
  if (after > target.triangles.value_or(after)) {
    made.notes.push_back("more than " + std::to_string(*target.triangles) +
                         " triangles are kept: with fewer the surface would cross itself or lose a piece");
  }
  if (target.distanceMm && after == before) {
    made.notes.push_back("no triangle can be spared within " + formatExact(*target.distanceMm) + " mm");
  }
  made.seconds.simplify += watch.seconds();
  // The surface that was there before may have crossed itself: its count says nothing about this one.
  const Stopwatch search;
  made.defects.selfIntersections = countSelfIntersections(made.mesh, context);
  made.seconds.selfIntersection += search.seconds();
}

/// What follows the surface, by any method: the last 15 % of a set's progress.
void check(const Mask& mask, const ImageGeometry& geometry, StructureKind kind, double psrCellMm, std::optional<MaskFacts>& facts,
           Reconstruction& made, const ExecutionContext& context) {
  context.report(0.85, "checks");
  removeSelfIntersections(made, context);
  if (made.parameters.simplify) {
    simplifyMesh(made, context.range(0.88, 0.95));
  }
  context.report(0.95, "checks");
  const Stopwatch watch;
  checkAgainstMask(mask, geometry, kind, psrCellMm, facts, made, context);
  made.seconds.check = watch.seconds();
  context.report(1.0, "checks");
}

std::string describeMethod(const ReconstructionParameters& p) {
  if (p.method == Method::Psr) {
    const bool paper = p.psr.sampling == Sampling::Paper;
    const std::string text = p.autoDepth ? (paper ? "PSR d=auto paper" : "PSR d=auto unbiased")
                                         : "PSR d=" + std::to_string(p.psr.depth) + (paper ? " paper" : " unbiased");
    return p.psr.pointWeight > 0 ? text + " screened " + formatExact(p.psr.pointWeight) : text;
  }
  if (p.method == Method::Listed) {
    const ReconstructionMethod& method = listedMethod(p.listedMethod);
    return method.name + " " + variantOf(method, p.listedVariant).name;
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
    usedPsr().validate();
  } else if (method == Method::Mcsd) {
    mcsd.validate();
  } else {
    psr.validate();
    variantOf(glisson::listedMethod(listedMethod), listedVariant);
  }
  if (simplify) {
    simplify->validate();
  }
}

PoissonParameters ReconstructionParameters::usedPsr() const {
  PoissonParameters used = psr;
  if (autoDepth) {
    used.depth = kDeepestPsr;  // the solver lowers it
    used.finestCell = kAutoCell;
  }
  return used;
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
  Reconstruction made;
  reconstructEach(
      mask, geometry, kind, std::span(&parameters, 1), [&](std::size_t /*set*/, Reconstruction one) { made = std::move(one); },
      context);
  return made;
}

namespace {

/// The sets of one call, sorted by method.
struct SetsByMethod {
  std::vector<PoissonParameters> psr;
  std::vector<std::size_t> psrPlaces;
  std::vector<McsdParameters> mcsd;
  std::vector<std::size_t> mcsdPlaces;
  std::vector<std::size_t> listedPlaces;
};

SetsByMethod sortedByMethod(std::span<const ReconstructionParameters> sets) {
  SetsByMethod sorted;
  for (std::size_t n = 0; n < sets.size(); ++n) {
    sets[n].validate();
    if (sets[n].method == Method::Psr) {
      sorted.psr.push_back(sets[n].usedPsr());
      sorted.psrPlaces.push_back(n);
    } else if (sets[n].method == Method::Mcsd) {
      sorted.mcsd.push_back(sets[n].mcsd);
      sorted.mcsdPlaces.push_back(n);
    } else {
      sorted.listedPlaces.push_back(n);
    }
  }
  return sorted;
}

}  // namespace

void reconstructEach(const Mask& mask, const ImageGeometry& geometry, StructureKind kind,
                     std::span<const ReconstructionParameters> sets, const ReconstructionVisitor& visit,
                     const ExecutionContext& context) {
  const SetsByMethod sorted = sortedByMethod(sets);
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  std::optional<MaskFacts> facts;  // of the mask alone: found once for all sets
  const auto share = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(sets.size()); };
  const auto finish = [&](std::size_t set, auto result, const ExecutionContext& part) {
    Reconstruction made;
    made.parameters = sets[set];
    const double cellMm = take(std::move(result), made);
    check(mask, geometry, kind, cellMm, facts, made, part);
    visit(set, std::move(made));
  };
  if (!sorted.psr.empty()) {
    reconstructPoissonEach(
        mask, geometry, sorted.psr,
        [&](std::size_t n, PoissonResult result, const ExecutionContext& part) {
          finish(sorted.psrPlaces[n], std::move(result), part);
        },
        context.range(0.0, share(sorted.psr.size())));
  }
  for (std::size_t n = 0; n < sorted.listedPlaces.size(); ++n) {
    const ExecutionContext part = context.range(share(sorted.psr.size() + n), share(sorted.psr.size() + n + 1));
    const ReconstructionParameters& set = sets[sorted.listedPlaces[n]];
    const MethodVariant& variant = variantOf(listedMethod(set.listedMethod), set.listedVariant);
    finish(sorted.listedPlaces[n], variant.make({mask, geometry, set.psr.sampling, set.psr.scale}, part.range(0.0, 0.85)), part);
  }
  if (!sorted.mcsd.empty()) {
    if (!facts) {  // asked for on several threads
      facts = factsOf(mask, kind, context);
    }
    sweepMcsd(
        mask, geometry, sorted.mcsd,
        [&](std::size_t n, McsdResult result, const ExecutionContext& part) {
          finish(sorted.mcsdPlaces[n], std::move(result), part);
        },
        context.range(share(sets.size() - sorted.mcsd.size()), 1.0));
  }
}

}  // namespace glisson
