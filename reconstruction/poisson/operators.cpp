#include "reconstruction/poisson/operators.h"

#include <cstring>

#include "reconstruction/parallel.h"
#include "reconstruction/wide.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kOperatorsGrain = 32;  // blocks a piece: far below 100 ms of work, so a cancel is seen in time
constexpr std::size_t kSheet = std::size_t{kBlock} * kBlock;
constexpr float kSixth = 1.0F / 6.0F;

template <typename Body>
void forBlocks(const BlockGrid& grid, const ExecutionContext& context, Body&& body) {
  parallelFor(grid.blockCount(), kOperatorsGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t slot = begin; slot < end; ++slot) {
      body(slot);
    }
  });
}

using Rows = std::array<float, kBlock * kHalo * kHalo>;     // i reduced to 0..7, j and k still -1..8
using Sheets = std::array<float, kBlock * kBlock * kHalo>;  // i and j reduced

inline float massOf(float low, float mid, float high) { return (low + 4.0F * mid + high) * kSixth; }
inline float stiffnessOf(float low, float mid, float high) { return 2.0F * mid - low - high; }
inline float slopeOf(float low, float high) { return 0.5F * (low - high); }
inline float halved(float low, float mid, float high) { return 0.5F * (low + high) + mid; }

/// Sum factorisation: x, then y, then z, each a 3-point stencil.
GLISSON_WIDE void stiffnessOfBlock(const float* u, float* out) {
  Rows mx;
  Rows kx;
  for (std::size_t row = 0; row < kHalo * kHalo; ++row) {
    const float* in = u + row * kHalo;
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
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    out[n] = stiffnessOf(mm[n], mm[n + kSheet], mm[n + 2 * kSheet]) + massOf(mixed[n], mixed[n + kSheet], mixed[n + 2 * kSheet]);
  }
}

/// Each 1D stencil once: D on one axis, M on the two others, summed over the three components.
GLISSON_WIDE void divergenceOfBlock(const float* vx, const float* vy, const float* vz, float factor, float* out) {
  Rows dx;
  Rows mx;
  Rows nx;
  for (std::size_t row = 0; row < kHalo * kHalo; ++row) {
    const std::size_t at = row * kHalo;
    for (std::size_t i = 0; i < kBlock; ++i) {
      dx[row * kBlock + i] = slopeOf(vx[at + i], vx[at + i + 2]);
      mx[row * kBlock + i] = massOf(vy[at + i], vy[at + i + 1], vy[at + i + 2]);
      nx[row * kBlock + i] = massOf(vz[at + i], vz[at + i + 1], vz[at + i + 2]);
    }
  }
  Sheets across;  // components 0 and 1, z still to be averaged
  Sheets along;   // component 2, z still to be differenced
  for (std::size_t k = 0; k < kHalo; ++k) {
    for (std::size_t j = 0; j < kBlock; ++j) {
      const std::size_t row = (j + kHalo * k) * kBlock;
      const std::size_t to = (j + kBlock * k) * kBlock;
      for (std::size_t i = 0; i < kBlock; ++i) {
        const std::size_t n = row + i;
        across[to + i] = massOf(dx[n], dx[n + kBlock], dx[n + 2 * kBlock]) + slopeOf(mx[n], mx[n + 2 * kBlock]);
        along[to + i] = massOf(nx[n], nx[n + kBlock], nx[n + 2 * kBlock]);
      }
    }
  }
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    out[n] = factor * (massOf(across[n], across[n + kSheet], across[n + 2 * kSheet]) + slopeOf(along[n], along[n + 2 * kSheet]));
  }
}

void subtractFrom(const float* f, float* values) {
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    values[n] = f[n] - values[n];
  }
}

void advance(const float* x, const float* residual, float momentum, float step, float* before) {
  if (momentum == 0) {
    for (std::size_t n = 0; n < kBlockNodes; ++n) {
      before[n] = x[n] + step * residual[n];
    }
    return;
  }
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    before[n] = x[n] + momentum * (x[n] - before[n]) + step * residual[n];
  }
}

/// Fine nodes from coarse ones along the slowest axis of `in`: out[2c] = in[c], out[2c + 1] = (in[c] + in[c + 1]) / 2, where each
/// is a row of `width` values. `first` is 1 where the fine nodes begin between two coarse ones.
inline void interpolateRows(const float* in, std::size_t width, std::size_t first, std::size_t count, float* out) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t fine = n + first;
    const float* low = in + fine / 2 * width;
    float* to = out + n * width;
    if (fine % 2 == 0) {
      for (std::size_t i = 0; i < width; ++i) {
        to[i] = low[i];
      }
    } else {
      for (std::size_t i = 0; i < width; ++i) {
        to[i] = 0.5F * (low[i] + low[width + i]);
      }
    }
  }
}

/// The values at kFine^3 fine nodes from the halo of the coarse block above: fine nodes 0..7 (kFine 8) or -1..8 (kFine 10) of the
/// fine block that begins at coarse node `half` (0 or 4 per axis).
template <std::size_t kFine>
void prolongBlock(const Halo& coarse, const Coord& half, float* out) {
  constexpr bool kWithHalo = kFine == kHalo;
  constexpr std::size_t kFirst = kWithHalo ? 1 : 0;  // fine node -1 lies between two coarse ones
  constexpr std::size_t kCoarse = kFine / 2 + 1;     // coarse nodes that the fine ones lie between
  constexpr int kBefore = kWithHalo ? -1 : 0;        // the first of them
  std::array<float, kFine * kCoarse * kCoarse> x;
  for (std::size_t k = 0; k < kCoarse; ++k) {
    for (std::size_t j = 0; j < kCoarse; ++j) {
      const float* in =
          &coarse[haloIndex(half[0] + kBefore, half[1] + kBefore + static_cast<int>(j), half[2] + kBefore + static_cast<int>(k))];
      float* to = &x[kFine * (j + kCoarse * k)];
      for (std::size_t n = 0; n < kFine; ++n) {
        const std::size_t fine = n + kFirst;
        to[n] = fine % 2 == 0 ? in[fine / 2] : 0.5F * (in[fine / 2] + in[fine / 2 + 1]);
      }
    }
  }
  std::array<float, kFine * kFine * kCoarse> y;
  for (std::size_t k = 0; k < kCoarse; ++k) {
    interpolateRows(&x[kFine * kCoarse * k], kFine, kFirst, kFine, &y[kFine * kFine * k]);
  }
  interpolateRows(y.data(), kFine * kFine, kFirst, kFine, out);
}

/// Gathers the coarse block over a fine one and says where in it the fine one begins.
Coord gatherOver(const BlockGrid& coarseGrid, const Field& coarse, const Coord& fineBlock, Halo& halo) {
  const std::int32_t slot = coarseGrid.slot({fineBlock[0] / 2, fineBlock[1] / 2, fineBlock[2] / 2});
  if (slot < 0) {
    halo.fill(0.0F);
  } else {
    coarseGrid.gather(coarse, static_cast<std::size_t>(slot), halo);
  }
  constexpr int kHalf = kBlock / 2;
  return {kHalf * (fineBlock[0] % 2), kHalf * (fineBlock[1] % 2), kHalf * (fineBlock[2] % 2)};
}

}  // namespace

void applyStiffness(const BlockGrid& grid, const Field& u, Field& out, const ExecutionContext& context) {
  forBlocks(grid, context, [&](std::size_t slot) {
    Halo halo;
    grid.gather(u, slot, halo);
    float* target = out.data() + slot * kBlockNodes;
    stiffnessOfBlock(halo.data(), target);
    grid.clearFixedNodes(slot, target);
  });
}

void iterate(const BlockGrid& grid, const Field& x, const Field& f, float momentum, float step, Field& before,
             const ExecutionContext& context) {
  forBlocks(grid, context, [&](std::size_t slot) {
    Halo halo;
    grid.gather(x, slot, halo);
    std::array<float, kBlockNodes> residual;
    stiffnessOfBlock(halo.data(), residual.data());
    const std::size_t at = slot * kBlockNodes;
    subtractFrom(f.data() + at, residual.data());
    grid.clearFixedNodes(slot, residual.data());
    advance(x.data() + at, residual.data(), momentum, step, before.data() + at);
  });
}

void divergence(const BlockGrid& grid, const VectorField& v, float factor, Field& f, const ExecutionContext& context) {
  forBlocks(grid, context, [&](std::size_t slot) {
    std::array<Halo, 3> halos;
    for (std::size_t a = 0; a < 3; ++a) {
      grid.gather(v[a], slot, halos[a]);
    }
    divergenceOfBlock(halos[0].data(), halos[1].data(), halos[2].data(), factor, f.data() + slot * kBlockNodes);
  });
}

void divergenceOfCoarse(const BlockGrid& coarseGrid, const VectorField& v, const BlockGrid& fineGrid, float factor, Field& f,
                        const ExecutionContext& context) {
  forBlocks(fineGrid, context, [&](std::size_t slot) {
    std::array<Halo, 3> halos;
    for (std::size_t a = 0; a < 3; ++a) {
      Halo over;
      const Coord half = gatherOver(coarseGrid, v[a], fineGrid.coord(slot), over);
      prolongBlock<kHalo>(over, half, halos[a].data());
    }
    divergenceOfBlock(halos[0].data(), halos[1].data(), halos[2].data(), factor, f.data() + slot * kBlockNodes);
  });
}

void prolong(const BlockGrid& coarseGrid, const Field& coarse, const BlockGrid& fineGrid, Field& fine,
             const ExecutionContext& context) {
  forBlocks(fineGrid, context, [&](std::size_t slot) {
    Halo over;
    const Coord half = gatherOver(coarseGrid, coarse, fineGrid.coord(slot), over);
    prolongBlock<kBlock>(over, half, fine.data() + slot * kBlockNodes);
  });
}

namespace {
constexpr std::size_t kUnder = 2 * kBlock + 1;  // fine nodes -1..15 under the coarse nodes 0..7 of a block
using Under = std::array<float, kUnder * kUnder * kUnder>;

/// The fine nodes under a coarse block; 0 where the fine level has no block.
void gatherUnder(const BlockGrid& fineGrid, const Field& fine, const Coord& block, Under& under) {
  static constexpr std::array<float, kBlockNodes> kZeros{};
  std::array<const float*, 27> blocks{};  // the fine block before, the first and the second under this one, per axis
  for (int n = 0; n < 27; ++n) {
    const std::int32_t slot = fineGrid.slot({2 * block[0] + n % 3 - 1, 2 * block[1] + n / 3 % 3 - 1, 2 * block[2] + n / 9 - 1});
    blocks[static_cast<std::size_t>(n)] = slot < 0 ? kZeros.data() : fine.data() + static_cast<std::size_t>(slot) * kBlockNodes;
  }
  const auto blockOf = [](std::size_t node) { return (node + kBlock - 1) / kBlock; };
  const auto nodeOf = [](std::size_t node) { return (node + kBlock - 1) % kBlock; };
  for (std::size_t k = 0; k < kUnder; ++k) {
    for (std::size_t j = 0; j < kUnder; ++j) {
      const float* const* row = &blocks[3 * (blockOf(j) + 3 * blockOf(k))];
      const std::size_t from = kBlock * (nodeOf(j) + kBlock * nodeOf(k));
      float* to = under.data() + kUnder * (j + kUnder * k);
      to[0] = row[0][from + kBlock - 1];
      std::memcpy(to + 1, row[1] + from, kBlock * sizeof(float));
      std::memcpy(to + 1 + kBlock, row[2] + from, kBlock * sizeof(float));
    }
  }
}

}  // namespace

void restrictTo(const BlockGrid& fineGrid, const Field& fine, const BlockGrid& coarseGrid, Field& coarse, float factor,
                const ExecutionContext& context) {
  forBlocks(coarseGrid, context, [&](std::size_t slot) {
    Under under;
    gatherUnder(fineGrid, fine, coarseGrid.coord(slot), under);
    constexpr std::size_t kRows = kUnder * kUnder;
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
