#include "reconstruction/mesh/distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "reconstruction/errors.h"
#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/parallel.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;
constexpr std::size_t kBlock = 2048;
constexpr std::size_t kNoTriangle = static_cast<std::size_t>(-1);

double squaredToSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + t * along - point).squaredNorm();
}

double squaredToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = point - a;
  const Vec3 normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  constexpr double kNeedle = 1e-12;  // sine of its angle squared: rounding would tell the wrong side of an edge
  if (area > kNeedle * ab.squaredNorm() * ac.squaredNorm()) {
    // Barycentric coordinates of the foot of the perpendicular; inside the triangle the height is the distance.
    const double v = ap.cross(ac).dot(normal);
    const double w = ab.cross(ap).dot(normal);
    if (v >= 0 && w >= 0 && v + w <= area) {
      const double height = ap.dot(normal);
      return height * height / area;
    }
    // The nearest point lies on an edge that has the foot on its outer side.
    double squared = std::numeric_limits<double>::infinity();
    if (v < 0) {
      squared = squaredToSegment(point, c, a);
    }
    if (w < 0) {
      squared = std::min(squared, squaredToSegment(point, a, b));
    }
    if (v + w > area) {
      squared = std::min(squared, squaredToSegment(point, b, c));
    }
    return squared;
  }
  return std::min({squaredToSegment(point, a, b), squaredToSegment(point, b, c), squaredToSegment(point, c, a)});
}

double squaredToBox(const Vec3& point, const Vec3& low, const Vec3& high) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

double distanceToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::sqrt(squaredToTriangle(point, a, b, c));
}

MeshDistance::MeshDistance(const SurfaceMesh& mesh, const ExecutionContext& context) {
  if (mesh.empty()) {
    throw std::invalid_argument("MeshDistance: the mesh has no triangles");
  }
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<Vec3> centres(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const Triangle& triangle = mesh.triangles[t];
    centres[t] = (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]] + mesh.vertices[triangle[2]]) / 3.0;
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  nodes_.reserve(count);
  corners_.reserve(3 * static_cast<std::size_t>(count));
  build(order, centres, mesh, 0, count, context);
}

std::uint32_t MeshDistance::build(std::vector<std::uint32_t>& order, const std::vector<Vec3>& centres, const SurfaceMesh& mesh,
                                  std::uint32_t begin, std::uint32_t end, const ExecutionContext& context) {
  constexpr std::uint32_t kPoll = 16384;
  if (end - begin > kPoll) {
    context.throwIfCancelled();
  }
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  Vec3 centreLow = low;
  Vec3 centreHigh = high;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t vertex : mesh.triangles[order[i]]) {
      low = low.cwiseMin(mesh.vertices[vertex]);
      high = high.cwiseMax(mesh.vertices[vertex]);
    }
    centreLow = centreLow.cwiseMin(centres[order[i]]);
    centreHigh = centreHigh.cwiseMax(centres[order[i]]);
  }
  nodes_[self].low = low;
  nodes_[self].high = high;
  if (end - begin <= kLeafTriangles) {
    nodes_[self].first = static_cast<std::uint32_t>(corners_.size() / 3);
    nodes_[self].count = end - begin;
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t vertex : mesh.triangles[order[i]]) {
        corners_.push_back(mesh.vertices[vertex]);
      }
    }
    return self;
  }
  Eigen::Index axis = 0;
  (centreHigh - centreLow).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
  build(order, centres, mesh, begin, middle, context);
  const std::uint32_t right = build(order, centres, mesh, middle, end, context);
  nodes_[self].first = right;
  return self;
}

double MeshDistance::squaredTo(const Vec3& point, std::size_t& triangle) const {
  struct Visit {
    std::uint32_t node;
    double squared;
  };
  // Median splits keep the depth below log2(2^32) + 1.
  std::array<Visit, 40> stack;
  std::size_t top = 0;
  stack[top++] = {0, squaredToBox(point, nodes_[0].low, nodes_[0].high)};
  const auto squaredToNumber = [&](std::size_t t) {
    return squaredToTriangle(point, corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]);
  };
  double best = triangle == kNoTriangle ? std::numeric_limits<double>::infinity() : squaredToNumber(triangle);
  while (top > 0) {
    const Visit visit = stack[--top];
    if (visit.squared >= best) {
      continue;
    }
    const Node& node = nodes_[visit.node];
    if (node.count > 0) {
      for (std::size_t t = node.first; t < node.first + static_cast<std::size_t>(node.count); ++t) {
        const double squared = squaredToNumber(t);
        if (squared < best) {
          best = squared;
          triangle = t;
        }
      }
      continue;
    }
    Visit near{visit.node + 1, squaredToBox(point, nodes_[visit.node + 1].low, nodes_[visit.node + 1].high)};
    Visit far{node.first, squaredToBox(point, nodes_[node.first].low, nodes_[node.first].high)};
    if (far.squared < near.squared) {
      std::swap(near, far);
    }
    if (far.squared < best) {
      stack[top++] = far;
    }
    if (near.squared < best) {
      stack[top++] = near;
    }
  }
  return best;
}

double MeshDistance::to(const Vec3& point) const {
  std::size_t triangle = kNoTriangle;
  return std::sqrt(squaredTo(point, triangle));
}

std::vector<double> MeshDistance::to(std::span<const Vec3> points, const ExecutionContext& context) const {
  std::vector<double> distances(points.size());
  // Blocks of fixed places: what a search begins with must not depend on how threads divide the points.
  const std::size_t blocks = (points.size() + kBlock - 1) / kBlock;
  parallelFor(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      context.throwIfCancelled();
      std::size_t triangle = kNoTriangle;
      for (std::size_t i = block * kBlock; i < std::min(points.size(), (block + 1) * kBlock); ++i) {
        distances[i] = std::sqrt(squaredTo(points[i], triangle));
      }
    }
  });
  return distances;
}

ErrorSummary summarise(std::vector<double> distances) {
  if (distances.empty()) {
    return {};
  }
  std::sort(distances.begin(), distances.end());
  const auto ranked = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(distances.size())));
    return distances[std::max<std::size_t>(rank, 1) - 1];
  };
  const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
  return {sum / static_cast<double>(distances.size()), ranked(0.5), ranked(0.95), distances.back()};
}

std::optional<ErrorSummary> paperError(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry,
                                       const ExecutionContext& context) {
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  OrientedPoints points;
  try {
    points = sampleBoundary(mask, geometry, Sampling::Paper, context);
  } catch (const ReconstructionError&) {
    return std::nullopt;
  }
  return summarise(MeshDistance(mesh, context).to(points.positions, context));
}

ErrorSummary voxelError(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry, const ExecutionContext& context) {
  McsdParameters raw;
  raw.smoothing = 0;
  raw.decimation = 0;
  const SurfaceMesh levelSet = reconstructMcsd(mask, geometry, raw, context).mesh;
  std::vector<double> distances = MeshDistance(levelSet, context).to(mesh.vertices, context);
  const std::vector<double> back = MeshDistance(mesh, context).to(levelSet.vertices, context);
  distances.insert(distances.end(), back.begin(), back.end());
  return summarise(std::move(distances));
}

}  // namespace glisson
