#pragma once
// Purpose: one binary mask, stored only inside the box of its set voxels. Immutable once built.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

/// A box of voxels: first voxel and number of voxels per axis, in the index frame of the whole grid.
struct IndexBox {
  Index3 first{0, 0, 0};
  Index3 size{0, 0, 0};
  [[nodiscard]] std::size_t voxelCount() const;
  bool operator==(const IndexBox&) const = default;
};

class Mask {
 public:
  Mask() = default;
  /// Crops to the set voxels. `values` (i fastest) cover `box`; non-zero is inside. Throws std::invalid_argument where sizes
  /// disagree.
  Mask(const IndexBox& box, std::span<const std::uint8_t> values);
  /// From values over a whole grid of `size` voxels.
  static Mask fromGrid(const Index3& size, std::span<const std::uint8_t> values);

  /// The smallest box that holds every set voxel; size 0 where the mask is empty.
  [[nodiscard]] const IndexBox& box() const { return box_; }
  /// 0 or 1 per voxel of box(), i fastest.
  [[nodiscard]] std::span<const std::uint8_t> values() const { return values_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// False outside the box.
  [[nodiscard]] bool at(int i, int j, int k) const;
  /// A set voxel lies on the border of a grid of `gridSize` voxels.
  [[nodiscard]] bool touchesBorder(const Index3& gridSize) const;

 private:
  IndexBox box_;
  std::vector<std::uint8_t> values_;
  std::size_t count_ = 0;
};

/// Voxelwise a or b, a and b, a and not b. Both on the same grid.
Mask unionOf(const Mask& a, const Mask& b);
Mask intersectionOf(const Mask& a, const Mask& b);
Mask differenceOf(const Mask& a, const Mask& b);

/// Smallest box that holds both (either may be empty).
IndexBox enclosing(const IndexBox& a, const IndexBox& b);

}  // namespace glisson
