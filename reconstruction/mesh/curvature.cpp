#include "reconstruction/mesh/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace glisson {

namespace {

constexpr double kTinyMm2 = 1e-6;
constexpr double kTrimmedShare = 0.05;

std::vector<bool> verticesOnOpenEdges(const SurfaceMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      edges.push_back(std::minmax(triangle[corner], triangle[(corner + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> open(mesh.vertices.size(), false);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    while (last < edges.size() && edges[last] == edges[first]) {
      ++last;
    }
    if (last - first == 1) {
      open[edges[first].first] = true;
      open[edges[first].second] = true;
    }
    first = last;
  }
  return open;
}

double meanOf(const std::vector<double>& values, std::size_t first, std::size_t last) {
  return last > first ? std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first),
                                        values.begin() + static_cast<std::ptrdiff_t>(last), 0.0) /
                            static_cast<double>(last - first)
                      : 0.0;
}

CurvatureSummary summaryOf(const SurfaceMesh& mesh, const std::vector<bool>& leftOut) {
  std::vector<double> angles(mesh.vertices.size(), 0.0);
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  CurvatureSummary summary;
  for (const Triangle& triangle : mesh.triangles) {
    const std::array<Vec3, 3> p{mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
    const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    summary.tinyTriangles += area < kTinyMm2 ? 1 : 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3 u = p[(corner + 1) % 3] - p[corner];
      const Vec3 v = p[(corner + 2) % 3] - p[corner];
      angles[triangle[corner]] += std::atan2(u.cross(v).norm(), u.dot(v));
      areas[triangle[corner]] += area;
    }
  }
  std::vector<double> curvatures;
  curvatures.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!leftOut[i] && areas[i] > 0) {
      curvatures.push_back(3.0 * (2.0 * std::numbers::pi - angles[i]) / areas[i]);
    }
  }
  std::sort(curvatures.begin(), curvatures.end());
  const auto trimmed = static_cast<std::size_t>(kTrimmedShare * static_cast<double>(curvatures.size()));
  summary.trimmedPerMm2 = meanOf(curvatures, trimmed, curvatures.size() - trimmed);
  summary.untrimmedPerMm2 = meanOf(curvatures, 0, curvatures.size());
  return summary;
}

}  // namespace

SurfaceMesh mergedVertices(const SurfaceMesh& mesh) {
  const auto lexicographic = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3& p = mesh.vertices[a];
    const Vec3& q = mesh.vertices[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), lexicographic);
  std::vector<std::uint32_t> representative(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool equal = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
    representative[order[i]] = equal ? representative[order[i - 1]] : order[i];
  }
  constexpr auto kUnused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kUnused);
  SurfaceMesh merged;
  merged.triangles.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    Triangle out{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t& number = renumbered[representative[triangle[corner]]];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(merged.vertices.size());
        merged.vertices.push_back(mesh.vertices[triangle[corner]]);
      }
      out[corner] = number;
    }
    merged.triangles.push_back(out);
  }
  return merged;
}

CurvatureSummary meanGaussianCurvature(const SurfaceMesh& mesh) {
  const SurfaceMesh merged = mergedVertices(mesh);
  return summaryOf(merged, verticesOnOpenEdges(merged));
}

CurvatureSummary gaussianCurvatureAsShipped(const SurfaceMesh& mesh) {
  return summaryOf(mesh, std::vector<bool>(mesh.vertices.size(), false));
}

}  // namespace glisson
