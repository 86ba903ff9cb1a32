// trueError: the distance to the analytic body behind the voxels, the only error that rewards no method
// for its own sampling.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/poisson/poisson.h"
#include "tests/reconstruction/methods/bodies.h"

namespace glisson {
namespace {

/// From a point to the ellipsoid about the origin, positive outside. The foot point is a_i^2 p_i / (a_i^2 + t) for the one t above
/// -min a_i^2 that puts it on the surface; found by bisection (Eberly, "Distance from a point to an ellipsoid", 2013).
double distanceToEllipsoid(const Vec3& p, const Vec3& axes) {
  const Vec3 squared = axes.cwiseAbs2();
  const Vec3 scaled = axes.cwiseProduct(p);
  const auto excess = [&](double t) { return scaled.cwiseQuotient((squared.array() + t).matrix()).squaredNorm() - 1; };
  Eigen::Index least = 0;
  squared.minCoeff(&least);
  double low = -squared[least] + std::abs(scaled[least]);
  double high = -squared[least] + scaled.norm();
  for (int step = 0; step < 200 && low < high; ++step) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) {
      break;
    }
    (excess(middle) > 0 ? low : high) = middle;
  }
  const Vec3 foot = squared.cwiseProduct(p).cwiseQuotient((squared.array() + low).matrix());
  return (p.cwiseQuotient(axes).squaredNorm() < 1 ? -1.0 : 1.0) * (p - foot).norm();
}

double distanceToCapsule(const Vec3& p, const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = to - from;
  const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - from - t * along).norm() - radius;
}

struct TrueError {
  double meanMm = 0;    ///< of the distance, by area
  double signedMm = 0;  ///< positive: the mesh lies outside the body
};

template <typename Distance>
TrueError trueErrorOf(const SurfaceMesh& mesh, const Distance& distance) {
  TrueError error;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3& b = mesh.vertices[t[1]];
    const Vec3& c = mesh.vertices[t[2]];
    const double weight = (b - a).cross(c - a).norm();
    for (const Vec3& p : {Vec3((4 * a + b + c) / 6), Vec3((a + 4 * b + c) / 6), Vec3((a + b + 4 * c) / 6)}) {
      const double d = distance(p);
      error.meanMm += weight * std::abs(d);
      error.signedMm += weight * d;
      area += weight;
    }
  }
  error.meanMm /= area;
  error.signedMm /= area;
  return error;
}

SurfaceMesh psr(const test::Body& body, int depth, Sampling sampling) {
  PoissonParameters parameters;
  parameters.depth = depth;
  parameters.sampling = sampling;
  return reconstructPoisson(body.mask, body.geometry, parameters).mesh;
}

TEST(TrueError, DistanceToAnEllipsoidIsThatOfABallAndOfItsPoles) {
  EXPECT_NEAR(distanceToEllipsoid(Vec3(3, 4, 12), Vec3(10, 10, 10)), 3, 1e-9);
  EXPECT_NEAR(distanceToEllipsoid(Vec3(1, -2, 2), Vec3(10, 10, 10)), -7, 1e-9);
  EXPECT_NEAR(distanceToEllipsoid(Vec3(52, 1e-9, 1e-9), Vec3(50, 30, 20)), 2, 1e-6);
  EXPECT_NEAR(distanceToEllipsoid(Vec3(1e-9, 1e-9, -19), Vec3(50, 30, 20)), -1, 1e-6);
}

TEST(TrueError, OfALiverSizedEllipsoidIsLeastByPoissonOfFaces) {
  const Vec3 axes(100, 70, 80);  // a liver's width, depth and height
  const Vec3 centre(105.1, 75.2, 86.3);
  const test::Body body = test::bodyWhere({271, 194, 70}, Vec3(0.78, 0.78, 2.5),
                                          [&](const Vec3& p) { return (p - centre).cwiseQuotient(axes).squaredNorm() < 1; });
  const auto distance = [&](const Vec3& p) { return distanceToEllipsoid(p - centre, axes); };
  const TrueError seven = trueErrorOf(psr(body, 7, Sampling::Unbiased), distance);
  const TrueError eight = trueErrorOf(psr(body, 8, Sampling::Unbiased), distance);
  const TrueError paper = trueErrorOf(psr(body, 7, Sampling::Paper), distance);
  McsdParameters plain;
  plain.smoothing = 0;
  plain.decimation = 0;
  const TrueError marchingCubes = trueErrorOf(reconstructMcsd(body.mask, body.geometry, plain).mesh, distance);
  EXPECT_LE(seven.meanMm, 0.090);
  EXPECT_LT(seven.meanMm, eight.meanMm);
  EXPECT_LT(eight.meanMm, 0.134);
  EXPECT_LT(eight.meanMm, marchingCubes.meanMm);
  EXPECT_LT(marchingCubes.meanMm, paper.meanMm);
  EXPECT_LT(std::abs(seven.signedMm), 0.03 * 2.5);
}

class SmallBodies : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Slices, SmallBodies, testing::Values(0.8, 2.5, 5.0));

TEST_P(SmallBodies, OfATumoursAndAVesselsSizeAreNotDisplaced) {
  const double slice = GetParam();
  const Index3 size{64, 64, static_cast<int>(48 / slice) + 2};
  const Vec3 middle(25.1, 24.8, 23.9);
  const Vec3 from(9, 11, 12), to(40, 37, 35);
  const auto tumour = [&](const Vec3& p) { return (p - middle).norm() - 8; };
  const auto vessel = [&](const Vec3& p) { return distanceToCapsule(p, from, to, 5); };
  const auto check = [&](const char* what, const auto& distance) {
    const test::Body body = test::bodyWhere(size, Vec3(0.8, 0.8, slice), [&](const Vec3& p) { return distance(p) < 0; });
    for (int depth = 6; depth <= 8; ++depth) {  // at d=5 a cell is wider than a quarter of the body
      const SurfaceMesh mesh = psr(body, depth, Sampling::Unbiased);
      const double voxels = static_cast<double>(body.mask.count()) * body.geometry.voxelVolumeMm3();
      EXPECT_TRUE(mesh.defects().names().empty()) << what << " d=" << depth;
      EXPECT_LT(std::abs(trueErrorOf(mesh, distance).signedMm), 0.03 * slice) << what << " d=" << depth;
      EXPECT_NEAR(signedVolumeMm3(mesh) / voxels, 1, 0.005) << what << " d=" << depth;
    }
  };
  check("tumour", tumour);
  check("vessel", vessel);
}

}  // namespace
}  // namespace glisson
