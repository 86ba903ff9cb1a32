#include "reconstruction/mesh/predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace glisson {

namespace {
constexpr double kUnit = 0.5 * std::numeric_limits<double>::epsilon();

struct Pair {
  double high;
  double low;
};

Pair twoSum(double a, double b) {
  const double sum = a + b;
  const double bVirtual = sum - a;
  return {sum, (a - (sum - bVirtual)) + (b - bVirtual)};
}

Pair twoProduct(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// An exact sum of doubles as non-overlapping parts of growing magnitude; its sign is that of the last part.
template <std::size_t Capacity>
class ExactSum {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < size_; ++n) {
      const Pair pair = twoSum(value, parts_[n]);
      value = pair.high;
      if (pair.low != 0) {
        parts_[kept++] = pair.low;
      }
    }
    if (value != 0) {
      parts_[kept++] = value;
    }
    size_ = kept;
  }
  void addProduct(double a, double b) {
    const Pair pair = twoProduct(a, b);
    add(pair.low);
    add(pair.high);
  }
  void addProduct(double a, double b, double c) {
    const Pair pair = twoProduct(a, b);
    addProduct(pair.low, c);
    addProduct(pair.high, c);
  }
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : (parts_[size_ - 1] > 0 ? 1 : -1); }

 private:
  std::array<double, Capacity> parts_{};
  std::size_t size_ = 0;
};

int signOf(double value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

int exactOrientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  ExactSum<16> sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(b[0], c[1]);
  sum.addProduct(-b[1], c[0]);
  sum.addProduct(c[0], a[1]);
  sum.addProduct(-c[1], a[0]);
  return sum.sign();
}

/// Adds factor * det(a, b, c).
template <typename Sum>
void addDeterminant(Sum& sum, double factor, const Vec3& a, const Vec3& b, const Vec3& c) {
  sum.addProduct(factor * a[0], b[1], c[2]);
  sum.addProduct(-factor * a[0], b[2], c[1]);
  sum.addProduct(factor * a[1], b[2], c[0]);
  sum.addProduct(-factor * a[1], b[0], c[2]);
  sum.addProduct(factor * a[2], b[0], c[1]);
  sum.addProduct(-factor * a[2], b[1], c[0]);
}

bool isExactDifference(const Vec3& a, const Vec3& b) {
  for (int n = 0; n < 3; ++n) {
    if (twoSum(a[n], -b[n]).low != 0) {
      return false;
    }
  }
  return true;
}

int exactOrientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (isExactDifference(a, d) && isExactDifference(b, d) && isExactDifference(c, d)) {
    ExactSum<32> sum;
    addDeterminant(sum, -1.0, a - d, b - d, c - d);
    return sum.sign();
  }
  ExactSum<128> sum;
  addDeterminant(sum, -1.0, a, b, c);
  addDeterminant(sum, 1.0, a, b, d);
  addDeterminant(sum, -1.0, a, c, d);
  addDeterminant(sum, 1.0, b, c, d);
  return sum.sign();
}
}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  const double bound = (3.0 + 16.0 * kUnit) * kUnit * (std::abs(left) + std::abs(right));
  return std::abs(det) > bound ? signOf(det) : exactOrientation(a, b, c);
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d;
  const Vec3 v = b - d;
  const Vec3 w = c - d;
  const double vw0 = v[0] * w[1];
  const double vw1 = v[1] * w[0];
  const double wu0 = w[0] * u[1];
  const double wu1 = w[1] * u[0];
  const double uv0 = u[0] * v[1];
  const double uv1 = u[1] * v[0];
  const double det = u[2] * (vw0 - vw1) + v[2] * (wu0 - wu1) + w[2] * (uv0 - uv1);
  const double permanent = (std::abs(vw0) + std::abs(vw1)) * std::abs(u[2]) + (std::abs(wu0) + std::abs(wu1)) * std::abs(v[2]) +
                           (std::abs(uv0) + std::abs(uv1)) * std::abs(w[2]);
  if (permanent == 0) {
    return 0;  // differences vanish only where they are exact: all four points share a coordinate, or two are one
  }
  const double bound = (7.0 + 56.0 * kUnit) * kUnit * permanent;
  return std::abs(det) > bound ? -signOf(det) : exactOrientation(a, b, c, d);
}

bool surelyInCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = a - d;
  const Vec2 v = b - d;
  const Vec2 w = c - d;
  const double vw0 = v[0] * w[1];
  const double vw1 = w[0] * v[1];
  const double wu0 = w[0] * u[1];
  const double wu1 = u[0] * w[1];
  const double uv0 = u[0] * v[1];
  const double uv1 = v[0] * u[1];
  const double u2 = u.squaredNorm();
  const double v2 = v.squaredNorm();
  const double w2 = w.squaredNorm();
  const double det = u2 * (vw0 - vw1) + v2 * (wu0 - wu1) + w2 * (uv0 - uv1);
  const double permanent =
      (std::abs(vw0) + std::abs(vw1)) * u2 + (std::abs(wu0) + std::abs(wu1)) * v2 + (std::abs(uv0) + std::abs(uv1)) * w2;
  return det > (10.0 + 96.0 * kUnit) * kUnit * permanent;
}

}  // namespace glisson
