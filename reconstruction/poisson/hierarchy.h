#pragma once
// Purpose: the nested levels 3..depth and the solution of S X = f on them by cascadic conjugate gradients (Deuflhard 1994;
// Bornemann and Deuflhard 1996): each level starts from the coarser level's solution and needs only a few steps. Levels above the
// dense ones keep unknowns only near the samples; at the band's rim the coarser solution stands as the boundary value.

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
  int kernelLevel = 7;       ///< V lives on this level: its cell is not smaller than half the widest sample spacing
  float bandCells = 3.0F;    ///< half width of the band on the finest level, in its cells
  double cellMm = 1.0;       ///< cell of the finest level
  double pointWeight = 0.0;  ///< screening towards X = 1/2 at the samples, 1/mm
};

inline constexpr int kCoarsestLevel = 3;

/// Builds the levels (index 0 is level 3), splats V, solves; the result is x on every level.
std::vector<Level> solveIndicator(const CubeSamples& samples, const HierarchyOptions& options, const ExecutionContext& context);

/// The value of the finest available coefficient at a node of level levels[n]; coarser levels are interpolated where the band has
/// no block.
float nodeValue(const std::vector<Level>& levels, std::size_t n, const Coord& node);

}  // namespace glisson::poisson
