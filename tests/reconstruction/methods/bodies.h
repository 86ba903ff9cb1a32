#pragma once
// Purpose: analytic bodies for the tests of methods: as oriented points of their surface, and as masks.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "reconstruction/image/mask.h"

namespace glisson::test {

struct Cloud {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
};

/// Evenly spread over a sphere.
inline Cloud sphereCloud(const Vec3& centre, double radius, int count) {
  Cloud cloud;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int n = 0; n < count; ++n) {
    const double z = 1 - (2 * n + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    const Vec3 normal(r * std::cos(turn * n), r * std::sin(turn * n), z);
    cloud.positions.emplace_back(centre + radius * normal);
    cloud.normals.push_back(normal);
  }
  return cloud;
}

/// A ring around z through `centre`: `around` x `across` points.
inline Cloud torusCloud(const Vec3& centre, double ring, double tube, int around, int across) {
  Cloud cloud;
  for (int a = 0; a < around; ++a) {
    for (int b = 0; b < across; ++b) {
      const double u = 2 * std::numbers::pi * (a + 0.5 * (b % 2)) / around;
      const double v = 2 * std::numbers::pi * b / across;
      const Vec3 outward(std::cos(u), std::sin(u), 0);
      const Vec3 normal = std::cos(v) * outward + std::sin(v) * Vec3::UnitZ();
      cloud.positions.emplace_back(centre + ring * outward + tube * normal);
      cloud.normals.push_back(normal);
    }
  }
  return cloud;
}

/// Negative inside.
inline double distanceToTorus(const Vec3& at, const Vec3& centre, double ring, double tube) {
  const Vec3 p = at - centre;
  return std::hypot(std::hypot(p[0], p[1]) - ring, p[2]) - tube;
}

struct Body {
  ImageGeometry geometry;
  Mask mask;
};

/// The voxels whose centres are inside.
inline Body bodyWhere(const Index3& size, const Vec3& spacing, const std::function<bool(const Vec3&)>& inside) {
  Body body;
  body.geometry.size = size;
  body.geometry.spacing = spacing;
  std::vector<std::uint8_t> values;
  values.reserve(body.geometry.voxelCount());
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        values.push_back(inside(body.geometry.toWorld(Vec3(i, j, k))) ? 1 : 0);
      }
    }
  }
  body.mask = Mask::fromGrid(size, values);
  return body;
}

}  // namespace glisson::test
