#include "reconstruction/poisson/hierarchy.h"

#include <algorithm>

namespace glisson::poisson {

namespace {

/// Marks the blocks of a level within `reach` cells (of that level) of a sample.
void markNearSamples(const CubeSamples& samples, float reach, BlockGrid& grid) {
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  const auto blockAt = [&](float p) {
    return std::clamp(static_cast<int>(std::max(p, 0.0F)) / kBlock, 0, grid.blocksPerSide() - 1);
  };
  Coord lastLow{-1, -1, -1};
  Coord lastHigh{};
  for (const auto& position : samples.positions) {
    Coord low{};
    Coord high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = blockAt(position[a] * scale - reach);
      high[a] = blockAt(position[a] * scale + 1 + reach);
    }
    if (low == lastLow && high == lastHigh) {
      continue;  // neighbours mark the same blocks
    }
    lastLow = low;
    lastHigh = high;
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          grid.mark({i, j, k});
        }
      }
    }
  }
}

/// Every coarse block that a fine block is prolonged from: the one under it and those that hold the node after.
void markParents(const BlockGrid& fine, BlockGrid& coarse) {
  for (std::size_t n = 0; n < fine.blockCount(); ++n) {
    const Coord& b = fine.coord(n);
    for (int c = 0; c < 8; ++c) {
      coarse.mark({(b[0] + (c & 1)) / 2, (b[1] + ((c >> 1) & 1)) / 2, (b[2] + (c >> 2)) / 2});
    }
  }
}

VectorField prolonged(const BlockGrid& coarseGrid, const VectorField& v, const BlockGrid& fineGrid,
                      const ExecutionContext& context) {
  VectorField fine;
  for (std::size_t a = 0; a < 3; ++a) {
    fine[a] = Field(fineGrid.nodeCount());
    prolong(coarseGrid, v[a], fineGrid, fine[a], context);
  }
  return fine;
}

}  // namespace

std::vector<Level> makeLevels(const CubeSamples& samples, const HierarchyOptions& options, const ExecutionContext& context) {
  std::vector<Level> levels;
  for (int l = kCoarsestLevel; l <= samples.depth; ++l) {
    levels.emplace_back(l);
  }
  for (std::size_t n = levels.size(); n-- > 0;) {
    context.throwIfCancelled();
    Level& level = levels[n];
    if (level.grid.level() <= kDenseLevel) {
      level.grid.markAll();
    } else {
      const float cells = options.bandCells / static_cast<float>(1 << (samples.depth - level.grid.level()));
      markNearSamples(samples, std::max(3.0F, cells), level.grid);
      context.throwIfCancelled();
      if (n + 1 < levels.size()) {
        markParents(levels[n + 1].grid, level.grid);
      }
    }
    level.grid.number();
  }
  return levels;
}

void makeRightHandSides(const CubeSamples& samples, const HierarchyOptions& options, std::vector<Level>& levels,
                        const ExecutionContext& context) {
  const auto kernel = static_cast<std::size_t>(options.kernelLevel - kCoarsestLevel);
  const auto cellOf = [&](std::size_t n) { return options.cellMm * (1 << (samples.depth - levels[n].grid.level())); };
  VectorField v;
  for (Field& component : v) {
    component = zeroField(levels[kernel].grid.nodeCount());
  }
  splatNormals(samples, levels[kernel].grid, static_cast<float>(-1.0 / std::pow(cellOf(kernel), 3)), v, context);
  for (std::size_t n = kernel; n < levels.size(); ++n) {
    Level& level = levels[n];
    level.f = Field(level.grid.nodeCount());
    const auto factor = static_cast<float>(cellOf(n));
    if (n == kernel) {
      divergence(level.grid, v, factor, level.f, context);
    } else {
      divergenceOfCoarse(levels[n - 1].grid, v, level.grid, factor, level.f, context);
      if (n + 1 < levels.size()) {
        v = prolonged(levels[n - 1].grid, v, level.grid, context);
      }
    }
  }
  for (std::size_t n = kernel; n-- > 0;) {
    levels[n].f = Field(levels[n].grid.nodeCount());
    restrictTo(levels[n + 1].grid, levels[n + 1].f, levels[n].grid, levels[n].f, 0.5F, context);
  }
}

float nodeValue(const std::vector<Level>& levels, std::size_t n, const Coord& node) {
  const int side = 1 << levels[n].grid.level();
  if (std::any_of(node.begin(), node.end(), [side](int c) { return c <= 0 || c >= side; })) {
    return 0.0F;
  }
  const std::int32_t slot = levels[n].grid.slot({node[0] / kBlock, node[1] / kBlock, node[2] / kBlock});
  if (slot >= 0) {
    return levels[n]
        .x[static_cast<std::size_t>(slot) * kBlockNodes + nodeIndex(node[0] % kBlock, node[1] % kBlock, node[2] % kBlock)];
  }
  float sum = 0;
  for (int c = 0; c < 8; ++c) {
    sum += nodeValue(levels, n - 1, {(node[0] + (c & 1)) / 2, (node[1] + ((c >> 1) & 1)) / 2, (node[2] + (c >> 2)) / 2});
  }
  return 0.125F * sum;
}

}  // namespace glisson::poisson
