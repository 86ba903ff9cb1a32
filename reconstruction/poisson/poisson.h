#pragma once
// Purpose: Poisson surface reconstruction of a mask (Palomar et al. 2016, section 2; Kazhdan et al. 2006; method.md 1 and 2).
// Finds X minimising ||grad X - V|| over trilinear B-splines on nested grids of 2^depth cells a side, then extracts X = iso.
// Frame: mm LPS in and out. Same bytes for any number of threads. Cancel is polled at least every 100 ms of work.

#include <functional>
#include <span>
#include <vector>

#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/poisson/samples.h"

namespace glisson {

struct PoissonParameters {
  int depth = 7;  ///< 5..10
  Sampling sampling = Sampling::Unbiased;
  double pointWeight = 0.0;  ///< screening; 0 is the paper's method
  double scale = 1.1;        ///< cube side / largest extent of the samples
  double finestCell = 0.5;   ///< least side of a cell over the smallest spacing: a depth with finer cells is lowered

  /// Throws UsageError outside depth 5..10, pointWeight >= 0, 1.0 < scale <= 4; std::invalid_argument where finestCell < 0.5.
  void validate() const;
};

struct PoissonResult {
  SurfaceMesh mesh;
  int usedDepth = 0;  ///< less than asked where a cell would be below finestCell
  double cellMm = 0.0;
  std::size_t samples = 0;
  double sampleSeconds = 0.0;
  double solveSeconds = 0.0;
  double extractSeconds = 0.0;
};

PoissonResult reconstructPoisson(const Mask& mask, const ImageGeometry& geometry, const PoissonParameters& parameters,
                                 const ExecutionContext& context = {});

/// The same from points that are there already, sampled of a mask on `geometry` as parameters.sampling says; their normals and
/// weights are taken as they are.
PoissonResult reconstructPoisson(const OrientedPoints& points, const ImageGeometry& geometry, const PoissonParameters& parameters,
                                 const ExecutionContext& context = {});

/// Takes the result of set number `set`; `part` is the set's share of the progress, of which 0.85 is done.
using PoissonVisitor = std::function<void(std::size_t set, PoissonResult result, const ExecutionContext& part)>;

/// The same mask by several sets of parameters, from one set of samples: the same bytes as one by one, several depths in little
/// more than the time of the deepest [Palomar 2016, 5.3]. Calls finished() in their order, as each is done; the first one's
/// sampleSeconds hold what they share.
void reconstructPoissonEach(const Mask& mask, const ImageGeometry& geometry, std::span<const PoissonParameters> sets,
                            const PoissonVisitor& finished, const ExecutionContext& context = {});

}  // namespace glisson
