#include "reconstruction/poisson/iso_value.h"

namespace glisson::poisson {

float isoValue(const CubeSamples& samples, const Level& finest, const ExecutionContext& context) {
  const auto values = valuesAt(samples, finest.grid, finest.x, context);
  double sum = 0;
  double weight = 0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    sum += static_cast<double>(values[n]) * samples.weights[n];
    weight += samples.weights[n];
  }
  return static_cast<float>(sum / weight);
}

}  // namespace glisson::poisson
