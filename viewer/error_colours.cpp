#include "viewer/error_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson {

namespace {

constexpr std::array kStops{Rgb{68, 1, 84},    Rgb{72, 40, 120},  Rgb{62, 74, 137},  Rgb{49, 104, 142}, Rgb{38, 130, 142},
                            Rgb{31, 158, 137}, Rgb{53, 183, 121}, Rgb{109, 205, 89}, Rgb{180, 222, 44}, Rgb{253, 231, 37}};
constexpr double kLeastScaleMm = 0.1;

}  // namespace

Rgb errorColour(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(low);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(std::lround(a + part * (b - a))); };
  const Rgb& a = kStops[low];
  const Rgb& b = kStops[low + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

double errorScaleMm(double p95Mm) {
  const double wanted = std::max(p95Mm, kLeastScaleMm);
  const double power = std::pow(10.0, std::floor(std::log10(wanted) + 1e-9));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= wanted * (1 - 1e-9)) {
      return step * power;
    }
  }
  return 10 * power;
}

}  // namespace glisson
