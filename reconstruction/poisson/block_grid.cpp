#include "reconstruction/poisson/block_grid.h"

#include <algorithm>

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
}

void BlockGrid::gather(const Field& field, std::size_t slot, Halo& halo) const {
  const Coord& block = coords_[slot];
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const std::int32_t other = this->slot({block[0] + di, block[1] + dj, block[2] + dk});
        const float* source = other < 0 ? nullptr : field.data() + static_cast<std::size_t>(other) * kBlockNodes;
        // Nodes of this neighbour seen in the halo: all 8, its last, or its first.
        const int i0 = di < 0 ? 7 : 0, i1 = di > 0 ? 1 : 8;
        const int j0 = dj < 0 ? 7 : 0, j1 = dj > 0 ? 1 : 8;
        const int k0 = dk < 0 ? 7 : 0, k1 = dk > 0 ? 1 : 8;
        for (int k = k0; k < k1; ++k) {
          for (int j = j0; j < j1; ++j) {
            float* target = halo.data() + haloIndex(i0 + 8 * di, j + 8 * dj, k + 8 * dk);
            if (source == nullptr) {
              std::fill_n(target, i1 - i0, 0.0F);
            } else {
              std::copy_n(source + nodeIndex(i0, j, k), i1 - i0, target);
            }
          }
        }
      }
    }
  }
}

void BlockGrid::clearFixedNodes(std::size_t slot, float* values) const {
  const Coord& block = coords_[slot];
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const Coord other{block[0] + di, block[1] + dj, block[2] + dk};
        const bool beyondTop = std::any_of(other.begin(), other.end(), [&](int c) { return c >= side_; });
        if (beyondTop || this->slot(other) >= 0) {
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
