#pragma once
// Purpose: the centreline of a mask of tubes, as voxels: distance-ordered homotopic thinning in index space. Voxels go from the
// border inward while the topology (26 / 6) stays; ends stay where they are centres of maximal balls, so that a rough border grows
// no twigs. Source: C. Pudney, Distance-ordered homotopic thinning, 1998; chamfer distances 3-4-5; simple points by Malandain and
// Bertrand, 1992.

#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"

namespace glisson {

/// Voxels of the centreline in the index frame of the whole grid, k slowest. A solid without arms gives one voxel or a few.
/// Polls cancel for every distance. Memory: five bytes a voxel of the mask's box.
std::vector<Index3> centrelineOf(const Mask& mask, const ExecutionContext& context = {});

}  // namespace glisson
