#include "planning/volumetry/voxel_rows.h"

namespace glisson {

VoxelRows rowsOf(const Mask& mask, const Mask* within) {
  VoxelRows rows;
  const IndexBox& box = mask.box();
  const auto values = mask.values();
  std::size_t at = 0;
  for (int k = box.first[2]; k < box.first[2] + box.size[2]; ++k) {
    for (int j = box.first[1]; j < box.first[1] + box.size[1]; ++j) {
      bool open = false;
      for (int i = box.first[0]; i < box.first[0] + box.size[0]; ++i, ++at) {
        const bool set = values[at] != 0 && (within == nullptr || within->at(i, j, k));
        if (set && open) {
          ++rows.runs.back().n;
        } else if (set) {
          rows.runs.push_back({i, j, k, 1});
        }
        rows.voxels += set ? 1 : 0;
        open = set;
      }
    }
  }
  return rows;
}

ImagePlane toImage(const HalfSpace& plane, const ImageGeometry& geometry) {
  const Vec3 unit = plane.normal.normalized();
  return {geometry.direction.transpose() * unit, unit.dot(geometry.origin - plane.origin)};
}

void append(VoxelRows& rows, const RowRun& run) {
  rows.voxels += static_cast<std::size_t>(run.n);
  if (!rows.runs.empty()) {
    RowRun& last = rows.runs.back();
    if (last.k == run.k && last.j == run.j && last.i + last.n == run.i) {
      last.n += run.n;
      return;
    }
  }
  rows.runs.push_back(run);
}

}  // namespace glisson
