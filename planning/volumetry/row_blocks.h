#pragma once
// Purpose: runs of voxels cut into blocks of space, so that what a bent plane is far from is decided block by block. Frame: image,
// mm.

#include <vector>

#include "planning/volumetry/voxel_rows.h"

namespace glisson {

struct RowBlock {
  Box box;                ///< around its voxels' boxes
  std::size_t begin = 0;  ///< rows.runs[begin, end)
  std::size_t end = 0;
  std::size_t voxels = 0;
};

struct RowBlocks {
  RowBlocks() = default;
  RowBlocks(const VoxelRows& whole, const Vec3& spacing);

  VoxelRows rows;                   ///< the same voxels, by block; within one by k, j, i
  std::vector<std::size_t> origin;  ///< of each of the rows' runs: the whole's run that it is of
  std::vector<RowBlock> blocks;
};

}  // namespace glisson
