#include "reconstruction/poisson/density.h"

namespace glisson::poisson {

void weighByDensity(CubeSamples& samples, int level, double cellMm, const ExecutionContext& context) {
  BlockGrid grid(level);
  const auto starts = samples.blockRanges(level);
  for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
    const Coord b = samples.blockOf(starts[r], level);
    for (int c = 0; c < 8; ++c) {
      grid.mark({b[0] + (c & 1), b[1] + ((c >> 1) & 1), b[2] + (c >> 2)});
    }
  }
  grid.number();
  Field density = zeroField(grid.nodeCount());
  splat(samples, samples.weights, grid, 1.0F, density, context);
  const auto values = valuesAt(samples, grid, density, context);
  for (std::size_t n = 0; n < values.size(); ++n) {
    // A plane of s points a cell gives 2/3 s where it is splatted and read with the same hat function.
    samples.weights[n] = static_cast<float>(cellMm * cellMm * 2.0 / 3.0) / values[n];
  }
}

}  // namespace glisson::poisson
