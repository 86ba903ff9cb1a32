#include "reconstruction/poisson/operators.h"

#include "reconstruction/parallel.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kGrain = 16;  // blocks a piece: far below 100 ms of work, so a cancel is seen in time
constexpr float kSixth = 1.0F / 6.0F;

template <typename Body>
void forBlocks(const BlockGrid& grid, std::size_t first, const ExecutionContext& context, Body&& body) {
  parallelFor(grid.blockCount() - first, kGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t slot = first + begin; slot < first + end; ++slot) {
      body(slot);
    }
  });
}

using Rows = std::array<float, kBlock * kHalo * kHalo>;     // i reduced to 0..7, j and k still -1..8
using Sheets = std::array<float, kBlock * kBlock * kHalo>;  // i and j reduced

float massOf(float low, float mid, float high) { return (low + 4.0F * mid + high) * kSixth; }
float stiffnessOf(float low, float mid, float high) { return 2.0F * mid - low - high; }

/// Sum factorisation: x, then y, then z, each a 3-point stencil.
void stiffnessOfBlock(const Halo& u, float* out) {
  Rows mx;
  Rows kx;
  for (std::size_t row = 0; row < kHalo * kHalo; ++row) {
    const float* in = u.data() + row * kHalo;
    for (std::size_t i = 0; i < kBlock; ++i) {
      mx[row * kBlock + i] = massOf(in[i], in[i + 1], in[i + 2]);
      kx[row * kBlock + i] = stiffnessOf(in[i], in[i + 1], in[i + 2]);
    }
  }
  Sheets mm;
  Sheets mixed;
  for (std::size_t k = 0; k < kHalo; ++k) {
    for (std::size_t j = 0; j < kBlock; ++j) {
      const std::size_t row = (j + kHalo * k) * kBlock;
      const std::size_t to = (j + kBlock * k) * kBlock;
      for (std::size_t i = 0; i < kBlock; ++i) {
        mm[to + i] = massOf(mx[row + i], mx[row + kBlock + i], mx[row + 2 * kBlock + i]);
        mixed[to + i] = stiffnessOf(mx[row + i], mx[row + kBlock + i], mx[row + 2 * kBlock + i]) +
                        massOf(kx[row + i], kx[row + kBlock + i], kx[row + 2 * kBlock + i]);
      }
    }
  }
  constexpr std::size_t kSheet = kBlock * kBlock;
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    out[n] = stiffnessOf(mm[n], mm[n + kSheet], mm[n + 2 * kSheet]) + massOf(mixed[n], mixed[n + kSheet], mixed[n + 2 * kSheet]);
  }
}

/// One 1D stencil per axis: D on `axis`, M on the two others.
void divergenceOfBlock(const Halo& v, int axis, float factor, float* out) {
  const auto stencil = [axis](int a, float low, float mid, float high) {
    return a == axis ? 0.5F * (low - high) : massOf(low, mid, high);
  };
  Rows x;
  for (std::size_t row = 0; row < kHalo * kHalo; ++row) {
    const float* in = v.data() + row * kHalo;
    for (std::size_t i = 0; i < kBlock; ++i) {
      x[row * kBlock + i] = stencil(0, in[i], in[i + 1], in[i + 2]);
    }
  }
  Sheets y;
  for (std::size_t k = 0; k < kHalo; ++k) {
    for (std::size_t j = 0; j < kBlock; ++j) {
      const std::size_t row = (j + kHalo * k) * kBlock;
      for (std::size_t i = 0; i < kBlock; ++i) {
        y[(j + kBlock * k) * kBlock + i] = stencil(1, x[row + i], x[row + kBlock + i], x[row + 2 * kBlock + i]);
      }
    }
  }
  constexpr std::size_t kSheet = kBlock * kBlock;
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    out[n] += factor * stencil(2, y[n], y[n + kSheet], y[n + 2 * kSheet]);
  }
}

}  // namespace

void applyStiffness(const BlockGrid& grid, const Field& u, Field& out, const ExecutionContext& context) {
  forBlocks(grid, 0, context, [&](std::size_t slot) {
    Halo halo;
    grid.gather(u, slot, halo);
    float* target = out.data() + slot * kBlockNodes;
    stiffnessOfBlock(halo, target);
    grid.clearFixedNodes(slot, target);
  });
}

void addDivergence(const BlockGrid& grid, const Field& v, int axis, float factor, Field& out, const ExecutionContext& context) {
  forBlocks(grid, 0, context, [&](std::size_t slot) {
    Halo halo;
    grid.gather(v, slot, halo);
    divergenceOfBlock(halo, axis, factor, out.data() + slot * kBlockNodes);
  });
}

void prolong(const BlockGrid& coarseGrid, const Field& coarse, const BlockGrid& fineGrid, Field& fine, std::size_t firstSlot,
             const ExecutionContext& context) {
  forBlocks(fineGrid, firstSlot, context, [&](std::size_t slot) {
    const Coord& block = fineGrid.coord(slot);
    // Coarse nodes 4b..4b+4 per axis: one half of a coarse block and the node after it.
    constexpr int kCorner = kBlock / 2 + 1;
    std::array<float, kCorner * kCorner * kCorner> part{};
    for (int k = 0; k < kCorner; ++k) {
      for (int j = 0; j < kCorner; ++j) {
        for (int i = 0; i < kCorner; ++i) {
          const Coord node{4 * block[0] + i, 4 * block[1] + j, 4 * block[2] + k};
          const std::int32_t at = coarseGrid.slot({node[0] / kBlock, node[1] / kBlock, node[2] / kBlock});
          if (at >= 0) {
            part[static_cast<std::size_t>(i + kCorner * (j + kCorner * k))] =
                coarse[static_cast<std::size_t>(at) * kBlockNodes +
                       nodeIndex(node[0] % kBlock, node[1] % kBlock, node[2] % kBlock)];
          }
        }
      }
    }
    float* target = fine.data() + slot * kBlockNodes;
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        for (int i = 0; i < kBlock; ++i) {
          float sum = 0;
          for (int c = 0; c < 8; ++c) {
            const int ci = (i + (c & 1)) / 2, cj = (j + ((c >> 1) & 1)) / 2, ck = (k + (c >> 2)) / 2;
            sum += part[static_cast<std::size_t>(ci + kCorner * (cj + kCorner * ck))];
          }
          target[nodeIndex(i, j, k)] = 0.125F * sum;
        }
      }
    }
  });
}

namespace {
constexpr int kUnder = 2 * kBlock + 1;  // fine nodes -1..15 under the coarse nodes 0..7 of a block
using Under = std::array<float, std::size_t{kUnder} * kUnder * kUnder>;

/// The fine nodes under a coarse block; 0 where the fine level has no block.
void gatherUnder(const BlockGrid& fineGrid, const Field& fine, const Coord& block, Under& under) {
  under.fill(0.0F);
  for (int n = 0; n < 27; ++n) {
    const Coord part{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};  // -1: only the last layer of the fine block before
    const std::int32_t slot = fineGrid.slot({2 * block[0] + part[0], 2 * block[1] + part[1], 2 * block[2] + part[2]});
    if (slot < 0) {
      continue;
    }
    const float* source = fine.data() + static_cast<std::size_t>(slot) * kBlockNodes;
    const auto first = [&](std::size_t a) { return part[a] < 0 ? kBlock - 1 : 0; };
    for (int k = first(2); k < kBlock; ++k) {
      for (int j = first(1); j < kBlock; ++j) {
        const int to = kBlock * part[0] + first(0) + 1 + kUnder * (kBlock * part[1] + j + 1 + kUnder * (kBlock * part[2] + k + 1));
        std::copy_n(source + nodeIndex(first(0), j, k), kBlock - first(0), under.begin() + to);
      }
    }
  }
}

float halved(float low, float mid, float high) { return 0.5F * (low + high) + mid; }
}  // namespace

void restrictTo(const BlockGrid& fineGrid, const Field& fine, const BlockGrid& coarseGrid, Field& coarse, float factor,
                const ExecutionContext& context) {
  forBlocks(coarseGrid, 0, context, [&](std::size_t slot) {
    Under under;
    gatherUnder(fineGrid, fine, coarseGrid.coord(slot), under);
    constexpr std::size_t kRows = std::size_t{kUnder} * kUnder;
    std::array<float, kBlock * kRows> x;
    for (std::size_t row = 0; row < kRows; ++row) {
      const float* in = under.data() + row * kUnder;
      for (std::size_t i = 0; i < kBlock; ++i) {
        x[row * kBlock + i] = halved(in[2 * i], in[2 * i + 1], in[2 * i + 2]);
      }
    }
    std::array<float, std::size_t{kBlock} * kBlock * kUnder> y;
    for (std::size_t k = 0; k < kUnder; ++k) {
      for (std::size_t j = 0; j < kBlock; ++j) {
        const float* in = x.data() + (2 * j + kUnder * k) * kBlock;
        for (std::size_t i = 0; i < kBlock; ++i) {
          y[(j + kBlock * k) * kBlock + i] = halved(in[i], in[kBlock + i], in[2 * kBlock + i]);
        }
      }
    }
    constexpr std::size_t kSheet = std::size_t{kBlock} * kBlock;
    float* target = coarse.data() + slot * kBlockNodes;
    for (std::size_t k = 0; k < kBlock; ++k) {
      const float* in = y.data() + 2 * k * kSheet;
      for (std::size_t n = 0; n < kSheet; ++n) {
        target[k * kSheet + n] = factor * halved(in[n], in[kSheet + n], in[2 * kSheet + n]);
      }
    }
  });
}

}  // namespace glisson::poisson
