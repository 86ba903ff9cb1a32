// MPU implicits against bodies whose surface is known: the error falls with the tolerance and stays within it, the surface is
// closed and outward, sheets outside the support are gone, and the bytes do not depend on threads.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "bodies.h"
#include "reconstruction/errors.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/methods/mpu/surface.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

using mpu::Ball;
using mpu::BallPoints;
using mpu::Cube;
using mpu::Patch;
using mpu::Quadric;
using test::Cloud;

const Vec3 kMiddle(40.3, 39.1, 41.2);
constexpr double kSphereRadius = 25;
constexpr double kRing = 22;
constexpr double kTube = 8;

Cube cubeAround(const Vec3& centre, double side) { return {centre - Vec3::Constant(0.5 * side), side}; }

void expectSound(const SurfaceMesh& mesh) {
  for (const std::string& name : mesh.defects().names()) {
    ADD_FAILURE() << name;
  }
}

struct Made {
  SurfaceMesh mesh;
  std::size_t patches = 0;
};

template <typename IsInside>
Made surfaceOf(const Cloud& cloud, const Cube& cube, double toleranceMm, int depth, const IsInside& isInside) {
  const std::vector<Patch> patches = mpu::fitPatches(cloud.positions, cloud.normals, cube, {toleranceMm, 1.0});
  return {mpu::polygonise(patches, cloud.positions, cube, {.depth = depth, .bandMm = 4}, isInside), patches.size()};
}

Made sphereOf(double toleranceMm, int depth = 6) {
  return surfaceOf(test::sphereCloud(kMiddle, kSphereRadius, 8000), cubeAround(kMiddle, 64), toleranceMm, depth,
                   [](const Vec3& p) { return (p - kMiddle).norm() < kSphereRadius; });
}

Made torusOf(double toleranceMm, int depth = 6) {
  return surfaceOf(test::torusCloud(kMiddle, kRing, kTube, 220, 80), cubeAround(kMiddle, 72), toleranceMm, depth,
                   [](const Vec3& p) { return test::distanceToTorus(p, kMiddle, kRing, kTube) < 0; });
}

double greatestOffTorus(const SurfaceMesh& mesh) {
  double greatest = 0;
  for (const Vec3& v : mesh.vertices) {
    greatest = std::max(greatest, std::abs(test::distanceToTorus(v, kMiddle, kRing, kTube)));
  }
  return greatest;
}

TEST(MpuWeights, AreTheQuadraticBSplineAndSmoothAtItsJoints) {
  EXPECT_EQ(mpu::weightAt(0, 2), 0.75);
  EXPECT_EQ(mpu::weightAt(2, 2), 0);
  EXPECT_EQ(mpu::weightAt(3, 2), 0);
  EXPECT_NEAR(mpu::weightAt(2.0 / 3, 2), 0.5, 1e-12);  // t = 1/2
  for (const double joint : {2.0 / 3, 2.0}) {
    const double before = mpu::weightAt(joint, 2) - mpu::weightAt(joint - 1e-6, 2);
    const double behind = mpu::weightAt(joint + 1e-6, 2) - mpu::weightAt(joint, 2);
    EXPECT_NEAR(before, behind, 1e-11);
  }
}

TEST(MpuFit, AHeightThatIsQuadraticIsFoundAgain) {
  const Ball ball{Vec3(3, -2, 5), 4};
  const Vec3 up = Vec3(1, 2, 2) / 3;
  const Vec3 u = up.unitOrthogonal();
  const Vec3 v = up.cross(u);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-2.2, 2.2);
  std::vector<Vec3> positions;
  for (int n = 0; n < 200; ++n) {
    const double s = value(random);
    const double t = value(random);
    positions.push_back(ball.centre + s * u + t * v + (0.3 + 0.1 * s - 0.2 * t + 0.05 * s * s - 0.03 * s * t + 0.02 * t * t) * up);
  }
  const std::vector<Vec3> normals(positions.size(), up);
  std::vector<std::uint32_t> places(positions.size());
  std::generate(places.begin(), places.end(), [n = 0U]() mutable { return n++; });
  const BallPoints points{positions, normals, places};
  const Quadric quadric = mpu::fitHeight(ball, points, up);
  EXPECT_LT(mpu::greatestError(ball, points, quadric), 1e-3 * ball.radius);
  // Outside is up, and the value is the distance over the radius.
  EXPECT_NEAR(quadric.value((positions[0] + 0.1 * up - ball.centre) / ball.radius), 0.1 / ball.radius, 2e-3);
}

TEST(MpuFit, AGeneralQuadricIsTheSphereThatItsPointsLieOn) {
  const Cloud cloud = test::sphereCloud(Vec3(1, 2, 3), 5, 500);
  const Ball ball{Vec3(1.5, 2, 3), 9};
  std::vector<std::uint32_t> places(cloud.positions.size());
  std::generate(places.begin(), places.end(), [n = 0U]() mutable { return n++; });
  std::vector<mpu::AuxiliaryPoint> auxiliary;
  for (const double distance : {-1.0, 1.0}) {
    for (const Vec3& normal : {cloud.normals[20], cloud.normals[250], cloud.normals[400]}) {
      auxiliary.push_back({Vec3(1, 2, 3) + (5 + distance) * normal, distance});
    }
  }
  const BallPoints points{cloud.positions, cloud.normals, places};
  const Quadric quadric = mpu::fitGeneral(ball, points, auxiliary);
  EXPECT_LT(mpu::greatestError(ball, points, quadric), 0.15);
  const auto distanceAt = [&](const Vec3& x) { return ball.radius * quadric.value((x - ball.centre) / ball.radius); };
  EXPECT_NEAR(distanceAt(Vec3(1, 2, 3) + 4.5 * cloud.normals[100]), -0.5, 0.15);
  EXPECT_NEAR(distanceAt(Vec3(1, 2, 3) + 5.5 * cloud.normals[100]), 0.5, 0.15);
}

TEST(Mpu, OfASphereIsClosedAndOutwardWithItsVolume) {
  const Made made = sphereOf(0.05);
  expectSound(made.mesh);
  EXPECT_EQ(eulerCharacteristic(made.mesh), 2);
  EXPECT_NEAR(signedVolumeMm3(made.mesh) / (4.0 / 3 * std::numbers::pi * std::pow(kSphereRadius, 3)), 1, 0.003);
  for (const Vec3& v : made.mesh.vertices) {
    EXPECT_NEAR((v - kMiddle).norm(), kSphereRadius, 0.1);
  }
}

TEST(Mpu, OfATorusIsWithinTheToleranceAndNearsItWithMoreAndSmallerCells) {
  double before = 1e9;
  std::size_t patches = 0;
  for (const double tolerance : {2.0, 0.5, 0.05}) {
    const Made made = torusOf(tolerance);
    expectSound(made.mesh);
    EXPECT_EQ(eulerCharacteristic(made.mesh), 0) << "a torus has one handle";
    const double greatest = greatestOffTorus(made.mesh);
    EXPECT_LT(greatest, tolerance + 0.02);
    EXPECT_LT(greatest, before);
    EXPECT_GT(made.patches, patches);
    before = greatest;
    patches = made.patches;
  }
  EXPECT_NEAR(signedVolumeMm3(torusOf(0.05, 7).mesh) / (2 * std::numbers::pi * std::numbers::pi * kRing * kTube * kTube), 1, 0.002);
}

TEST(Mpu, BeyondTheSamplesTheBodySaysWhatIsInside) {
  // One hole in the cloud: quadrics that are extrapolated into it must not make sheets far from the samples.
  Cloud cloud = test::sphereCloud(kMiddle, kSphereRadius, 8000);
  Cloud holed;
  for (std::size_t n = 0; n < cloud.positions.size(); ++n) {
    if (cloud.normals[n][0] < 0.6) {
      holed.positions.push_back(cloud.positions[n]);
      holed.normals.push_back(cloud.normals[n]);
    }
  }
  const Made made =
      surfaceOf(holed, cubeAround(kMiddle, 64), 0.05, 6, [](const Vec3& p) { return (p - kMiddle).norm() < kSphereRadius; });
  expectSound(made.mesh);
  EXPECT_EQ(eulerCharacteristic(made.mesh), 2);
  for (const Vec3& v : made.mesh.vertices) {
    EXPECT_NEAR((v - kMiddle).norm(), kSphereRadius, 1.5);  // a cell's diagonal is 1.7
  }
}

TEST(Mpu, IsTheSameBytesForAnyNumberOfThreads) {
  const auto make = [](int threads) {
    const ThreadLimit limit(threads);
    return torusOf(0.2).mesh;
  };
  const SurfaceMesh one = make(1);
  for (const int threads : {2, 8}) {
    const SurfaceMesh many = make(threads);
    EXPECT_EQ(one.vertices, many.vertices);
    EXPECT_EQ(one.triangles, many.triangles);
  }
}

TEST(Mpu, StopsOnCancelWhileFittingAndWhilePolygonising) {
  const Cloud cloud = test::sphereCloud(kMiddle, kSphereRadius, 2000);
  const Cube cube = cubeAround(kMiddle, 64);
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(mpu::fitPatches(cloud.positions, cloud.normals, cube, {0.1, 1.0}, context), Cancelled);
  const std::vector<Patch> patches = mpu::fitPatches(cloud.positions, cloud.normals, cube, {0.1, 1.0});
  EXPECT_THROW(mpu::polygonise(
                   patches, cloud.positions, cube, {.depth = 5, .bandMm = 4}, [](const Vec3&) { return false; }, context),
               Cancelled);
}

}  // namespace
}  // namespace glisson
