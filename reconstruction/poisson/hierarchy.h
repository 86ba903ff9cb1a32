#pragma once
// Purpose: the nested levels 3..depth and their right-hand sides. Levels above the dense ones keep unknowns only near the samples;
// at the band's rim the coarser solution stands as the boundary value.

#include <vector>

#include "reconstruction/poisson/splatting.h"

namespace glisson::poisson {

struct Level {
  explicit Level(int level) : grid(level) {}
  BlockGrid grid;
  Field x;  ///< the indicator's coefficients
  Field f;  ///< right-hand side
};

struct HierarchyOptions {
  int kernelLevel = 7;       ///< V lives on this level: its cell is not smaller than a share of the widest sample spacing
  float bandCells = 3.0F;    ///< half width of the band on the finest level, in its cells
  double cellMm = 1.0;       ///< cell of the finest level
  double pointWeight = 0.0;  ///< screening towards X = 1/2 at the samples, 1/mm
};

inline constexpr int kCoarsestLevel = 3;
inline constexpr int kDenseLevel = 6;  ///< 64^3 nodes: cheaper to keep whole than to band

/// The levels' active blocks (index 0 is level 3). Polls cancel.
std::vector<Level> makeLevels(const CubeSamples& samples, const HierarchyOptions& options, const ExecutionContext& context = {});

/// f on every level: V is splatted on the kernel level, carried exactly to finer levels (P) and f to coarser ones (P^T).
void makeRightHandSides(const CubeSamples& samples, const HierarchyOptions& options, std::vector<Level>& levels,
                        const ExecutionContext& context);

/// The value of the finest available coefficient at a node of level levels[n]; coarser levels are interpolated where the band has
/// no block.
float nodeValue(const std::vector<Level>& levels, std::size_t n, const Coord& node);

}  // namespace glisson::poisson
