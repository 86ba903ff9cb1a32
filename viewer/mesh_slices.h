#pragma once
// Purpose: where a surface crosses the slices of a grid, to draw the outline of what will be exported beside the label's. The
// triangles of each slice are found once. Frame: mm LPS in, slice points out.

#include <memory>
#include <utility>
#include <vector>

#include "reconstruction/reconstruct.h"
#include "viewer/slice_geometry.h"

namespace glisson {

class MeshSlices {
 public:
  /// Keeps the reconstruction. A slice lies in the middle of its voxels.
  MeshSlices(std::shared_ptr<const Reconstruction> source, const SliceGeometry& geometry);

  [[nodiscard]] const Reconstruction* source() const { return source_.get(); }
  /// One segment for each triangle that crosses the slice; together they are closed lines.
  [[nodiscard]] std::vector<std::pair<SlicePoint, SlicePoint>> outline(int slice) const;

 private:
  [[nodiscard]] std::pair<int, int> slicesOf(const Triangle& triangle) const;

  std::shared_ptr<const Reconstruction> source_;
  SliceGeometry geometry_;
  std::vector<float> height_;             ///< of each vertex, in slices
  std::vector<std::uint32_t> first_;      ///< of each slice, in triangles_
  std::vector<std::uint32_t> triangles_;  ///< by slice
};

}  // namespace glisson
