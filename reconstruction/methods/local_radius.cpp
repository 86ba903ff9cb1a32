#include "reconstruction/methods/local_radius.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "reconstruction/mesh/vertex_normals.h"
#include "reconstruction/methods/point_tree.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

constexpr std::size_t kRadiiGrain = 1024;

/// Outward, by area, smoothed over the neighbours so that a voxel's steps count little.
std::vector<Vec3> smoothNormals(const SurfaceMesh& mesh) {
  constexpr int kRounds = 4;
  std::vector<Vec3> normals = vertexNormals(mesh);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec3> sums = normals;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 all = normals[t[0]] + normals[t[1]] + normals[t[2]];
      for (const std::uint32_t corner : t) {
        sums[corner] += all - normals[corner];
      }
    }
    normalise(sums);
    normals = std::move(sums);
  }
  return normals;
}

/// The ball that touches at `at`: it begins with the greatest and shrinks to each point found inside.
double radiusAt(const Vec3& at, const Vec3& outward, double most, const std::vector<Vec3>& vertices, const PointTree& tree,
                std::vector<std::uint32_t>& near) {
  constexpr int kSteps = 30;
  constexpr double kSame = 1e-6;
  constexpr double kWall = 0.64;  // cosine of 50 degrees as seen from the centre: what is nearer is the same side of the tube
  double radius = most;
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 centre = at - radius * outward;
    tree.nearest(centre, 1, near);
    const Vec3& inside = vertices[near.front()];
    const Vec3 away = at - inside;
    if ((inside - centre).norm() >= (1 - kSame) * radius || away.squaredNorm() == 0) {
      break;
    }
    const double depth = outward.dot(away);
    if (depth <= 0) {
      break;
    }
    const double smaller = away.squaredNorm() / (2 * depth);
    const Vec3 next = at - smaller * outward;
    if (smaller >= radius || (at - next).dot(inside - next) > kWall * smaller * smaller) {
      break;
    }
    radius = smaller;
  }
  return radius;
}

/// Over the vertices within a share of the radius.
std::vector<double> medians(const std::vector<double>& radii, const std::vector<Vec3>& vertices, const PointTree& tree,
                            const ExecutionContext& context) {
  constexpr double kReach = 0.7;
  constexpr double kMostMm = 4;
  std::vector<double> smooth(radii.size());
  parallelFor(radii.size(), kRadiiGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    std::vector<std::uint32_t> near;
    std::vector<double> values;
    for (std::size_t v = begin; v < end; ++v) {
      tree.within(vertices[v], std::min(kReach * radii[v], kMostMm), near);
      values.clear();
      std::ranges::transform(near, std::back_inserter(values), [&](std::uint32_t n) { return radii[n]; });
      if (values.empty()) {
        values.push_back(radii[v]);
      }
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::ranges::nth_element(values, middle);
      smooth[v] = *middle;
    }
  });
  return smooth;
}

}  // namespace

std::vector<double> localRadii(const SurfaceMesh& mesh, const ExecutionContext& context) {
  const std::vector<Vec3> normals = smoothNormals(mesh);
  const PointTree tree(mesh.vertices);
  const Bounds bounds = boundsOf(mesh);
  const double most = 0.5 * (bounds.high - bounds.low).minCoeff();
  std::vector<double> radii(mesh.vertices.size());
  parallelFor(radii.size(), kRadiiGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    std::vector<std::uint32_t> near;
    for (std::size_t v = begin; v < end; ++v) {
      radii[v] = radiusAt(mesh.vertices[v], normals[v], most, mesh.vertices, tree, near);
    }
  });
  return medians(radii, mesh.vertices, tree, context);
}

}  // namespace glisson
