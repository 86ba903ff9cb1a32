#pragma once
// Purpose: boundary samples as density fields on a grid: V = -sum over samples of weight * normal * phi(node) / h^3 (grad X points
// inward), and the reverse, a field's value at each sample. Positions are in cells of the finest level, in [0, 2^depth].
// Same sums for any number of threads. All poll cancel.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/poisson/operators.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson::poisson {

/// Samples in cube coordinates, sorted by the Morton order of their finest block, so that every block of every level owns one
/// range.
struct CubeSamples {
  int depth = 0;
  LargeArray<std::array<float, 3>> positions;  ///< cells of level `depth`
  LargeArray<std::array<float, 3>> normals;
  LargeArray<float> weights;       ///< area, mm^2
  LargeArray<std::uint32_t> keys;  ///< Morton code of the block of level `depth`, ascending

  /// First sample of each run of equal blocks on `level`, and the end.
  [[nodiscard]] std::vector<std::size_t> blockRanges(int level) const;
  [[nodiscard]] Coord blockOf(std::size_t sample, int level) const;
};

/// Maps samples into the cube (low corner mm, cell of the finest level mm) and sorts them.
CubeSamples toCube(const OrientedPoints& points, const Vec3& corner, double cellMm, int depth, const ExecutionContext& context);

/// A field of zeros, filled on several threads.
Field zeroField(std::size_t nodes);

/// V += factor * weight * normal * phi.
void splatNormals(const CubeSamples& samples, const BlockGrid& grid, float factor, VectorField& v, const ExecutionContext& context);
/// field += factor * values * phi; one value per sample.
void splat(const CubeSamples& samples, std::span<const float> values, const BlockGrid& grid, float factor, Field& field,
           const ExecutionContext& context);
/// The field's value at every sample.
std::vector<float> valuesAt(const CubeSamples& samples, const BlockGrid& grid, const Field& field, const ExecutionContext& context);

}  // namespace glisson::poisson
