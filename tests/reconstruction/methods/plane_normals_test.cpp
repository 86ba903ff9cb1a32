// Normals of plane fits on bodies whose normals are known: within degrees, outward, turned with the grid, the same bytes always.
#include "reconstruction/methods/plane_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "bodies.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

using test::Body;
using test::bodyWhere;

const Vec3 kBallCentre(24.3, 23.8, 24.1);
constexpr double kBallRadius = 18;

Body slicedBall(double slice = 0.8) {
  return bodyWhere({61, 61, static_cast<int>(48.0 / slice) + 1}, Vec3(0.8, 0.8, slice),
                   [](const Vec3& p) { return (p - kBallCentre).norm() < kBallRadius; });
}

OrientedPoints planePoints(const Body& body, Sampling sampling, int neighbours = kUsualNeighbours) {
  return withPlaneNormals(sampleBoundary(body.mask, body.geometry, sampling), body.geometry, neighbours);
}

double degrees(const Vec3& a, const Vec3& b) { return 180 / std::numbers::pi * std::acos(std::clamp(a.dot(b), -1.0, 1.0)); }

/// The mean angle to the sphere's own normals.
double meanAngle(const OrientedPoints& points, const Vec3& centre = kBallCentre) {
  double sum = 0;
  for (std::size_t n = 0; n < points.positions.size(); ++n) {
    sum += degrees(points.normals[n], (points.positions[n] - centre).normalized());
  }
  return sum / static_cast<double>(points.positions.size());
}

TEST(PlaneNormals, OfAVoxelBallAreWithinDegreesOfTheSphereAndNearerWithMoreNeighbours) {
  const Body body = slicedBall();
  for (const Sampling sampling : {Sampling::Paper, Sampling::Unbiased}) {
    const double ten = meanAngle(planePoints(body, sampling, 10));
    const double forty = meanAngle(planePoints(body, sampling, 40));
    EXPECT_LT(ten, 20);
    EXPECT_LT(forty, 6);
    EXPECT_LT(forty, ten);
  }
}

TEST(PlaneNormals, OfTenVoxelCentresInThickSlicesFitTheSlicesAndFortyTheBody) {
  const Body body =
      bodyWhere({81, 81, 21}, Vec3(0.6, 0.6, 2.4), [](const Vec3& p) { return (p - kBallCentre).norm() < kBallRadius; });
  EXPECT_LT(1.5 * meanAngle(planePoints(body, Sampling::Paper, 40)), meanAngle(planePoints(body, Sampling::Paper, 10)));
}

TEST(PlaneNormals, OfASlabAreItsOwnAwayFromTheRim) {
  const Body slab = bodyWhere({40, 40, 20}, Vec3(0.7, 0.7, 1.5), [](const Vec3& p) { return p[2] > 6.2 && p[2] < 20.2; });
  const OrientedPoints points = planePoints(slab, Sampling::Unbiased);
  std::size_t seen = 0;
  for (std::size_t n = 0; n < points.positions.size(); ++n) {
    const Vec3& p = points.positions[n];
    if (std::min(p[0], p[1]) > 4 && std::max(p[0], p[1]) < 23) {
      ++seen;
      const Vec3 outward(0, 0, p[2] > 13 ? 1 : -1);
      EXPECT_LT(degrees(points.normals[n], outward), 1e-6);
      EXPECT_NEAR(points.weights[n], 0.7 * 0.7, 1e-9);
    }
  }
  EXPECT_GT(seen, 1000U);
}

TEST(PlaneNormals, AreUnitAndPointOutwardWithWeightsOfTheFacesArea) {
  const Body body = slicedBall();
  const OrientedPoints points = planePoints(body, Sampling::Unbiased);
  double area = 0;
  for (std::size_t n = 0; n < points.positions.size(); ++n) {
    EXPECT_NEAR(points.normals[n].norm(), 1, 1e-12);
    const Vec3 outward = body.geometry.direction.col(points.axes[n]) *
                         (points.positions[n] - kBallCentre).dot(body.geometry.direction.col(points.axes[n]));
    EXPECT_GE(points.normals[n].dot(outward), 0);
    EXPECT_NEAR(points.weights[n], 0.64 * std::abs(points.normals[n][points.axes[n]]), 1e-9);
    area += points.weights[n];
  }
  EXPECT_NEAR(area / (4 * std::numbers::pi * kBallRadius * kBallRadius), 1, 0.1);
  const OrientedPoints centres = planePoints(body, Sampling::Paper);
  for (std::size_t n = 0; n < centres.positions.size(); ++n) {
    EXPECT_GT(centres.normals[n].dot(centres.positions[n] - kBallCentre), 0);
    EXPECT_EQ(centres.weights[n], 1);
  }
}

TEST(PlaneNormals, AreAsGoodOnAnObliqueLeftHandedGrid) {
  Body body = slicedBall(1.6);
  const double straight = meanAngle(planePoints(body, Sampling::Unbiased), kBallCentre);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix() * Vec3(1, 1, -1).asDiagonal();
  body.geometry.direction = turn;
  // Not to the byte: of neighbours as far away as each other rounding may choose another.
  EXPECT_NEAR(meanAngle(planePoints(body, Sampling::Unbiased), turn * kBallCentre), straight, 0.5);
}

TEST(PlaneNormals, AreTheSameBytesForAnyNumberOfThreads) {
  const Body body = slicedBall(1.6);
  const auto make = [&](int threads) {
    const ThreadLimit limit(threads);
    return planePoints(body, Sampling::Paper);
  };
  const OrientedPoints one = make(1);
  for (const int threads : {2, 8}) {
    const OrientedPoints many = make(threads);
    EXPECT_EQ(one.normals, many.normals);
    EXPECT_EQ(one.weights, many.weights);
  }
}

TEST(PlaneNormals, OnALineStayThoseOfTheMask) {
  // A row of voxels far apart from each other: all neighbours lie on one line.
  OrientedPoints points;
  for (int n = 0; n < 20; ++n) {
    points.positions.push_back(Vec3(n, 0, 0));
    points.normals.push_back(Vec3(0, 0.6, 0.8));
    points.weights.push_back(1);
  }
  for (const Vec3& normal : withPlaneNormals(points, ImageGeometry()).normals) {
    EXPECT_EQ(normal, Vec3(0, 0.6, 0.8));
  }
}

TEST(PlaneNormals, WantThreeNeighboursAndStopOnCancel) {
  const Body body = slicedBall(1.6);
  const OrientedPoints points = sampleBoundary(body.mask, body.geometry, Sampling::Paper);
  EXPECT_THROW(withPlaneNormals(points, body.geometry, 2), std::invalid_argument);
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(withPlaneNormals(points, body.geometry, 10, context), Cancelled);
}

}  // namespace
}  // namespace glisson
