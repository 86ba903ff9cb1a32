// Poisson surface reconstruction: Kazhdan, Bolitho, Hoppe 2006; Palomar et al. 2016, section 2.2. The stages stand in files of
// their own: samples, frame, splatting (density), hierarchy, solve (operators), iso_value, extraction; this one runs them.
#include "reconstruction/poisson/poisson.h"

#include <map>
#include <stdexcept>

#include "reconstruction/errors.h"
#include "reconstruction/poisson/density.h"
#include "reconstruction/poisson/extraction.h"
#include "reconstruction/poisson/frame.h"
#include "reconstruction/poisson/iso_value.h"
#include "reconstruction/poisson/solve.h"
#include "reconstruction/poisson/support.h"
#include "reconstruction/stopwatch.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

poisson::CubeSamples cubeSamplesOf(const OrientedPoints& points, const ImageGeometry& geometry, Sampling sampling,
                                   const poisson::Frame& frame, const ExecutionContext& context) {
  if (sampling == Sampling::Unbiased) {
    return poisson::toCube(spreadOverFaces(points, geometry, frame.cellMmOf(frame.kernelLevel), context), frame.corner,
                           frame.cellMm, frame.depth, context);
  }
  auto samples = poisson::toCube(points, frame.corner, frame.cellMm, frame.depth, context);
  poisson::weighByDensity(samples, frame.densityLevel, frame.cellMmOf(frame.densityLevel), context);
  return samples;
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

PoissonResult reconstructPoisson(const OrientedPoints& points, const ImageGeometry& geometry, const PoissonParameters& parameters,
                                 const ExecutionContext& context) {
  parameters.validate();
  PoissonResult result;
  Stopwatch stopwatch;
  const poisson::Frame frame = poisson::chooseFrame(points, geometry, parameters);
  const auto samples = cubeSamplesOf(points, geometry, parameters.sampling, frame, context);
  result.samples = points.positions.size();
  result.usedDepth = frame.depth;
  result.cellMm = frame.cellMm;
  result.sampleSeconds = stopwatch.seconds();

  stopwatch.restart();
  context.report(0.1, "solve");
  poisson::HierarchyOptions options;
  options.kernelLevel = frame.kernelLevel;
  options.cellMm = frame.cellMm;
  options.bandCells = std::max(3.0F, static_cast<float>(0.75 * geometry.spacing.maxCoeff() / frame.cellMm + 2.0));
  options.pointWeight = parameters.pointWeight;
  auto levels = poisson::makeLevels(samples, options, context);
  poisson::makeRightHandSides(samples, options, levels, context);
  poisson::solveLevels(samples, options, levels, context.range(0.2, 0.8));
  const float iso = poisson::isoValue(samples, levels.back(), context);
  result.solveSeconds = stopwatch.seconds();

  stopwatch.restart();
  context.report(0.8, "extract");
  result.mesh = poisson::extractSurface(levels, iso, frame.corner, frame.cellMm, context);
  if (parameters.sampling == Sampling::Paper && frame.hasEmptyCells()) {
    levels = {};  // their memory is needed no longer
    poisson::coarsenUnsupported(samples, frame.corner, frame.cellMm, result.mesh, context);
  }
  result.extractSeconds = stopwatch.seconds();
  context.report(1.0, "extract");
  return result;
}

void reconstructPoissonEach(const Mask& mask, const ImageGeometry& geometry, std::span<const PoissonParameters> sets,
                            const PoissonVisitor& finished, const ExecutionContext& context) {
  const auto costOf = [](const PoissonParameters& set) {
    return std::pow(4.0, set.depth);
  };  // about four times that of a depth less
  double whole = 0;
  for (const PoissonParameters& set : sets) {
    set.validate();
    whole += costOf(set);
  }
  std::map<Sampling, OrientedPoints> sampled;
  constexpr double kSampled = 0.1;
  constexpr double kSolved = 0.85;
  double from = 0;
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const double to = from + costOf(sets[n]) / whole;
    const ExecutionContext part = context.range(from, to);
    const Stopwatch stopwatch;
    part.report(0.0, "sample");
    auto found = sampled.find(sets[n].sampling);
    if (found == sampled.end()) {
      found = sampled.emplace(sets[n].sampling, sampleBoundary(mask, geometry, sets[n].sampling, part)).first;
    }
    const double sampleSeconds = stopwatch.seconds();
    PoissonResult result = reconstructPoisson(found->second, geometry, sets[n], part.range(kSampled, kSolved));
    result.sampleSeconds += sampleSeconds;
    finished(n, std::move(result), part);
    from = to;
  }
}

PoissonResult reconstructPoisson(const Mask& mask, const ImageGeometry& geometry, const PoissonParameters& parameters,
                                 const ExecutionContext& context) {
  PoissonResult only;
  reconstructPoissonEach(
      mask, geometry, std::span(&parameters, 1),
      [&](std::size_t /*set*/, PoissonResult result, const ExecutionContext& /*part*/) { only = std::move(result); }, context);
  context.report(1.0, "extract");
  return only;
}

}  // namespace glisson
