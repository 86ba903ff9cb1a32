#pragma once
// Purpose: boundary samples of a mask: position mm LPS, unit outward normal, area [Palomar 2016, 2.1; method.md 1].

#include <cstdint>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/poisson/field.h"

namespace glisson {

enum class Sampling : std::uint8_t {
  Paper,     ///< inside-surface voxel centres, weighted by local density: biased half a voxel inward
  Unbiased,  ///< centres of the faces between inside and outside voxels
};

struct OrientedPoints {
  poisson::LargeArray<Vec3> positions;
  poisson::LargeArray<Vec3> normals;
  poisson::LargeArray<double> weights;     ///< mm^2 (Paper: 1 each)
  poisson::LargeArray<std::uint8_t> axes;  ///< Unbiased: the image axis across each face; Paper: empty
};

/// The mask is padded by one voxel of background. Throws ReconstructionError on an empty mask and where Paper finds no voxel with a
/// gradient (single voxels have none). Cancel is polled every few slices.
OrientedPoints sampleBoundary(const Mask& mask, const ImageGeometry& geometry, Sampling sampling,
                              const ExecutionContext& context = {});

/// `unbiased` faces wider than a cell as several samples, so that V has no gaps between slices.
OrientedPoints spreadOverFaces(const OrientedPoints& faces, const ImageGeometry& geometry, double cellMm,
                               const ExecutionContext& context = {});

}  // namespace glisson
