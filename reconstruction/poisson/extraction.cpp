#include "reconstruction/poisson/extraction.h"

#include <algorithm>
#include <atomic>

#include "reconstruction/parallel.h"
#include "reconstruction/poisson/marching_cases.h"
#include "reconstruction/poisson/operators.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kGrain = 16;
constexpr double kNearest = 1e-3;  // of a cell: keeps vertices off the nodes, so that no triangle collapses

/// Node values -1..8 of a block of the finest level, the nodes of inactive blocks after it taken from coarser levels.
void gatherForExtraction(const std::vector<Level>& levels, std::size_t slot, Halo& halo) {
  const Level& level = levels.back();
  level.grid.gather(level.x, slot, halo);
  const Coord& block = level.grid.coord(slot);
  for (int n = 1; n < 8; ++n) {
    const Coord step{n & 1, (n >> 1) & 1, n >> 2};
    if (level.grid.slot({block[0] + step[0], block[1] + step[1], block[2] + step[2]}) >= 0) {
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

/// The surface passes from a block to the next through the 9x9 nodes they share: mixed signs there.
bool crossesSide(const Halo& halo, float iso, int axis, int layer) {
  bool inside = false;
  bool outside = false;
  for (int v = 0; v <= kBlock; ++v) {
    for (int u = 0; u <= kBlock; ++u) {
      Coord node{};
      node[static_cast<std::size_t>(axis)] = layer;
      node[static_cast<std::size_t>((axis + 1) % 3)] = u;
      node[static_cast<std::size_t>((axis + 2) % 3)] = v;
      (halo[haloIndex(node[0], node[1], node[2])] > iso ? inside : outside) = true;
    }
  }
  return inside && outside;
}

/// Activates the blocks that the surface enters from active ones, until it enters none.
void growBand(std::vector<Level>& levels, float iso, const ExecutionContext& context) {
  Level& level = levels.back();
  for (std::size_t first = 0; first < level.grid.blockCount();) {
    const std::size_t count = level.grid.blockCount() - first;
    std::vector<std::uint8_t> enters(count, 0);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      for (std::size_t n = begin; n < end; ++n) {
        const Coord& block = level.grid.coord(first + n);
        Halo halo;
        bool gathered = false;
        for (int side = 0; side < 6; ++side) {
          Coord next = block;
          next[static_cast<std::size_t>(side / 2)] += (side & 1) != 0 ? 1 : -1;
          const int c = next[static_cast<std::size_t>(side / 2)];
          if (c < 0 || c >= level.grid.blocksPerSide() || level.grid.slot(next) >= 0) {
            continue;
          }
          if (!gathered) {
            gatherForExtraction(levels, first + n, halo);
            gathered = true;
          }
          if (crossesSide(halo, iso, side / 2, (side & 1) != 0 ? kBlock : 0)) {
            enters[n] = static_cast<std::uint8_t>(enters[n] | (1U << side));
          }
        }
      }
    });
    for (std::size_t n = 0; n < count; ++n) {
      for (int side = 0; side < 6; ++side) {
        if ((enters[n] >> side & 1U) != 0) {
          Coord next = level.grid.coord(first + n);
          next[static_cast<std::size_t>(side / 2)] += (side & 1) != 0 ? 1 : -1;
          level.grid.mark(next);
        }
      }
    }
    const std::size_t before = level.grid.blockCount();
    level.grid.number();
    std::vector<float> values(kBlockNodes * (level.grid.blockCount() - before));
    for (std::size_t slot = before; slot < level.grid.blockCount(); ++slot) {
      const Coord& b = level.grid.coord(slot);
      for (int n = 0; n < static_cast<int>(kBlockNodes); ++n) {
        // The new block is not filled yet: read it through the coarser levels.
        const Coord node{b[0] * kBlock + n % 8, b[1] * kBlock + n / 8 % 8, b[2] * kBlock + n / 64};
        float sum = 0;
        for (int c = 0; c < 8; ++c) {
          sum += nodeValue(levels, levels.size() - 2,
                           {(node[0] + (c & 1)) / 2, (node[1] + ((c >> 1) & 1)) / 2, (node[2] + (c >> 2)) / 2});
        }
        const bool onCube = node[0] == 0 || node[1] == 0 || node[2] == 0;
        values[(slot - before) * kBlockNodes + static_cast<std::size_t>(n)] = onCube ? 0.0F : 0.125F * sum;
      }
    }
    level.x.insert(level.x.end(), values.begin(), values.end());
    first = before;
  }
}

/// Vertex numbers of the three edges that start at each node of a block; allocated only where the surface is.
using EdgeVertices = std::vector<std::uint32_t>;
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

struct BlockSurface {
  EdgeVertices ids;  ///< 3 per node
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

void makeVertices(const Halo& halo, float iso, const Coord& block, const Vec3& corner, double cellMm, BlockSurface& out) {
  for (int k = 0; k < kBlock; ++k) {
    for (int j = 0; j < kBlock; ++j) {
      for (int i = 0; i < kBlock; ++i) {
        const float here = halo[haloIndex(i, j, k)];
        for (int axis = 0; axis < 3; ++axis) {
          const float there = halo[haloIndex(i + (axis == 0), j + (axis == 1), k + (axis == 2))];
          if ((here > iso) == (there > iso)) {
            continue;
          }
          if (out.ids.empty()) {
            out.ids.assign(3 * kBlockNodes, kNone);
          }
          const double t = (static_cast<double>(iso) - here) / (static_cast<double>(there) - here);
          Vec3 node(block[0] * kBlock + i, block[1] * kBlock + j, block[2] * kBlock + k);
          node[axis] += std::clamp(t, kNearest, 1.0 - kNearest);
          out.ids[3 * nodeIndex(i, j, k) + static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(out.vertices.size());
          out.vertices.push_back(corner + cellMm * node);
        }
      }
    }
  }
}

class TriangleMaker {
 public:
  TriangleMaker(const BlockGrid& grid, const std::vector<BlockSurface>& surfaces, const std::vector<std::uint32_t>& firstVertex)
      : grid_(grid), surfaces_(surfaces), firstVertex_(firstVertex), cases_(makeMarchingCases()) {}

  void run(const Halo& halo, float iso, const Coord& block, std::vector<Triangle>& out) const {
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        for (int i = 0; i < kBlock; ++i) {
          unsigned inside = 0;
          for (int c = 0; c < 8; ++c) {
            inside |= (halo[haloIndex(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2))] > iso ? 1U : 0U) << c;
          }
          for (const auto& edges : cases_[inside]) {
            out.push_back(
                {vertexOf(block, i, j, k, edges[0]), vertexOf(block, i, j, k, edges[1]), vertexOf(block, i, j, k, edges[2])});
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] std::uint32_t vertexOf(const Coord& block, int i, int j, int k, std::uint8_t edge) const {
    const int from = kEdgeFrom[edge];
    const Coord node{i + (from & 1), j + ((from >> 1) & 1), k + (from >> 2)};
    const auto slot = static_cast<std::size_t>(
        grid_.slot({block[0] + node[0] / kBlock, block[1] + node[1] / kBlock, block[2] + node[2] / kBlock}));
    return firstVertex_[slot] +
           surfaces_[slot].ids[3 * nodeIndex(node[0] % kBlock, node[1] % kBlock, node[2] % kBlock) + edge / 4U];
  }

  const BlockGrid& grid_;
  const std::vector<BlockSurface>& surfaces_;
  const std::vector<std::uint32_t>& firstVertex_;
  MarchingCases cases_;
};

}  // namespace

SurfaceMesh extractSurface(std::vector<Level>& levels, float iso, const Vec3& corner, double cellMm,
                           const ExecutionContext& context) {
  growBand(levels, iso, context);
  const BlockGrid& grid = levels.back().grid;
  std::vector<BlockSurface> surfaces(grid.blockCount());
  parallelFor(grid.blockCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t slot = begin; slot < end; ++slot) {
      Halo halo;
      gatherForExtraction(levels, slot, halo);
      makeVertices(halo, iso, grid.coord(slot), corner, cellMm, surfaces[slot]);
    }
  });
  std::vector<std::uint32_t> firstVertex(grid.blockCount() + 1, 0);
  for (std::size_t slot = 0; slot < surfaces.size(); ++slot) {
    firstVertex[slot + 1] = firstVertex[slot] + static_cast<std::uint32_t>(surfaces[slot].vertices.size());
  }
  const TriangleMaker maker(grid, surfaces, firstVertex);
  parallelFor(grid.blockCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t slot = begin; slot < end; ++slot) {
      Halo halo;
      gatherForExtraction(levels, slot, halo);
      maker.run(halo, iso, grid.coord(slot), surfaces[slot].triangles);
    }
  });
  SurfaceMesh mesh;
  mesh.vertices.reserve(firstVertex.back());
  for (const auto& surface : surfaces) {
    mesh.vertices.insert(mesh.vertices.end(), surface.vertices.begin(), surface.vertices.end());
    mesh.triangles.insert(mesh.triangles.end(), surface.triangles.begin(), surface.triangles.end());
  }
  return mesh;
}

}  // namespace glisson::poisson
