#include "reconstruction/evaluation/t_test.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "reconstruction/evaluation/statistics.h"

namespace glisson {

namespace {

double twoSidedP(double t, double degreesOfFreedom) {
  const boost::math::students_t distribution(degreesOfFreedom);
  return std::min(1.0, 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t))));
}

/// Equal values that are no round numbers leave a rest of rounding: R's bound.
bool isNoSpread(double standardError, double largestMean) {
  return standardError <= 10 * std::numeric_limits<double>::epsilon() * largestMean;
}

}  // namespace

TTestResult welchTTest(std::span<const double> first, std::span<const double> second) {
  if (first.size() < 2 || second.size() < 2) {
    return NoTTest::TooFew;
  }
  const auto squaredError = [](const Spread& spread, std::size_t count) {
    return spread.deviation * spread.deviation / static_cast<double>(count);
  };
  const Spread a = spreadOf(first);
  const Spread b = spreadOf(second);
  const double ofA = squaredError(a, first.size());
  const double ofB = squaredError(b, second.size());
  const double standardError = std::sqrt(ofA + ofB);
  if (isNoSpread(standardError, std::max(std::abs(a.mean), std::abs(b.mean)))) {
    return NoTTest::NoSpread;
  }
  TTest test;
  test.meanDifference = a.mean - b.mean;
  test.t = test.meanDifference / standardError;
  // as shares, so that no square of tiny variances underflows
  const double shareA = ofA / (ofA + ofB);
  const double shareB = ofB / (ofA + ofB);
  test.degreesOfFreedom =
      1 / (shareA * shareA / static_cast<double>(first.size() - 1) + shareB * shareB / static_cast<double>(second.size() - 1));
  test.p = twoSidedP(test.t, test.degreesOfFreedom);
  return test;
}

TTestResult pairedTTest(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size()) {
    throw std::invalid_argument("pairs need as many first as second values");
  }
  if (first.size() < 2) {
    return NoTTest::TooFew;
  }
  std::vector<double> differences(first.size());
  std::ranges::transform(first, second, differences.begin(), std::minus());
  const Spread spread = spreadOf(differences);
  const auto count = static_cast<double>(differences.size());
  const double standardError = spread.deviation / std::sqrt(count);
  const auto magnitude = [](std::span<const double> values) {
    return std::abs(*std::ranges::max_element(values, {}, [](double value) { return std::abs(value); }));
  };
  if (isNoSpread(standardError, std::max(magnitude(first), magnitude(second)))) {
    return NoTTest::NoSpread;
  }
  TTest test;
  test.meanDifference = spread.mean;
  test.t = spread.mean / standardError;
  test.degreesOfFreedom = count - 1;
  test.p = twoSidedP(test.t, test.degreesOfFreedom);
  return test;
}

}  // namespace glisson
