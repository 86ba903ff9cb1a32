#include "planning/volumetry/inscribed_balls.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "planning/volumetry/nearest_site.h"

namespace glisson {

namespace {
/// The voxels outside that share a face with the mask: the nearest outside is always one of them.
std::vector<Index3> shellOf(const Mask& mask, const IndexBox& box) {
  std::vector<Index3> shell;
  for (int k = box.first[2]; k < box.first[2] + box.size[2]; ++k) {
    for (int j = box.first[1]; j < box.first[1] + box.size[1]; ++j) {
      for (int i = box.first[0]; i < box.first[0] + box.size[0]; ++i) {
        if (!mask.at(i, j, k) && (mask.at(i - 1, j, k) || mask.at(i + 1, j, k) || mask.at(i, j - 1, k) || mask.at(i, j + 1, k) ||
                                  mask.at(i, j, k - 1) || mask.at(i, j, k + 1))) {
          shell.push_back({i, j, k});
        }
      }
    }
  }
  return shell;
}
}  // namespace

std::vector<double> inscribedRadii(const Mask& mask, const Vec3& spacing, const ExecutionContext& context) {
  if (mask.empty()) {
    return {};
  }
  IndexBox box = mask.box();
  for (std::size_t a = 0; a < 3; ++a) {
    --box.first[a];
    box.size[a] += 2;
  }
  const std::vector<Index3> outside = shellOf(mask, box);
  const std::vector<std::int32_t> nearest = nearestSites(box, spacing, outside, context);
  std::vector<double> radii;
  radii.reserve(mask.count());
  std::size_t n = 0;
  for (int k = box.first[2]; k < box.first[2] + box.size[2]; ++k) {
    for (int j = box.first[1]; j < box.first[1] + box.size[1]; ++j) {
      for (int i = box.first[0]; i < box.first[0] + box.size[0]; ++i, ++n) {
        if (mask.at(i, j, k)) {
          const Index3& other = outside[static_cast<std::size_t>(nearest[n])];
          const Vec3 way = spacing.cwiseProduct(Vec3(other[0] - i, other[1] - j, other[2] - k));
          radii.push_back(way.norm() - 0.5 * way.cwiseAbs().dot(spacing) / way.norm());
        }
      }
    }
  }
  return radii;
}

InscribedBalls::InscribedBalls(const Mask& mask, const Vec3& spacing, const ExecutionContext& context)
    : spacing_(spacing),
      voxels_(rowsOf(mask)),
      table_(voxels_.runs.size(), [this](std::size_t n) { return voxels_.runs[n]; }),
      radii_(inscribedRadii(mask, spacing, context)) {
  begins_.reserve(voxels_.runs.size());
  std::size_t begin = 0;
  for (const RowRun& run : voxels_.runs) {
    begins_.push_back(begin);
    begin += static_cast<std::size_t>(run.n);
  }
  widest_ = radii_.empty() ? 0 : *std::max_element(radii_.begin(), radii_.end());
}

double InscribedBalls::radiusAt(const Index3& voxel) const {
  const RowTable::Range row = table_.row(voxel[1], voxel[2]);
  for (std::size_t r = row.begin; r < row.end; ++r) {
    const int at = voxel[0] - voxels_.runs[r].i;
    if (at >= 0 && at < voxels_.runs[r].n) {
      return radii_[begins_[r] + static_cast<std::size_t>(at)];
    }
  }
  return 0;
}

template <typename Visit>
void InscribedBalls::forNear(const Index3& voxel, double mm, const Visit& visit) const {
  const auto reach = [&](Eigen::Index axis) { return static_cast<int>(std::ceil(mm / spacing_[axis])); };
  for (int k = voxel[2] - reach(2); k <= voxel[2] + reach(2); ++k) {
    for (int j = voxel[1] - reach(1); j <= voxel[1] + reach(1); ++j) {
      const RowTable::Range row = table_.row(j, k);
      for (std::size_t r = row.begin; r < row.end; ++r) {
        const RowRun& run = voxels_.runs[r];
        const int last = std::min(run.i + run.n - 1, voxel[0] + reach(0));
        for (int i = std::max(run.i, voxel[0] - reach(0)); i <= last; ++i) {
          const Vec3 way = spacing_.cwiseProduct(Vec3(i - voxel[0], j - voxel[1], k - voxel[2]));
          if (way.norm() <= mm) {
            visit(Index3{i, j, k}, way, radii_[begins_[r] + static_cast<std::size_t>(i - run.i)]);
          }
        }
      }
    }
  }
}

InscribedBalls::Ball InscribedBalls::ballAround(const Index3& voxel) const {
  Ball widest{voxel, radiusAt(voxel)};
  if (widest.radius > 0) {
    forNear(voxel, widest_ + 0.5 * spacing_.norm(), [&](const Index3& centre, const Vec3& way, double radius) {
      const double mm = way.norm();
      // Half the voxel's extent along the way: radii are that much small, and the wall's voxels are to belong to the ball.
      if (radius > widest.radius && mm - 0.5 * way.cwiseAbs().dot(spacing_) / mm <= radius) {
        widest = {centre, radius};
      }
    });
  }
  return widest;
}

double InscribedBalls::calibreAround(const Index3& voxel) const {
  const Ball ball = ballAround(voxel);
  Vec3 sum = Vec3::Zero();
  Mat3 squares = Mat3::Zero();
  double count = 0;
  forNear(ball.centre, 2 * ball.radius, [&](const Index3&, const Vec3& way, double) {
    sum += way;
    squares += way * way.transpose();
    count += 1;
  });
  if (!(count > 0)) {
    return 0;
  }
  const Mat3 covariance = squares / count - (sum / count) * (sum / count).transpose();
  const Vec3 spread = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvalues();
  // A disc's variance along any diameter is a quarter of its squared radius.
  const double disc = 4 * std::pow(std::max(0.0, spread[0]) * std::max(0.0, spread[1]), 0.25);
  return std::clamp(disc, 2 * ball.radius, 2 * ball.radius + spacing_.norm());
}

}  // namespace glisson
