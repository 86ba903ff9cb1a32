#pragma once
// Purpose: one level of the nested grids: nodes 0..2^level a side, kept in blocks of 8^3 nodes of which only some are active (all
// of them on coarse levels, those near the samples on fine ones). Node (i,j,k) lies at (i,j,k) cells from the cube's low corner;
// the nodes on the cube's surface are zero (Dirichlet). Fields are arrays of 512 floats per active block, i fastest.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/poisson/field.h"

namespace glisson::poisson {

inline constexpr int kBlock = 8;  ///< nodes along a block's side
inline constexpr std::size_t kBlockNodes = 512;
inline constexpr int kHalo = kBlock + 2;  ///< nodes -1..8 of a block
inline constexpr std::size_t kHaloNodes = 1000;

using Coord = std::array<int, 3>;
using Halo = std::array<float, kHaloNodes>;

class BlockGrid {
 public:
  /// level >= 3. No block is active yet.
  explicit BlockGrid(int level);

  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] int blocksPerSide() const { return side_; }
  [[nodiscard]] std::size_t blockCount() const { return coords_.size(); }
  [[nodiscard]] std::size_t nodeCount() const { return coords_.size() * kBlockNodes; }
  /// The active block's number, -1 where it is not active or outside the cube.
  [[nodiscard]] std::int32_t slot(const Coord& block) const {
    for (const int c : block) {
      if (c < 0 || c >= side_) {
        return -1;
      }
    }
    return slots_[linear(block)];
  }
  [[nodiscard]] const Coord& coord(std::size_t slot) const { return coords_[slot]; }
  /// Numbers of the 27 blocks around an active block, (di + 1) + 3 (dj + 1) + 9 (dk + 1); itself is the 14th.
  [[nodiscard]] std::span<const std::int32_t, 27> around(std::size_t slot) const { return around_[slot]; }

  void mark(const Coord& block);  ///< outside the cube: ignored
  void markAll();
  /// Numbers the marked blocks in memory order (deterministic). Blocks marked later are appended by number(): existing numbers
  /// stay.
  void number();

  /// Values of nodes -1..8 of a block; 0 in inactive blocks.
  void gather(const Field& field, std::size_t slot, Halo& halo) const;
  /// Sets to 0 those of the block's 512 values whose 27-neighbourhood leaves the active blocks inside the cube, and those on the
  /// cube's surface: they are not unknowns.
  void clearFixedNodes(std::size_t slot, float* values) const;

 private:
  [[nodiscard]] std::size_t linear(const Coord& b) const {
    return static_cast<std::size_t>(b[0]) +
           static_cast<std::size_t>(side_) *
               (static_cast<std::size_t>(b[1]) + static_cast<std::size_t>(side_) * static_cast<std::size_t>(b[2]));
  }

  int level_;
  int side_;
  std::vector<std::int32_t> slots_;  ///< -1 not active, -2 marked
  std::vector<Coord> coords_;
  std::vector<std::array<std::int32_t, 27>> around_;
};

inline std::size_t haloIndex(int i, int j, int k) {
  return static_cast<std::size_t>((i + 1) + kHalo * ((j + 1) + kHalo * (k + 1)));
}
inline std::size_t nodeIndex(int i, int j, int k) { return static_cast<std::size_t>(i + kBlock * (j + kBlock * k)); }

}  // namespace glisson::poisson
