#pragma once
// Purpose: Poisson surface reconstruction of a mask (Palomar et al. 2016, section 2; Kazhdan et al. 2006; method.md 1 and 2).
// Finds X minimising ||grad X - V|| over trilinear B-splines on nested grids of 2^depth cells a side, then extracts X = iso.
// Frame: mm LPS in and out. Same bytes for any number of threads. Cancel is polled at least every 100 ms of work.

#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

enum class Sampling : std::uint8_t {
  Paper,     ///< inside-surface voxel centres, weighted by local density: biased half a voxel inward
  Unbiased,  ///< centres of the faces between inside and outside voxels
};

/// Boundary samples of a mask: position mm LPS, unit outward normal, weight mm^2 (Paper: 1 each).
struct OrientedPoints {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<double> weights;
};

/// method.md 1. The mask is padded by one voxel of background. Throws ReconstructionError on an empty mask and where
/// Paper finds no voxel with a gradient (single voxels have none).
OrientedPoints sampleBoundary(const Mask& mask, const ImageGeometry& geometry, Sampling sampling,
                              const ExecutionContext& context = {});

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

}  // namespace glisson
