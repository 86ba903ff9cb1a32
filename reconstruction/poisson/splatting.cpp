#include "reconstruction/poisson/splatting.h"

#include <algorithm>
#include <numeric>

#include "reconstruction/parallel.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kSplattingGrain = 8;  // blocks a piece
constexpr std::size_t kSampleGrain = 8192;  // samples a piece

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

constexpr int kBlockBits = 3;       // kBlock is 2^3
constexpr int kReach = kBlock + 1;  // a block's samples touch nodes 0..8

/// The sample's cell within its block, as the index of its lowest node in an array whose rows are `row` and sheets `row`^2 long,
/// and the weights of the cell's 8 corners.
struct Place {
  std::size_t index = 0;
  std::array<float, 8> weights{};
};

Place placeOf(const std::array<float, 3>& position, float scale, const Coord& block, int row) {
  std::array<float, 3> at{};
  std::array<int, 3> node{};
  for (std::size_t a = 0; a < 3; ++a) {
    const float p = position[a] * scale - static_cast<float>(block[a] * kBlock);
    node[a] = std::clamp(static_cast<int>(p), 0, kBlock - 1);
    at[a] = p - static_cast<float>(node[a]);
  }
  Place place;
  place.index = static_cast<std::size_t>(node[0] + row * (node[1] + row * node[2]));
  const float x0 = 1 - at[0], y0 = 1 - at[1], z0 = 1 - at[2];
  place.weights = {x0 * y0 * z0,    at[0] * y0 * z0,    x0 * at[1] * z0,    at[0] * at[1] * z0,
                   x0 * y0 * at[2], at[0] * y0 * at[2], x0 * at[1] * at[2], at[0] * at[1] * at[2]};
  return place;
}

/// How far corner c of a cell lies from its lowest node in such an array.
constexpr std::array<std::size_t, 8> cornerSteps(std::size_t row) {
  return {0, 1, row, row + 1, row * row, row * row + 1, row * row + row, row * row + row + 1};
}

/// Adds a block's part, nodes 0..8, to the field.
void addPart(const std::array<float, std::size_t{kReach} * kReach * kReach>& part, const BlockGrid& grid, const Coord& block,
             Field& field) {
  for (int n = 0; n < 8; ++n) {
    const Coord step{n & 1, (n >> 1) & 1, n >> 2};
    const std::int32_t slot = grid.slot({block[0] + step[0], block[1] + step[1], block[2] + step[2]});
    if (slot < 0) {
      continue;
    }
    float* to = field.data() + static_cast<std::size_t>(slot) * kBlockNodes;
    const auto end = [&](std::size_t a) { return step[a] == 0 ? kBlock : 1; };
    for (int k = 0; k < end(2); ++k) {
      for (int j = 0; j < end(1); ++j) {
        const std::size_t from =
            static_cast<std::size_t>(kBlock * step[0] + kReach * (kBlock * step[1] + j + kReach * (kBlock * step[2] + k)));
        for (int i = 0; i < end(0); ++i) {
          to[nodeIndex(i, j, k)] += part[from + static_cast<std::size_t>(i)];
        }
      }
    }
  }
}

/// Calls splatBlock(first, end, block) for every block with samples. A block's samples write to itself and to the blocks after it;
/// blocks of one parity never meet, so eight passes need no locks and add in the same order with any number of threads.
template <typename SplatBlock>
void forBlocksOfSamples(const CubeSamples& samples, int level, const ExecutionContext& context, const SplatBlock& splatBlock) {
  const auto starts = samples.blockRanges(level);
  std::array<std::vector<std::size_t>, 8> passes;
  for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
    const Coord block = samples.blockOf(starts[r], level);
    passes[static_cast<std::size_t>((block[0] & 1) + 2 * (block[1] & 1) + 4 * (block[2] & 1))].push_back(r);
  }
  for (const auto& pass : passes) {
    parallelFor(pass.size(), kSplattingGrain, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      for (std::size_t n = begin; n < end; ++n) {
        splatBlock(starts[pass[n]], starts[pass[n] + 1], samples.blockOf(starts[pass[n]], level));
      }
    });
  }
}

/// fields[c] += valueOf(sample)[c] * phi.
template <std::size_t kFields, typename ValueOf>
void splatFields(const CubeSamples& samples, const BlockGrid& grid, const std::array<Field*, kFields>& fields,
                 const ExecutionContext& context, const ValueOf& valueOf) {
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  constexpr auto kSteps = cornerSteps(kReach);
  forBlocksOfSamples(samples, grid.level(), context, [&](std::size_t first, std::size_t end, const Coord& block) {
    std::array<std::array<float, std::size_t{kReach} * kReach * kReach>, kFields> parts{};
    for (std::size_t s = first; s < end; ++s) {
      const Place place = placeOf(samples.positions[s], scale, block, kReach);
      const std::array<float, kFields> value = valueOf(s);
      for (std::size_t f = 0; f < kFields; ++f) {
        for (std::size_t c = 0; c < 8; ++c) {
          parts[f][place.index + kSteps[c]] += value[f] * place.weights[c];
        }
      }
    }
    for (std::size_t f = 0; f < kFields; ++f) {
      addPart(parts[f], grid, block, *fields[f]);
    }
  });
}

std::array<float, 3> toFloat(const Vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Coord blockOfPosition(const std::array<float, 3>& position, float blocksPerCell, int blocksPerSide) {
  Coord block{};
  for (std::size_t a = 0; a < 3; ++a) {
    block[a] = std::clamp(static_cast<int>(position[a] * blocksPerCell), 0, blocksPerSide - 1);
  }
  return block;
}

}  // namespace

Coord CubeSamples::blockOf(std::size_t sample, int level) const {
  return blockOfPosition(positions[sample], 1.0F / static_cast<float>((1 << (depth - level)) * kBlock), (1 << level) / kBlock);
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

CubeSamples toCube(const OrientedPoints& points, const Vec3& corner, double cellMm, int depth, const ExecutionContext& context) {
  const std::size_t count = points.positions.size();
  LargeArray<std::array<float, 3>> positions(count);
  LargeArray<std::uint32_t> key(count);
  const double perCell = 1.0 / cellMm;
  parallelFor(count, kSampleGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t n = begin; n < end; ++n) {
      positions[n] = toFloat((points.positions[n] - corner) * perCell);
      key[n] = mortonOf(blockOfPosition(positions[n], 1.0F / kBlock, (1 << depth) / kBlock));
    }
  });
  context.throwIfCancelled();
  // Counting sort by block: samples of one block keep their order.
  std::vector<std::uint32_t> place(std::size_t{1} << (3 * (depth - kBlockBits)), 0);
  for (const std::uint32_t k : key) {
    ++place[k];
  }
  std::exclusive_scan(place.begin(), place.end(), place.begin(), 0U);
  LargeArray<std::uint32_t> from(count);
  for (std::size_t n = 0; n < count; ++n) {
    from[place[key[n]]++] = static_cast<std::uint32_t>(n);
  }
  context.throwIfCancelled();
  CubeSamples samples;
  samples.depth = depth;
  samples.positions.resize(count);
  samples.normals.resize(count);
  samples.weights.resize(count);
  samples.keys.resize(count);
  parallelFor(count, kSampleGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      samples.positions[n] = positions[from[n]];
      samples.normals[n] = toFloat(points.normals[from[n]]);
      samples.weights[n] = static_cast<float>(points.weights[from[n]]);
      samples.keys[n] = key[from[n]];
    }
  });
  return samples;
}

Field zeroField(std::size_t nodes) {
  Field field(nodes);
  constexpr std::size_t kPiece = 64 * kBlockNodes;
  parallelFor(nodes, kPiece, [&](std::size_t begin, std::size_t end) {
    std::fill(field.begin() + static_cast<std::ptrdiff_t>(begin), field.begin() + static_cast<std::ptrdiff_t>(end), 0.0F);
  });
  return field;
}

void splatNormals(const CubeSamples& samples, const BlockGrid& grid, float factor, VectorField& v,
                  const ExecutionContext& context) {
  splatFields<3>(samples, grid, {&v[0], &v[1], &v[2]}, context, [&](std::size_t s) {
    const float weight = factor * samples.weights[s];
    const auto& normal = samples.normals[s];
    return std::array<float, 3>{weight * normal[0], weight * normal[1], weight * normal[2]};
  });
}

void splat(const CubeSamples& samples, std::span<const float> values, const BlockGrid& grid, float factor, Field& field,
           const ExecutionContext& context) {
  splatFields<1>(samples, grid, {&field}, context, [&](std::size_t s) { return std::array<float, 1>{factor * values[s]}; });
}

std::vector<float> valuesAt(const CubeSamples& samples, const BlockGrid& grid, const Field& field,
                            const ExecutionContext& context) {
  const auto starts = samples.blockRanges(grid.level());
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  constexpr auto kSteps = cornerSteps(kHalo);
  std::vector<float> values(samples.positions.size());
  parallelFor(starts.size() - 1, kSplattingGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t r = begin; r < end; ++r) {
      const Coord block = samples.blockOf(starts[r], grid.level());
      const std::int32_t slot = grid.slot(block);
      Halo halo;
      if (slot >= 0) {
        grid.gather(field, static_cast<std::size_t>(slot), halo);
      } else {
        halo.fill(0.0F);
      }
      for (std::size_t s = starts[r]; s < starts[r + 1]; ++s) {
        const Place place = placeOf(samples.positions[s], scale, block, kHalo);
        const float* from = &halo[place.index + haloIndex(0, 0, 0)];
        float sum = 0;
        for (std::size_t c = 0; c < 8; ++c) {
          sum += place.weights[c] * from[kSteps[c]];
        }
        values[s] = sum;
      }
    }
  });
  return values;
}

}  // namespace glisson::poisson
