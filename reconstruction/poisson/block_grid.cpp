#include "reconstruction/poisson/block_grid.h"

#include <algorithm>
#include <cstring>

namespace glisson::poisson {

BlockGrid::BlockGrid(int level)
    : level_(level),
      side_((1 << level) / kBlock),
      slots_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), -1) {}

void BlockGrid::mark(const Coord& block) {
  for (const int c : block) {
    if (c < 0 || c >= side_) {
      return;
    }
  }
  auto& slot = slots_[linear(block)];
  if (slot == -1) {
    slot = -2;
  }
}

void BlockGrid::markAll() { std::replace(slots_.begin(), slots_.end(), -1, -2); }

void BlockGrid::number() {
  const std::size_t before = coords_.size();
  std::size_t n = 0;
  for (int k = 0; k < side_; ++k) {
    for (int j = 0; j < side_; ++j) {
      for (int i = 0; i < side_; ++i, ++n) {
        if (slots_[n] == -2) {
          slots_[n] = static_cast<std::int32_t>(coords_.size());
          coords_.push_back({i, j, k});
        }
      }
    }
  }
  if (coords_.size() == before) {
    return;
  }
  around_.resize(coords_.size());
  for (std::size_t block = 0; block < coords_.size(); ++block) {
    const Coord& at = coords_[block];
    std::size_t m = 0;
    for (int dk = -1; dk <= 1; ++dk) {
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di, ++m) {
          around_[block][m] = slot({at[0] + di, at[1] + dj, at[2] + dk});
        }
      }
    }
  }
}

void BlockGrid::gather(const Field& field, std::size_t slot, Halo& halo) const {
  static constexpr std::array<float, kBlockNodes> kZeros{};
  std::array<const float*, 27> blocks{};
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    const std::int32_t other = around_[slot][n];
    blocks[n] = other < 0 ? kZeros.data() : field.data() + static_cast<std::size_t>(other) * kBlockNodes;
  }
  // Along an axis node -1 is the last one of the block before and node 8 the first one of the block after.
  const auto blockOf = [](std::size_t node) { return node == 0 ? 0U : node <= kBlock ? 1U : 2U; };
  for (std::size_t k = 0; k < kHalo; ++k) {
    for (std::size_t j = 0; j < kHalo; ++j) {
      const float* const* row = &blocks[3 * (blockOf(j) + 3 * blockOf(k))];
      const std::size_t from = kBlock * ((j + kBlock - 1) % kBlock + kBlock * ((k + kBlock - 1) % kBlock));
      float* to = halo.data() + kHalo * (j + kHalo * k);
      to[0] = row[0][from + kBlock - 1];
      std::memcpy(to + 1, row[1] + from, kBlock * sizeof(float));
      to[kHalo - 1] = row[2][from];
    }
  }
}

void BlockGrid::clearFixedNodes(std::size_t slot, float* values) const {
  const auto& around = around_[slot];
  if (std::all_of(around.begin(), around.end(), [](std::int32_t other) { return other >= 0; })) {
    return;
  }
  const Coord& block = coords_[slot];
  std::size_t n = 0;
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di, ++n) {
        const Coord other{block[0] + di, block[1] + dj, block[2] + dk};
        const bool beyondTop = std::any_of(other.begin(), other.end(), [&](int c) { return c >= side_; });
        if (beyondTop || around[n] >= 0) {
          continue;  // node 2^level of the cube's surface is a zero of its own: its neighbours are unknowns
        }
        const int i0 = di > 0 ? 7 : 0, i1 = di < 0 ? 1 : 8;
        const int j0 = dj > 0 ? 7 : 0, j1 = dj < 0 ? 1 : 8;
        const int k0 = dk > 0 ? 7 : 0, k1 = dk < 0 ? 1 : 8;
        for (int k = k0; k < k1; ++k) {
          for (int j = j0; j < j1; ++j) {
            std::fill(values + nodeIndex(i0, j, k), values + nodeIndex(i0, j, k) + (i1 - i0), 0.0F);
          }
        }
      }
    }
  }
}

}  // namespace glisson::poisson
