#include "planning/volumetry/convex_projection.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "planning/infinity.h"

namespace glisson {

namespace {

class Projection {
 public:
  Projection(const Vec3& p, std::span<const ImagePlane> planes) : p_(p), planes_(planes) {}

  void keep(double& best, Vec3& normal) const {
    if (isInside(p_)) {
      best = 0;
      return;
    }
    const Vec3 step = find();
    const double length = step.norm();
    if (length < best) {
      best = length;
      normal = step / length;
    }
  }

 private:
  static constexpr double kParallel = 1e-12;  ///< least determinant of normals that meet

  [[nodiscard]] bool isInside(const Vec3& q) const {
    return std::ranges::all_of(planes_, [&](const ImagePlane& plane) { return plane.distance(q) >= -kOnPlaneMm; });
  }
  [[nodiscard]] double missing(std::size_t plane) const { return -planes_[plane].distance(p_); }
  [[nodiscard]] double gram(std::size_t a, std::size_t b) const { return planes_[a].normal.dot(planes_[b].normal); }

  [[nodiscard]] Vec3 find() const {
    Vec3 step = Vec3::Constant(kInfinity);
    const std::size_t count = planes_.size();
    for (std::size_t a = 0; a < count; ++a) {
      if (reaches(missing(a) / gram(a, a) * planes_[a].normal, missing(a) >= 0, step)) {
        return step;
      }
    }
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        if (meetsTwo(a, b, step)) {
          return step;
        }
      }
    }
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        for (std::size_t c = b + 1; c < count; ++c) {
          if (meetsThree({a, b, c}, step)) {
            return step;
          }
        }
      }
    }
    return Vec3::Constant(kInfinity);
  }
  [[nodiscard]] bool reaches(const Vec3& by, bool positive, Vec3& step) const {
    if (!positive || !isInside(p_ + by)) {
      return false;
    }
    step = by;
    return true;
  }
  [[nodiscard]] bool meetsTwo(std::size_t a, std::size_t b, Vec3& step) const {
    const double across = gram(a, b);
    const double determinant = gram(a, a) * gram(b, b) - across * across;
    if (determinant < kParallel) {
      return false;
    }
    const double first = (missing(a) * gram(b, b) - missing(b) * across) / determinant;
    const double second = (missing(b) * gram(a, a) - missing(a) * across) / determinant;
    return reaches(first * planes_[a].normal + second * planes_[b].normal, first >= 0 && second >= 0, step);
  }
  [[nodiscard]] bool meetsThree(const std::array<std::size_t, 3>& active, Vec3& step) const {
    Mat3 normals;
    Vec3 wanted;
    for (std::size_t n = 0; n < active.size(); ++n) {
      normals.col(static_cast<Eigen::Index>(n)) = planes_[active[n]].normal;
      wanted[static_cast<Eigen::Index>(n)] = missing(active[n]);
    }
    if (std::abs(normals.determinant()) < kParallel) {
      return false;
    }
    const Vec3 by = normals.transpose().inverse() * wanted;  // each plane is met
    const Vec3 weights = normals.inverse() * by;
    return reaches(by, weights.minCoeff() >= 0, step);
  }

  Vec3 p_;
  std::span<const ImagePlane> planes_;
};

}  // namespace

void keepProjection(const Vec3& p, std::span<const ImagePlane> planes, double& best, Vec3& normal) {
  Projection(p, planes).keep(best, normal);
}

}  // namespace glisson
