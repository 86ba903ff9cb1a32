#include "reconstruction/image/mask.h"

#include <algorithm>
#include <stdexcept>

namespace glisson {

namespace {
std::size_t offsetIn(const IndexBox& box, int i, int j, int k) {
  return static_cast<std::size_t>(i - box.first[0]) +
         static_cast<std::size_t>(box.size[0]) *
             (static_cast<std::size_t>(j - box.first[1]) +
              static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k - box.first[2]));
}

template <typename Rule>
Mask combine(const IndexBox& box, Rule&& inside) {
  std::vector<std::uint8_t> values(box.voxelCount());
  std::size_t n = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i, ++n) {
        values[n] = inside(box.first[0] + i, box.first[1] + j, box.first[2] + k) ? 1 : 0;
      }
    }
  }
  return {box, values};
}
}  // namespace

std::size_t IndexBox::voxelCount() const {
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
}

Mask::Mask(const IndexBox& box, std::span<const std::uint8_t> values) {
  if (values.size() != box.voxelCount()) {
    throw std::invalid_argument("Mask: the number of values does not match the box");
  }
  Index3 low = box.size;
  Index3 high{-1, -1, -1};
  std::size_t n = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i, ++n) {
        if (values[n] != 0) {
          ++count_;
          const Index3 voxel{i, j, k};
          for (std::size_t a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], voxel[a]);
            high[a] = std::max(high[a], voxel[a]);
          }
        }
      }
    }
  }
  if (count_ == 0) {
    return;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    box_.first[a] = box.first[a] + low[a];
    box_.size[a] = high[a] - low[a] + 1;
  }
  values_.resize(box_.voxelCount());
  n = 0;
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      const std::size_t row = static_cast<std::size_t>(box.size[0]) *
                              (static_cast<std::size_t>(j) + static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k));
      for (int i = low[0]; i <= high[0]; ++i, ++n) {
        values_[n] = values[row + static_cast<std::size_t>(i)] != 0 ? 1 : 0;
      }
    }
  }
}

Mask Mask::fromGrid(const Index3& size, std::span<const std::uint8_t> values) { return {IndexBox{{0, 0, 0}, size}, values}; }

bool Mask::at(int i, int j, int k) const {
  const Index3 voxel{i, j, k};
  for (std::size_t a = 0; a < 3; ++a) {
    if (voxel[a] < box_.first[a] || voxel[a] >= box_.first[a] + box_.size[a]) {
      return false;
    }
  }
  return values_[offsetIn(box_, i, j, k)] != 0;
}

bool Mask::touchesBorder(const Index3& gridSize) const {
  for (std::size_t a = 0; a < 3; ++a) {
    if (count_ > 0 && (box_.first[a] == 0 || box_.first[a] + box_.size[a] == gridSize[a])) {
      return true;
    }
  }
  return false;
}

Mask unionOf(const Mask& a, const Mask& b) {
  return combine(enclosing(a.box(), b.box()), [&](int i, int j, int k) { return a.at(i, j, k) || b.at(i, j, k); });
}

Mask intersectionOf(const Mask& a, const Mask& b) {
  return combine(a.box(), [&](int i, int j, int k) { return a.at(i, j, k) && b.at(i, j, k); });
}

Mask differenceOf(const Mask& a, const Mask& b) {
  return combine(a.box(), [&](int i, int j, int k) { return a.at(i, j, k) && !b.at(i, j, k); });
}

IndexBox enclosing(const IndexBox& a, const IndexBox& b) {
  if (a.voxelCount() == 0) {
    return b;
  }
  if (b.voxelCount() == 0) {
    return a;
  }
  IndexBox box;
  for (std::size_t n = 0; n < 3; ++n) {
    box.first[n] = std::min(a.first[n], b.first[n]);
    box.size[n] = std::max(a.first[n] + a.size[n], b.first[n] + b.size[n]) - box.first[n];
  }
  return box;
}

}  // namespace glisson
