#pragma once
// Purpose: runs of voxels as stretches that lie on one side of a plan or on both: what its sides' pieces are made of.

#include <cstdint>
#include <vector>

#include "planning/volumetry/resected.h"

namespace glisson {

/// A stretch of a run that is on one side altogether, or whose every voxel has parts on both.
struct RunPart {
  RowRun run;
  std::int64_t resected = 0;  ///< units of 2^-32 voxel
  std::size_t owner = 0;      ///< the resection that has most of what is resected
  [[nodiscard]] std::int64_t units() const { return static_cast<std::int64_t>(run.n) << 32; }
  [[nodiscard]] bool isDivided() const { return resected > 0 && resected < units(); }
};

/// The rows' voxels in order, in as few parts as that allows where one plane cuts a run, and single voxels where several do.
std::vector<RunPart> partsOf(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan);

}  // namespace glisson
