#include "planning/volumetry/box_fraction.h"

#include <algorithm>
#include <cmath>

namespace glisson {

namespace {
/// The part of a rectangle with widths b <= c below the height s, and its derivative.
struct Rectangle {
  double b;
  double c;

  [[nodiscard]] double fraction(double s) const {
    if (s <= 0) {
      return 0;
    }
    if (s < b) {
      return 0.5 * (s / b) * (s / c);
    }
    if (s < c) {
      return (s - 0.5 * b) / c;
    }
    const double rest = b + c - s;
    return rest > 0 && b > 0 ? 1 - 0.5 * (rest / b) * (rest / c) : 1;
  }

  [[nodiscard]] double density(double s) const {
    if (s < 0 || s >= b + c) {
      return 0;
    }
    if (s < b) {
      return s / b / c;
    }
    return s < c || b <= 0 ? 1 / c : (b + c - s) / b / c;
  }
};
}  // namespace

BoxCut cutBox(double distance, const std::array<double, 3>& widths) {
  std::array<double, 3> w = widths;
  std::sort(w.begin(), w.end());
  const double whole = w[0] + w[1] + w[2];
  const double height = distance + 0.5 * whole;
  if (height < 0) {
    return {0, 0};
  }
  if (height >= whole) {
    return {1, 0};
  }
  // Near the top, measure from the top: 1 - G keeps its accuracy there.
  const bool mirrored = height > 0.5 * whole;
  const double t = mirrored ? whole - height : height;
  const Rectangle rectangle{w[1], w[2]};
  const double a = w[0];
  BoxCut cut;
  if (t - a == t) {
    cut = {rectangle.fraction(t), rectangle.density(t)};
  } else {
    // s = t - a u runs down through the rectangle's break points; between them everything is a polynomial of degree <= 2.
    const std::array<double, 5> ends{(t - w[1] - w[2]) / a, (t - w[2]) / a, (t - w[1]) / a, t / a, 1.0};
    double from = 0;
    for (const double end : ends) {
      const double to = std::min(end, 1.0);
      if (to <= from) {
        continue;
      }
      constexpr double kGauss = 0.57735026918962576;
      const double middle = 0.5 * (from + to);
      const double half = 0.5 * (to - from);
      const double s1 = t - a * (middle - half * kGauss);
      const double s2 = t - a * (middle + half * kGauss);
      cut.fraction += half * (rectangle.fraction(s1) + rectangle.fraction(s2));
      cut.density += half * (rectangle.density(s1) + rectangle.density(s2));
      from = to;
    }
  }
  if (mirrored) {
    cut.fraction = 1 - cut.fraction;
  }
  return cut;
}

}  // namespace glisson
