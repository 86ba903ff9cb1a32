#pragma once
// Purpose: analytic closed bodies for the tests of files and packages. mm LPS.

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <numbers>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson::test {

/// A subdivided icosahedron on the unit sphere: 20 * 4^levels triangles, outward.
inline SurfaceMesh unitSphere(int levels) {
  const double g = std::numbers::phi;
  SurfaceMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, isNew] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (isNew) {
        mesh.vertices.emplace_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const std::uint32_t ab = middle(t[0], t[1]);
      const std::uint32_t bc = middle(t[1], t[2]);
      const std::uint32_t ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& v : mesh.vertices) {
    v.normalize();
  }
  return mesh;
}

inline SurfaceMesh sphere(const Vec3& centre, double radiusMm, int levels) {
  SurfaceMesh mesh = unitSphere(levels);
  for (Vec3& v : mesh.vertices) {
    v = centre + radiusMm * v;
  }
  return mesh;
}

/// Unlike its mirror image in every axis and under every exchange of axes, away from the origin.
inline SurfaceMesh asymmetricBody(int levels = 3) {
  SurfaceMesh mesh = unitSphere(levels);
  for (Vec3& v : mesh.vertices) {
    const Vec3 u = v;
    v = Vec3(u.x() > 0 ? 61 * u.x() : 23 * u.x(), u.y() > 0 ? 17 * u.y() : 41 * u.y(), u.z() > 0 ? 83 * u.z() : 31 * u.z()) +
        Vec3(-104.3, 57.9, 1013.7);
  }
  return mesh;
}

}  // namespace glisson::test
