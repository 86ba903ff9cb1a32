#pragma once
// Purpose: a mask as runs of voxels along i: what volumes, sections and distances are computed from.
// Frame: the image frame in mm, p = spacing * index (an isometry of the world: world = origin + direction p), where every run is an
// axis-parallel box. A run of n voxels is one box: whatever is exact for a box is exact for the run.

#include <vector>

#include "planning/resection/resection_plan.h"
#include "reconstruction/image/mask.h"

namespace glisson {

struct RowRun {
  int i = 0;  ///< first voxel
  int j = 0;
  int k = 0;
  int n = 0;  ///< number of voxels
};

struct VoxelRows {
  std::vector<RowRun> runs;  ///< by k, j, i
  std::size_t voxels = 0;
};

/// The runs of `mask`; with `within`, of the voxels in both.
VoxelRows rowsOf(const Mask& mask, const Mask* within = nullptr);

/// One more run, behind the others; it goes on with the last one where it begins at its end.
void append(VoxelRows& rows, const RowRun& run);

struct Box {
  Vec3 centre = Vec3::Zero();
  Vec3 half = Vec3::Zero();
};
inline Box boxOf(const RowRun& run, const Vec3& spacing) {
  return {spacing.cwiseProduct(Vec3(run.i + 0.5 * (run.n - 1), run.j, run.k)), 0.5 * spacing.cwiseProduct(Vec3(run.n, 1, 1))};
}

/// Corner 0..7: bit n tells the upper side along axis n.
inline Vec3 cornerOf(const Box& box, unsigned corner) {
  return box.centre + Vec3((corner & 1U) != 0 ? box.half[0] : -box.half[0], (corner & 2U) != 0 ? box.half[1] : -box.half[1],
                           (corner & 4U) != 0 ? box.half[2] : -box.half[2]);
}

/// A half-space in the image frame: distance(p) = normal . p + offset >= 0 is resected.
struct ImagePlane {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;
  [[nodiscard]] double distance(const Vec3& p) const { return normal.dot(p) + offset; }
  /// Half the extent of a box along the normal.
  [[nodiscard]] double support(const Vec3& half) const { return normal.cwiseAbs().dot(half); }
};
ImagePlane toImage(const HalfSpace& plane, const ImageGeometry& geometry);

/// Distances below this are nil: a plane this close to a voxel's face lies on it (mm).
inline constexpr double kOnPlaneMm = 1e-7;

}  // namespace glisson
