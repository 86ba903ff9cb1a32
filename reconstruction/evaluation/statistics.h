#pragma once
// Purpose: what a box plot shows of many distances, and the spread of a few numbers. Units are those of the values.
// Source: Tukey, Exploratory Data Analysis, 1977 (whiskers at 1.5 interquartile ranges); used by Palomar et al. 2016, Fig. 5.

#include <cstddef>
#include <span>

namespace glisson {

/// All zero where there are no values. Quartiles are the nearest rank, as in ErrorSummary.
struct BoxPlot {
  double lowWhisker = 0;  ///< least value not below lowQuartile - 1.5 (highQuartile - lowQuartile)
  double lowQuartile = 0;
  double median = 0;
  double highQuartile = 0;
  double highWhisker =
      0;  ///< greatest value not above highQuartile + 1.5 (highQuartile - lowQuartile): "maximum excluding outliers"
  std::size_t outliers = 0;  ///< values beyond the whiskers
};
/// `sorted` in ascending order.
BoxPlot boxPlotOf(std::span<const double> sorted);

/// The middle value, of an even number the mean of the middle two; 0 where there is none. `sorted` in ascending order.
double medianOf(std::span<const double> sorted);

struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of a sample (divided by n - 1), 0 of fewer than two
};
Spread spreadOf(std::span<const double> values);

}  // namespace glisson
