#include "reconstruction/poisson/splatting.h"

#include <algorithm>
#include <numeric>

#include "reconstruction/parallel.h"

namespace glisson::poisson {

namespace {

std::uint32_t spread(std::uint32_t v) {  // bits of v, two zeros after each
  v = (v | (v << 16)) & 0x030000FFU;
  v = (v | (v << 8)) & 0x0300F00FU;
  v = (v | (v << 4)) & 0x030C30C3U;
  return (v | (v << 2)) & 0x09249249U;
}

std::uint32_t mortonOf(const Coord& b) {
  return spread(static_cast<std::uint32_t>(b[0])) | (spread(static_cast<std::uint32_t>(b[1])) << 1) |
         (spread(static_cast<std::uint32_t>(b[2])) << 2);
}

/// Base node of the sample's cell on a level, and its place 0..1 within the cell.
struct Place {
  Coord node;
  std::array<float, 3> at;
};

Place placeOf(const std::array<float, 3>& position, float scale, int nodesPerSide) {
  Place place{};
  for (std::size_t a = 0; a < 3; ++a) {
    const float p = position[a] * scale;
    place.node[a] = std::clamp(static_cast<int>(p), 0, nodesPerSide - 1);
    place.at[a] = p - static_cast<float>(place.node[a]);
  }
  return place;
}

constexpr int kBlockBits = 3;       // kBlock is 2^3
constexpr int kReach = kBlock + 1;  // a block's samples touch nodes 0..8

}  // namespace

Coord CubeSamples::blockOf(std::size_t sample, int level) const {
  const float scale = 1.0F / static_cast<float>((1 << (depth - level)) * kBlock);
  Coord block{};
  for (std::size_t a = 0; a < 3; ++a) {
    block[a] = std::clamp(static_cast<int>(positions[sample][a] * scale), 0, (1 << level) / kBlock - 1);
  }
  return block;
}

std::vector<std::size_t> CubeSamples::blockRanges(int level) const {
  const int shift = 3 * (depth - level);
  std::vector<std::size_t> starts;
  for (std::size_t n = 0; n < keys.size(); ++n) {
    if (n == 0 || (keys[n] >> shift) != (keys[n - 1] >> shift)) {
      starts.push_back(n);
    }
  }
  starts.push_back(keys.size());
  return starts;
}

CubeSamples toCube(const OrientedPoints& points, const Vec3& corner, double cellMm, int depth) {
  const std::size_t count = points.positions.size();
  CubeSamples samples;
  samples.depth = depth;
  samples.positions.resize(count);
  for (std::size_t n = 0; n < count; ++n) {
    const Vec3 p = (points.positions[n] - corner) / cellMm;
    samples.positions[n] = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
  // Counting sort by block: samples of one block keep their order.
  std::vector<std::uint32_t> key(count);
  std::vector<std::uint32_t> place(std::size_t{1} << (3 * (depth - kBlockBits)), 0);
  for (std::size_t n = 0; n < count; ++n) {
    key[n] = mortonOf(samples.blockOf(n, depth));
    ++place[key[n]];
  }
  std::exclusive_scan(place.begin(), place.end(), place.begin(), 0U);
  std::vector<std::array<float, 3>> sorted(count);
  samples.normals.resize(count);
  samples.weights.resize(count);
  samples.keys.resize(count);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t to = place[key[n]]++;
    const Vec3& normal = points.normals[n];
    sorted[to] = samples.positions[n];
    samples.normals[to] = {static_cast<float>(normal[0]), static_cast<float>(normal[1]), static_cast<float>(normal[2])};
    samples.weights[to] = static_cast<float>(points.weights[n]);
    samples.keys[to] = key[n];
  }
  samples.positions = std::move(sorted);
  return samples;
}

void splat(const CubeSamples& samples, const BlockGrid& grid, int component, float factor, Field& field,
           const ExecutionContext& context) {
  const auto starts = samples.blockRanges(grid.level());
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  const int side = 1 << grid.level();
  // A block's samples write to itself and to the blocks after it; blocks of one parity never meet, so eight passes need no locks
  // and add in the same order with any number of threads.
  std::array<std::vector<std::size_t>, 8> passes;
  for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
    const Coord block = samples.blockOf(starts[r], grid.level());
    passes[static_cast<std::size_t>((block[0] & 1) + 2 * (block[1] & 1) + 4 * (block[2] & 1))].push_back(r);
  }
  for (const auto& pass : passes) {
    parallelFor(pass.size(), 8, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      for (std::size_t n = begin; n < end; ++n) {
        const Coord block = samples.blockOf(starts[pass[n]], grid.level());
        std::array<float, kReach * kReach * kReach> local{};
        for (std::size_t s = starts[pass[n]]; s < starts[pass[n] + 1]; ++s) {
          const Place place = placeOf(samples.positions[s], scale, side);
          const float value =
              factor * samples.weights[s] * (component < 3 ? samples.normals[s][static_cast<std::size_t>(component)] : 1.0F);
          for (int c = 0; c < 8; ++c) {
            const float wx = (c & 1) != 0 ? place.at[0] : 1 - place.at[0];
            const float wy = (c & 2) != 0 ? place.at[1] : 1 - place.at[1];
            const float wz = (c & 4) != 0 ? place.at[2] : 1 - place.at[2];
            const int i = place.node[0] - block[0] * kBlock + (c & 1);
            const int j = place.node[1] - block[1] * kBlock + ((c >> 1) & 1);
            const int k = place.node[2] - block[2] * kBlock + (c >> 2);
            local[static_cast<std::size_t>(i + kReach * (j + kReach * k))] += value * wx * wy * wz;
          }
        }
        for (int k = 0; k < kReach; ++k) {
          for (int j = 0; j < kReach; ++j) {
            for (int i = 0; i < kReach; ++i) {
              const float value = local[static_cast<std::size_t>(i + kReach * (j + kReach * k))];
              const std::int32_t slot =
                  value == 0 ? -1 : grid.slot({block[0] + i / kBlock, block[1] + j / kBlock, block[2] + k / kBlock});
              if (slot >= 0) {
                field[static_cast<std::size_t>(slot) * kBlockNodes + nodeIndex(i % kBlock, j % kBlock, k % kBlock)] += value;
              }
            }
          }
        }
      }
    });
  }
}

std::vector<float> valuesAt(const CubeSamples& samples, const BlockGrid& grid, const Field& field,
                            const ExecutionContext& context) {
  const auto starts = samples.blockRanges(grid.level());
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  const int side = 1 << grid.level();
  std::vector<float> values(samples.positions.size());
  parallelFor(starts.size() - 1, 8, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t r = begin; r < end; ++r) {
      const Coord block = samples.blockOf(starts[r], grid.level());
      const std::int32_t slot = grid.slot(block);
      Halo halo{};
      if (slot >= 0) {
        grid.gather(field, static_cast<std::size_t>(slot), halo);
      }
      for (std::size_t s = starts[r]; s < starts[r + 1]; ++s) {
        const Place place = placeOf(samples.positions[s], scale, side);
        float sum = 0;
        for (int c = 0; c < 8; ++c) {
          const float wx = (c & 1) != 0 ? place.at[0] : 1 - place.at[0];
          const float wy = (c & 2) != 0 ? place.at[1] : 1 - place.at[1];
          const float wz = (c & 4) != 0 ? place.at[2] : 1 - place.at[2];
          sum += wx * wy * wz *
                 halo[haloIndex(place.node[0] - block[0] * kBlock + (c & 1), place.node[1] - block[1] * kBlock + ((c >> 1) & 1),
                                place.node[2] - block[2] * kBlock + (c >> 2))];
        }
        values[s] = sum;
      }
    }
  });
  return values;
}

}  // namespace glisson::poisson
