#include "viewer/resection_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson {

namespace {

constexpr double kHatchMm = 3.0;      ///< from one stripe to the next
constexpr double kHatchShare = 0.35;  ///< of it that is dark
constexpr double kLinePixels = 1.2;
constexpr int kAlpha = 215;

/// Bilinear in the four points around.
struct Corners {
  double a, b, c, d;
  [[nodiscard]] double at(double x, double y) const { return (1 - y) * ((1 - x) * a + x * b) + y * ((1 - x) * c + x * d); }
  [[nodiscard]] bool finite() const { return std::isfinite(a) && std::isfinite(b) && std::isfinite(c) && std::isfinite(d); }
};

QRgb premultiplied(const QColor& colour, int alpha) {
  return qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), alpha));
}

}  // namespace

PlaneGrid gridOver(const std::vector<Loop>& outline, const HalfSpace& plane, double stepMm) {
  const PlaneAxes axes = axesOf(plane.normal);
  double lowU = std::numeric_limits<double>::infinity();
  double lowV = lowU;
  double highU = -lowU;
  double highV = -lowU;
  for (const Loop& loop : outline) {
    for (const Vec3& point : loop) {
      const Vec3 from = point - plane.origin;
      lowU = std::min(lowU, from.dot(axes.u));
      highU = std::max(highU, from.dot(axes.u));
      lowV = std::min(lowV, from.dot(axes.v));
      highV = std::max(highV, from.dot(axes.v));
    }
  }
  if (lowU > highU) {
    return {};
  }
  PlaneGrid grid;
  grid.origin = plane.origin + (lowU - stepMm) * axes.u + (lowV - stepMm) * axes.v;
  grid.u = axes.u;
  grid.v = axes.v;
  grid.stepMm = stepMm;
  grid.columns = static_cast<int>(std::ceil((highU - lowU) / stepMm)) + 3;
  grid.rows = static_cast<int>(std::ceil((highV - lowV) / stepMm)) + 3;
  return grid;
}

QImage marginPicture(const MarginMap& map, double safetyMarginMm, int pixels) {
  const PlaneGrid& grid = map.grid;
  if (grid.columns < 2 || grid.rows < 2) {
    return {};
  }
  QImage picture((grid.columns - 1) * pixels, (grid.rows - 1) * pixels, QImage::Format_ARGB32_Premultiplied);
  const QRgb red = premultiplied(kMarginRed, kAlpha);
  const QRgb hatch = premultiplied(QColor(110, 0, 0), kAlpha);
  const QRgb yellow = premultiplied(kMarginYellow, kAlpha);
  const QRgb line = premultiplied(QColor(30, 33, 38), kAlpha);
  const double mmPerPixel = grid.stepMm / pixels;
  for (int y = 0; y < picture.height(); ++y) {
    auto* out = reinterpret_cast<QRgb*>(picture.scanLine(y));
    const int row = y / pixels;
    const double dy = (y % pixels + 0.5) / pixels;
    for (int x = 0; x < picture.width(); ++x) {
      const int column = x / pixels;
      const double dx = (x % pixels + 0.5) / pixels;
      const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column);
      const auto below = first + static_cast<std::size_t>(grid.columns);
      const Corners mm{map.ways[first].mm, map.ways[first + 1].mm, map.ways[below].mm, map.ways[below + 1].mm};
      if (!mm.finite()) {
        out[x] = 0;
        continue;
      }
      const Corners atLeast{map.ways[first].atLeastMm, map.ways[first + 1].atLeastMm, map.ways[below].atLeastMm,
                            map.ways[below + 1].atLeastMm};
      const double distance = mm.at(dx, dy);
      const double toLine = std::abs(distance - kIsoLineMm * std::round(distance / kIsoLineMm));
      if (distance > 0.5 * kIsoLineMm && toLine < 0.5 * kLinePixels * mmPerPixel) {
        out[x] = line;
      } else if (distance < safetyMarginMm) {
        const double stripe = (x + y) * mmPerPixel / kHatchMm;
        out[x] = stripe - std::floor(stripe) < kHatchShare ? hatch : red;
      } else {
        out[x] = atLeast.at(dx, dy) < safetyMarginMm ? yellow : 0;
      }
    }
  }
  return picture;
}

}  // namespace glisson
