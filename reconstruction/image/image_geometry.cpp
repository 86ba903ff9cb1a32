#include "reconstruction/image/image_geometry.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

std::size_t ImageGeometry::voxelCount() const {
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
}

double ImageGeometry::voxelVolumeMm3() const { return spacing.prod(); }

Vec3 ImageGeometry::toIndex(const Vec3& world) const { return (direction.transpose() * (world - origin)).cwiseQuotient(spacing); }

Mat3 ImageGeometry::indexToWorldMatrix() const { return direction * spacing.asDiagonal(); }

bool ImageGeometry::leftHanded() const { return direction.determinant() < 0; }

double ImageGeometry::cornerDistance(const ImageGeometry& other) const {
  if (size != other.size) {
    return std::numeric_limits<double>::infinity();
  }
  double worst = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index((corner & 1) != 0 ? size[0] - 1 : 0, (corner & 2) != 0 ? size[1] - 1 : 0, (corner & 4) != 0 ? size[2] - 1 : 0);
    worst = std::max(worst, (toWorld(index) - other.toWorld(index)).norm());
  }
  return worst;
}

std::string ImageGeometry::describe() const {
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]) + " voxels of " +
         formatNumber(spacing[0], 3) + "x" + formatNumber(spacing[1], 3) + "x" + formatNumber(spacing[2], 3) + " mm at (" +
         formatNumber(origin[0], 2) + ", " + formatNumber(origin[1], 2) + ", " + formatNumber(origin[2], 2) + ")";
}

void ImageGeometry::validate(const std::string& what) const {
  if (size[0] < 1 || size[1] < 1 || size[2] < 1) {
    throw InputError(what + " has an empty grid (" + describe() + "); export it again.");
  }
  if (!spacing.allFinite() || !origin.allFinite() || !direction.allFinite() || spacing.minCoeff() <= 0) {
    throw InputError(what + " has a voxel spacing, origin or direction that is not a finite number; export it again.");
  }
  if (!(direction.transpose() * direction).isApprox(Mat3::Identity(), 1e-3)) {
    throw InputError(what + " has image axes that are not perpendicular unit vectors; resample it to a straight grid first.");
  }
}

std::array<std::size_t, 3> nearestIndexAxes(const Mat3& direction) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::array<std::size_t, 3> best = order;
  double bestSum = -1;
  do {
    double sum = 0;
    for (std::size_t world = 0; world < 3; ++world) {
      sum += std::abs(direction(static_cast<Eigen::Index>(world), static_cast<Eigen::Index>(order[world])));
    }
    if (sum > bestSum + 1e-12) {
      bestSum = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace glisson
