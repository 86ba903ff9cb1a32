#pragma once
// Purpose: do two groups of numbers differ in their mean? Student's t-tests, two-sided, without the assumption of equal variances.
// Sources: B. L. Welch: The generalization of Student's problem when several different population variances are involved.
// Biometrika, 1947 (degrees of freedom after Satterthwaite, 1946); Student: The probable error of a mean. Biometrika, 1908 (pairs).
// The method of Palomar et al. 2016, 4.4 ("Welch two sample t-test using the R statistical environment").

#include <cstdint>
#include <span>
#include <variant>

namespace glisson {

struct TTest {
  double meanDifference = 0;  ///< of the first group less the second, in the values' unit
  double t = 0;
  double degreesOfFreedom = 0;
  double p = 1;  ///< two-sided
};

/// Why there is no test.
enum class NoTTest : std::uint8_t {
  TooFew,    ///< fewer than two values in a group, or fewer than two pairs
  NoSpread,  ///< all values of both groups, or all differences, are the same: no variance to measure the difference by
};

using TTestResult = std::variant<TTest, NoTTest>;

/// Welch's test of two independent groups. Values are finite.
TTestResult welchTTest(std::span<const double> first, std::span<const double> second);
/// The test of the differences first[n] - second[n]. Throws std::invalid_argument where the groups differ in length.
TTestResult pairedTTest(std::span<const double> first, std::span<const double> second);

}  // namespace glisson
