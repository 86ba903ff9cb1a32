#pragma once
// Purpose: how colours are told apart.

#include <QColor>
#include <cmath>

#include "reconstruction/image/image_geometry.h"

namespace glisson::test {

/// CIE 1976 colour difference of two sRGB colours, D65; `deuteranope`: as simulated by Machado, Oliveira, Fernandes (2009).
inline double colourDifference(const QColor& a, const QColor& b, bool deuteranope) {
  const auto lab = [deuteranope](const QColor& colour) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    Vec3 rgb(linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF()));
    if (deuteranope) {
      Mat3 seen;
      seen << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
      rgb = (seen * rgb).cwiseMax(0.0).cwiseMin(1.0);
    }
    Mat3 toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vec3 xyz = (toXyz * rgb).cwiseQuotient(Vec3(0.95047, 1.0, 1.08883));
    const Vec3 f = xyz.unaryExpr([](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; });
    return Vec3(116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z()));
  };
  return (lab(a) - lab(b)).norm();
}

/// Redder than blue: liver, tumours and what is too near, rather than the background and the planes.
inline bool isWarm(const QColor& c) { return c.red() > c.blue() + 25; }

}  // namespace glisson::test
