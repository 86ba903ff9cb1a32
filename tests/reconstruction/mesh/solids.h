#pragma once
// Purpose: small closed meshes with known volumes, for the tests of meshes.

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson::test {

inline SurfaceMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// A box of n x n x n squares a face (two triangles each), from `low`, with sides `side`. Vertices are shared.
inline SurfaceMesh box(const Vec3& low, const Vec3& side, int n = 1) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, isNew] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (isNew) {
      mesh.vertices.emplace_back(low + side.cwiseProduct(Vec3(at[0], at[1], at[2])) / n);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, n}) {
      for (int u = 0; u < n; ++u) {
        for (int v = 0; v < n; ++v) {
          const auto corner = [&](int du, int dv) {
            std::array<int, 3> at{};
            at[axis] = end;
            at[(axis + 1) % 3] = u + du;
            at[(axis + 2) % 3] = v + dv;
            return vertex(at);
          };
          const std::array<std::uint32_t, 4> q{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (end == n) {
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
          } else {
            mesh.triangles.push_back({q[0], q[2], q[1]});
            mesh.triangles.push_back({q[0], q[3], q[2]});
          }
        }
      }
    }
  }
  return mesh;
}

/// An icosahedron, each triangle split into four `levels` times, on a sphere.
inline SurfaceMesh sphere(const Vec3& centre, double radius, int levels) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  SurfaceMesh mesh{
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
       {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    std::vector<Triangle> finer;
    const auto mid = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, isNew] = middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (isNew) {
        const Vec3 between = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
        mesh.vertices.push_back(between);
      }
      return found->second;
    };
    for (const Triangle& t : mesh.triangles) {
      const std::uint32_t a = mid(t[0], t[1]);
      const std::uint32_t b = mid(t[1], t[2]);
      const std::uint32_t c = mid(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& v : mesh.vertices) {
    v = (centre + radius * v.normalized()).eval();
  }
  return mesh;
}

/// Both meshes as one; nothing is welded.
inline SurfaceMesh together(SurfaceMesh a, const SurfaceMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return a;
}

inline SurfaceMesh reversed(SurfaceMesh mesh) {
  for (Triangle& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

}  // namespace glisson::test
