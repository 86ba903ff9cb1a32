#pragma once
// Purpose: the middle lines of a mask of vessels, as ways from voxel to voxel. A part of vesselGraphOf().
// Why not the thinned centreline of reconstruction/mesh: thinning counts voxels, not mm, and wears off ends that are two voxels
// wide. Method, after M. Sato et al., TEASAR: tree-structure extraction algorithm for accurate and robust skeletons, 2000: from one
// end of each piece the cheapest way to every voxel, where a step costs its length / radius^3, so that ways run in the middle. The
// ways from the farthest voxels are taken one by one; each covers what lies within its radius, so that a rough wall makes no ways
// of its own. A ring is opened where it is farthest from that end.

#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"

namespace glisson {

struct PathVoxel {
  Index3 voxel{0, 0, 0};
  double radiusMm = 0;       ///< from its centre to the surface of the nearest voxel outside the mask
  std::int32_t parent = -1;  ///< in the list; -1 where a piece begins
};

/// Pieces in scan order (26-connected), parents before children. Polls cancel. Memory: four bytes a voxel of the mask's box and
/// about 40 a voxel of the mask.
std::vector<PathVoxel> vesselPaths(const Mask& vessel, const Vec3& spacing, const ExecutionContext& context = {});

}  // namespace glisson
