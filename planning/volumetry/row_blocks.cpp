#include "planning/volumetry/row_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glisson {

namespace {
/// Longer along the runs: what remains of a run is walked along in steps.
const Vec3 kBlockMm(10, 5, 5);

using Place = std::array<int, 3>;

struct BlockPiece {
  Place block;  ///< along k, j, i
  RowRun run;
  std::size_t origin = 0;
};

Box around(const std::vector<RowRun>& runs, std::size_t begin, std::size_t end, const Vec3& spacing) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (std::size_t n = begin; n < end; ++n) {
    const Box box = boxOf(runs[n], spacing);
    low = low.cwiseMin(box.centre - box.half);
    high = high.cwiseMax(box.centre + box.half);
  }
  return {0.5 * (low + high), 0.5 * (high - low)};
}
}  // namespace

RowBlocks::RowBlocks(const VoxelRows& whole, const Vec3& spacing) {
  if (whole.runs.empty()) {
    return;
  }
  const auto voxelsAlong = [&](int axis) { return std::max(1, static_cast<int>(std::lround(kBlockMm[axis] / spacing[axis]))); };
  const Place size{voxelsAlong(2), voxelsAlong(1), voxelsAlong(0)};
  Place first{whole.runs[0].k, whole.runs[0].j, whole.runs[0].i};
  for (const RowRun& run : whole.runs) {
    first = {std::min(first[0], run.k), std::min(first[1], run.j), std::min(first[2], run.i)};
  }
  std::vector<BlockPiece> pieces;
  for (std::size_t n = 0; n < whole.runs.size(); ++n) {
    const RowRun& run = whole.runs[n];
    for (int i = run.i; i < run.i + run.n;) {
      const Place block{(run.k - first[0]) / size[0], (run.j - first[1]) / size[1], (i - first[2]) / size[2]};
      const int end = std::min(run.i + run.n, first[2] + (block[2] + 1) * size[2]);
      pieces.push_back({block, {i, run.j, run.k, end - i}, n});
      i = end;
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const BlockPiece& a, const BlockPiece& b) { return a.block < b.block; });
  rows.voxels = whole.voxels;
  rows.runs.reserve(pieces.size());
  origin.reserve(pieces.size());
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    if (n == 0 || pieces[n].block != pieces[n - 1].block) {
      blocks.emplace_back().begin = n;
    }
    rows.runs.push_back(pieces[n].run);
    origin.push_back(pieces[n].origin);
    blocks.back().end = n + 1;
    blocks.back().voxels += static_cast<std::size_t>(pieces[n].run.n);
  }
  for (RowBlock& block : blocks) {
    block.box = around(rows.runs, block.begin, block.end, spacing);
  }
}

}  // namespace glisson
