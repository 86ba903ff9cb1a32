#include "reconstruction/methods/plane_normals.h"

#include <Eigen/Eigenvalues>
#include <optional>
#include <stdexcept>

#include "reconstruction/methods/point_tree.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

constexpr std::size_t kNormalsGrain = 2048;

/// The direction in which the points vary least; nothing where they lie on a line.
std::optional<Vec3> planeNormal(const OrientedPoints& points, const std::vector<std::uint32_t>& near) {
  Vec3 mean = Vec3::Zero();
  for (const std::uint32_t n : near) {
    mean += points.positions[n];
  }
  mean /= static_cast<double>(near.size());
  Mat3 covariance = Mat3::Zero();
  for (const std::uint32_t n : near) {
    const Vec3 away = points.positions[n] - mean;
    covariance += away * away.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(covariance);
  constexpr double kLine = 1e-9;  // of the greatest variance
  if (axes.eigenvalues()[1] <= kLine * axes.eigenvalues()[2]) {
    return std::nullopt;
  }
  return axes.eigenvectors().col(0);
}

}  // namespace

OrientedPoints withPlaneNormals(OrientedPoints points, const ImageGeometry& geometry, int neighbours,
                                const ExecutionContext& context) {
  if (neighbours < 3) {
    throw std::invalid_argument("withPlaneNormals: a plane wants three neighbours at least");
  }
  const PointTree tree(points.positions);
  parallelFor(points.positions.size(), kNormalsGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    std::vector<std::uint32_t> near;
    for (std::size_t n = begin; n < end; ++n) {
      tree.nearest(points.positions[n], static_cast<std::size_t>(neighbours), near);
      const std::optional<Vec3> found = planeNormal(points, near);
      if (!found) {
        continue;
      }
      Vec3& normal = points.normals[n];
      if (points.axes.empty()) {
        normal = found->dot(normal) < 0 ? Vec3(-*found) : *found;
        continue;
      }
      // The face's area is known from the old pair of normal and weight: weight = area x (normal . face axis).
      const Vec3 axis = geometry.direction.col(points.axes[n]);
      const double before = normal.dot(axis);
      const double area = points.weights[n] / std::abs(before);
      normal = found->dot(axis) * before < 0 ? Vec3(-*found) : *found;
      points.weights[n] = area * std::abs(normal.dot(axis));
    }
  });
  return points;
}

}  // namespace glisson
