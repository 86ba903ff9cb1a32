#include "reconstruction/poisson/extraction.h"

#include <algorithm>
#include <bit>
#include <memory>

#include "reconstruction/parallel.h"
#include "reconstruction/poisson/marching_cases.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kBlocksAPiece = 32;
constexpr double kNearest = 1e-3;           // of a cell: keeps vertices off the nodes, so that no triangle collapses
constexpr std::size_t kNodes = kBlock + 1;  // nodes 0..8 of a block's cells along a side
constexpr unsigned kAllNodes = (1U << kNodes) - 1;

/// What the surface does in one block's cells. Rows are bits along i.
struct SurfaceBlock {
  std::array<std::uint16_t, kNodes * kNodes> inside{};      ///< row j + 9 k: node (i,j,k) of 0..8 is inside
  std::array<std::uint8_t, 3 * kBlock * kBlock> crossed{};  ///< row j + 8 k + 64 axis: so is the edge from node (i,j,k) along axis
  std::array<std::uint16_t, 3 * kBlock * kBlock> verticesBefore{};  ///< in this block
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t firstVertex = 0;
  std::uint32_t firstTriangle = 0;
};
using SurfaceBlocks = std::vector<std::unique_ptr<SurfaceBlock>>;  ///< per slot; null where no surface passes

std::size_t edgeRow(int axis, int j, int k) { return static_cast<std::size_t>(j + kBlock * (k + kBlock * axis)); }

/// Node values -1..8 of a block of the finest level, the nodes of inactive blocks after it taken from coarser levels.
void gatherForExtraction(const std::vector<Level>& levels, std::size_t slot, Halo& halo) {
  const Level& level = levels.back();
  level.grid.gather(level.x, slot, halo);
  const Coord& block = level.grid.coord(slot);
  const auto around = level.grid.around(slot);
  for (int n = 1; n < 8; ++n) {
    const Coord step{n & 1, (n >> 1) & 1, n >> 2};
    if (around[static_cast<std::size_t>(13 + step[0] + 3 * step[1] + 9 * step[2])] >= 0) {
      continue;
    }
    for (int k = 8 * step[2]; k < 8 + step[2]; ++k) {
      for (int j = 8 * step[1]; j < 8 + step[1]; ++j) {
        for (int i = 8 * step[0]; i < 8 + step[0]; ++i) {
          halo[haloIndex(i, j, k)] =
              nodeValue(levels, levels.size() - 1, {block[0] * kBlock + i, block[1] * kBlock + j, block[2] * kBlock + k});
        }
      }
    }
  }
}

/// The nodes 0..8 that are inside, as rows; false where all or none are.
bool insideRows(const Halo& halo, float iso, std::array<std::uint16_t, kNodes * kNodes>& rows) {
  unsigned any = 0;
  unsigned all = kAllNodes;
  for (std::size_t k = 0; k < kNodes; ++k) {
    for (std::size_t j = 0; j < kNodes; ++j) {
      const float* row = &halo[haloIndex(0, static_cast<int>(j), static_cast<int>(k))];
      unsigned bits = 0;
      for (std::size_t i = 0; i < kNodes; ++i) {
        bits |= (row[i] > iso ? 1U : 0U) << i;
      }
      rows[j + kNodes * k] = static_cast<std::uint16_t>(bits);
      any |= bits;
      all &= bits;
    }
  }
  return any != 0 && all != kAllNodes;
}

/// The case of each of the eight cells of a row, corner c at bit c.
std::array<std::uint8_t, kBlock> casesOfRow(const SurfaceBlock& block, std::size_t j, std::size_t k) {
  const unsigned a = block.inside[j + kNodes * k];
  const unsigned b = block.inside[j + 1 + kNodes * k];
  const unsigned c = block.inside[j + kNodes * (k + 1)];
  const unsigned d = block.inside[j + 1 + kNodes * (k + 1)];
  std::array<std::uint8_t, kBlock> cases{};
  if ((a | b | c | d) != 0 && (a & b & c & d) != kAllNodes) {
    for (unsigned i = 0; i < kBlock; ++i) {
      cases[i] = static_cast<std::uint8_t>(((a >> i) & 3U) | ((b >> i) & 3U) << 2U | ((c >> i) & 3U) << 4U | ((d >> i) & 3U) << 6U);
    }
  }
  return cases;
}

void countSurface(const MarchingCases& cases, SurfaceBlock& block) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        const auto row = [&](int aj, int ak) -> unsigned {
          return block.inside[static_cast<std::size_t>(aj) + kNodes * static_cast<std::size_t>(ak)];
        };
        const unsigned next = axis == 0 ? row(j, k) >> 1U : axis == 1 ? row(j + 1, k) : row(j, k + 1);
        const auto crossed = static_cast<std::uint8_t>(row(j, k) ^ next);  // of nodes 0..7
        block.crossed[edgeRow(axis, j, k)] = crossed;
        block.verticesBefore[edgeRow(axis, j, k)] = static_cast<std::uint16_t>(block.vertices);
        block.vertices += static_cast<unsigned>(std::popcount(crossed));
      }
    }
  }
  for (std::size_t k = 0; k < kBlock; ++k) {
    for (std::size_t j = 0; j < kBlock; ++j) {
      for (const std::uint8_t inside : casesOfRow(block, j, k)) {
        block.triangles += static_cast<std::uint32_t>(cases[inside].size());
      }
    }
  }
}

/// Looks at the blocks from `first` on.
void findSurface(const std::vector<Level>& levels, float iso, std::size_t first, const MarchingCases& cases, SurfaceBlocks& blocks,
                 const ExecutionContext& context) {
  blocks.resize(levels.back().grid.blockCount());
  parallelFor(blocks.size() - first, kBlocksAPiece, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t slot = first + begin; slot < first + end; ++slot) {
      Halo halo;
      gatherForExtraction(levels, slot, halo);
      SurfaceBlock block;
      if (insideRows(halo, iso, block.inside)) {
        countSurface(cases, block);
        blocks[slot] = std::make_unique<SurfaceBlock>(block);
      }
    }
  });
}

/// The surface passes from a block to the next through the 9x9 nodes they share: mixed signs there.
bool crossesSide(const SurfaceBlock& block, int axis, bool high) {
  unsigned any = 0;
  unsigned all = kAllNodes;
  for (std::size_t n = 0; n < kNodes; ++n) {
    for (std::size_t m = 0; m < kNodes; ++m) {
      const std::size_t layer = high ? kBlock : 0;
      const unsigned row = axis == 0   ? block.inside[n + kNodes * m]
                           : axis == 1 ? block.inside[layer + kNodes * n]
                                       : block.inside[n + kNodes * layer];
      // Across axis 0 a row has one node of the side, otherwise all its nodes lie on it.
      const unsigned bits = axis != 0 ? row : ((row >> layer) & 1U) != 0 ? kAllNodes : 0U;
      any |= bits;
      all &= bits;
    }
  }
  return any != 0 && all != kAllNodes;
}

/// Marks the inactive blocks that the surface enters from blocks numbered `first` or later.
void markEntered(const SurfaceBlocks& blocks, std::size_t first, BlockGrid& grid) {
  for (std::size_t slot = first; slot < blocks.size(); ++slot) {
    if (!blocks[slot]) {
      continue;
    }
    for (int side = 0; side < 6; ++side) {
      Coord next = grid.coord(slot);
      const auto axis = static_cast<std::size_t>(side / 2);
      const bool high = (side & 1) != 0;
      next[axis] += high ? 1 : -1;
      if (grid.slot(next) == -1 && crossesSide(*blocks[slot], side / 2, high)) {
        grid.mark(next);
      }
    }
  }
}

/// The coefficients of the blocks from `first` on, from the coarser level.
void fillFromCoarser(std::vector<Level>& levels, std::size_t first) {
  Level& level = levels.back();
  level.x.resize(level.grid.nodeCount());
  for (std::size_t slot = first; slot < level.grid.blockCount(); ++slot) {
    const Coord& b = level.grid.coord(slot);
    for (int n = 0; n < static_cast<int>(kBlockNodes); ++n) {
      const Coord node{b[0] * kBlock + n % 8, b[1] * kBlock + n / 8 % 8, b[2] * kBlock + n / 64};
      const bool onCube = node[0] == 0 || node[1] == 0 || node[2] == 0;
      float sum = 0;
      for (int c = 0; c < 8 && !onCube; ++c) {
        sum += nodeValue(levels, levels.size() - 2,
                         {(node[0] + (c & 1)) / 2, (node[1] + ((c >> 1) & 1)) / 2, (node[2] + (c >> 2)) / 2});
      }
      level.x[slot * kBlockNodes + static_cast<std::size_t>(n)] = 0.125F * sum;
    }
  }
}

/// The blocks that the surface passes through; the band is grown until it enters no inactive one.
SurfaceBlocks findWholeSurface(std::vector<Level>& levels, float iso, const MarchingCases& cases, const ExecutionContext& context) {
  SurfaceBlocks blocks;
  BlockGrid& grid = levels.back().grid;
  for (std::size_t first = 0; first < grid.blockCount();) {
    findSurface(levels, iso, first, cases, blocks, context);
    markEntered(blocks, first, grid);
    first = grid.blockCount();
    grid.number();
    fillFromCoarser(levels, first);
  }
  return blocks;
}

class SurfaceWriter {
 public:
  SurfaceWriter(const std::vector<Level>& levels, const SurfaceBlocks& blocks, const MarchingCases& cases, float iso,
                const Vec3& corner, double cellMm, SurfaceMesh& mesh)
      : levels_(levels), blocks_(blocks), cases_(cases), iso_(iso), corner_(corner), cellMm_(cellMm), mesh_(mesh) {}

  void writeVertices(std::size_t slot) const {
    Halo halo;
    gatherForExtraction(levels_, slot, halo);
    const SurfaceBlock& block = *blocks_[slot];
    const Coord& at = levels_.back().grid.coord(slot);
    Vec3* to = mesh_.vertices.data() + block.firstVertex;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t step = axis == 0 ? 1 : axis == 1 ? kHalo : kHalo * kHalo;
      for (int k = 0; k < kBlock; ++k) {
        for (int j = 0; j < kBlock; ++j) {
          for (unsigned left = block.crossed[edgeRow(axis, j, k)]; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            const std::size_t node = haloIndex(i, j, k);
            const double here = halo[node];
            const double t = (static_cast<double>(iso_) - here) / (static_cast<double>(halo[node + step]) - here);
            Vec3 p(at[0] * kBlock + i, at[1] * kBlock + j, at[2] * kBlock + k);
            p[axis] += std::clamp(t, kNearest, 1.0 - kNearest);
            *to++ = corner_ + cellMm_ * p;
          }
        }
      }
    }
  }

  void writeTriangles(std::size_t slot) const {
    const SurfaceBlock& block = *blocks_[slot];
    Triangle* to = mesh_.triangles.data() + block.firstTriangle;
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        const auto row = casesOfRow(block, static_cast<std::size_t>(j), static_cast<std::size_t>(k));
        for (int i = 0; i < kBlock; ++i) {
          for (const auto& edges : cases_[row[static_cast<std::size_t>(i)]]) {
            *to++ = {vertexOf(slot, {i, j, k}, edges[0]), vertexOf(slot, {i, j, k}, edges[1]), vertexOf(slot, {i, j, k}, edges[2])};
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] std::uint32_t vertexOf(std::size_t slot, const Coord& cell, std::uint8_t edge) const {
    const int from = kEdgeFrom[edge];
    const Coord node{cell[0] + (from & 1), cell[1] + ((from >> 1) & 1), cell[2] + (from >> 2)};
    const int beyond = node[0] / kBlock + 3 * (node[1] / kBlock) + 9 * (node[2] / kBlock);
    const auto owner =
        beyond == 0 ? slot : static_cast<std::size_t>(levels_.back().grid.around(slot)[static_cast<std::size_t>(13 + beyond)]);
    const SurfaceBlock& block = *blocks_[owner];
    const std::size_t row = edgeRow(edge / 4, node[1] % kBlock, node[2] % kBlock);
    const unsigned before = block.crossed[row] & ((1U << (node[0] % kBlock)) - 1U);
    return block.firstVertex + block.verticesBefore[row] + static_cast<unsigned>(std::popcount(before));
  }

  const std::vector<Level>& levels_;
  const SurfaceBlocks& blocks_;
  const MarchingCases& cases_;
  float iso_;
  Vec3 corner_;
  double cellMm_;
  SurfaceMesh& mesh_;
};

}  // namespace

SurfaceMesh extractSurface(std::vector<Level>& levels, float iso, const Vec3& corner, double cellMm,
                           const ExecutionContext& context) {
  const MarchingCases cases = makeMarchingCases();
  const SurfaceBlocks blocks = findWholeSurface(levels, iso, cases, context);
  SurfaceMesh mesh;
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::vector<std::size_t> slots;
  for (std::size_t slot = 0; slot < blocks.size(); ++slot) {
    if (blocks[slot]) {
      blocks[slot]->firstVertex = vertices;
      blocks[slot]->firstTriangle = triangles;
      vertices += blocks[slot]->vertices;
      triangles += blocks[slot]->triangles;
      slots.push_back(slot);
    }
  }
  mesh.vertices.resize(vertices);
  mesh.triangles.resize(triangles);
  const SurfaceWriter writer(levels, blocks, cases, iso, corner, cellMm, mesh);
  parallelFor(slots.size(), kBlocksAPiece, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t n = begin; n < end; ++n) {
      writer.writeVertices(slots[n]);
      writer.writeTriangles(slots[n]);
    }
  });
  return mesh;
}

}  // namespace glisson::poisson
