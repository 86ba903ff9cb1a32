#include "reconstruction/methods/mpu/quadric_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace glisson::mpu {

namespace {

template <int size>
using Vector = Eigen::Matrix<double, size, 1>;
template <int size>
using Matrix = Eigen::Matrix<double, size, size>;

/// What few points or points on a line leave open becomes 0: a share of the weights' sum on the diagonal, too little to bend a fit
/// that the points determine.
constexpr double kOpenCurvature = 1e-5;
constexpr double kOpenSlope = 1e-8;

/// Weighted least squares by normal equations.
template <int size>
struct Sums {
  Matrix<size> left = Matrix<size>::Zero();
  Vector<size> right = Vector<size>::Zero();

  void add(const Vector<size>& row, double wanted, double weight) {
    left.noalias() += weight * row * row.transpose();
    right += weight * wanted * row;
  }
  /// The first `curved` unknowns multiply squares.
  [[nodiscard]] Vector<size> solution(int curved, double weights) {
    for (int n = 0; n < size; ++n) {
      left(n, n) += weights * (n < curved ? kOpenCurvature : kOpenSlope);
    }
    return left.ldlt().solve(right);
  }
};

Vec3 inBall(const Ball& ball, const Vec3& x) { return (x - ball.centre) / ball.radius; }

}  // namespace

double weightAt(double distance, double radius) {
  const double t = 1.5 * distance / radius;
  if (t >= 1.5) {
    return 0;
  }
  return t <= 0.5 ? 0.75 - t * t : 0.5 * (1.5 - t) * (1.5 - t);
}

Vec3 meanNormal(const Ball& ball, const BallPoints& points) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t n : points.places) {
    sum += weightAt((points.positions[n] - ball.centre).norm(), ball.radius) * points.normals[n];
  }
  const double length = sum.norm();
  return length > 1e-9 ? Vec3(sum / length) : points.normals[points.places.front()];
}

Quadric fitHeight(const Ball& ball, const BallPoints& points, const Vec3& up) {
  const Vec3 u = up.unitOrthogonal();
  const Vec3 v = up.cross(u);
  Sums<6> sums;
  double weights = 0;
  for (const std::uint32_t n : points.places) {
    const Vec3 y = inBall(ball, points.positions[n]);
    const double weight = weightAt(y.norm(), 1.0);
    const double s = u.dot(y);
    const double t = v.dot(y);
    sums.add({s * s, s * t, t * t, s, t, 1}, up.dot(y), weight);
    weights += weight;
  }
  const Vector<6> h = sums.solution(3, weights);
  Quadric quadric;
  quadric.a = -(h[0] * u * u.transpose() + 0.5 * h[1] * (u * v.transpose() + v * u.transpose()) + h[2] * v * v.transpose());
  quadric.b = up - h[3] * u - h[4] * v;
  quadric.c = -h[5];
  return quadric;
}

Quadric fitGeneral(const Ball& ball, const BallPoints& points, std::span<const AuxiliaryPoint> auxiliary) {
  const auto rowOf = [&](const Vec3& x) {
    const Vec3 y = inBall(ball, x);
    Vector<10> row;
    row << y[0] * y[0], y[1] * y[1], y[2] * y[2], y[0] * y[1], y[1] * y[2], y[2] * y[0], y[0], y[1], y[2], 1;
    return row;
  };
  double weights = 0;
  for (const std::uint32_t n : points.places) {
    weights += weightAt((points.positions[n] - ball.centre).norm(), ball.radius);
  }
  Sums<10> sums;  // of both kinds of points the weights' sum is 1
  for (const std::uint32_t n : points.places) {
    const double weight = weightAt((points.positions[n] - ball.centre).norm(), ball.radius);
    sums.add(rowOf(points.positions[n]), 0, weight / weights);
  }
  for (const AuxiliaryPoint& point : auxiliary) {
    sums.add(rowOf(point.position), point.distance / ball.radius, 1.0 / static_cast<double>(auxiliary.size()));
  }
  const Vector<10> q = sums.solution(0, 1);
  Quadric quadric;
  quadric.a << q[0], 0.5 * q[3], 0.5 * q[5], 0.5 * q[3], q[1], 0.5 * q[4], 0.5 * q[5], 0.5 * q[4], q[2];
  quadric.b = q.segment<3>(6);
  quadric.c = q[9];
  return quadric;
}

double greatestError(const Ball& ball, const BallPoints& points, const Quadric& quadric) {
  constexpr double kFlat = 1e-6;  // a gradient near 0 says nothing of the distance: such a fit counts as far off
  double greatest = 0;
  for (const std::uint32_t n : points.places) {
    const Vec3 y = inBall(ball, points.positions[n]);
    greatest = std::max(greatest, std::abs(quadric.value(y)) / std::max(quadric.gradient(y).norm(), kFlat));
  }
  return greatest * ball.radius;
}

}  // namespace glisson::mpu
