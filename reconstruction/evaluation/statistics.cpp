#include "reconstruction/evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson {

BoxPlot boxPlotOf(std::span<const double> sorted) {
  constexpr double kReach = 1.5;
  BoxPlot box;
  if (sorted.empty()) {
    return box;
  }
  const auto ranked = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::max<std::size_t>(rank, 1) - 1];
  };
  box.lowQuartile = ranked(0.25);
  box.median = ranked(0.5);
  box.highQuartile = ranked(0.75);
  const double reach = kReach * (box.highQuartile - box.lowQuartile);
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), box.lowQuartile - reach);
  const auto last = std::upper_bound(sorted.begin(), sorted.end(), box.highQuartile + reach);
  box.lowWhisker = *first;
  box.highWhisker = *(last - 1);
  box.outliers = static_cast<std::size_t>((first - sorted.begin()) + (sorted.end() - last));
  return box;
}

double medianOf(std::span<const double> sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.empty() ? 0.0 : sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

Spread spreadOf(std::span<const double> values) {
  Spread spread;
  if (values.empty()) {
    return spread;
  }
  const auto count = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) {
    squares += (value - spread.mean) * (value - spread.mean);
  }
  spread.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  return spread;
}

}  // namespace glisson
