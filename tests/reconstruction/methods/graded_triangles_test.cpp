// Triangles that follow a vessel's calibre: on an analytic tree the edges have one proportion to the radius on every branch, and
// the surface stays where it was.
#include "reconstruction/methods/graded_triangles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "bodies.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/methods/local_radius.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/parallel.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {
namespace {

struct Branch {
  Vec3 from;
  Vec3 to;
  double radius;

  [[nodiscard]] double distanceTo(const Vec3& p) const {
    const Vec3 axis = to - from;
    const double along = std::clamp((p - from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (p - from - along * axis).norm() - radius;
  }
  /// Away from its ends, where it meets others or is a cap.
  [[nodiscard]] bool isBeside(const Vec3& p) const {
    const double share = (p - from).dot(to - from) / (to - from).squaredNorm();
    return share > 0.4 && share < 0.9;
  }
};

/// From a trunk to twigs a fifth as thick.
const std::array<Branch, 6> kTree{{{Vec3(30, 10, 30), Vec3(30, 40, 30), 6.0},
                                   {Vec3(30, 40, 30), Vec3(12, 66, 24), 3.6},
                                   {Vec3(30, 40, 30), Vec3(48, 66, 38), 3.0},
                                   {Vec3(12, 66, 24), Vec3(8, 92, 12), 2.0},
                                   {Vec3(12, 66, 24), Vec3(22, 92, 30), 1.5},
                                   {Vec3(48, 66, 38), Vec3(52, 92, 46), 1.2}}};
constexpr double kPixelMm = 0.5;

std::size_t branchAt(const Vec3& p) {
  const auto nearest = std::ranges::min_element(kTree, {}, [&](const Branch& branch) { return branch.distanceTo(p); });
  return static_cast<std::size_t>(nearest - kTree.begin());
}
double distanceToTree(const Vec3& p) { return kTree[branchAt(p)].distanceTo(p); }

test::Body tree() {
  return test::bodyWhere({120, 210, 60}, Vec3(kPixelMm, kPixelMm, 1.0), [](const Vec3& p) { return distanceToTree(p) < 0; });
}

/// The surface that the method grades: its own depth, before any collapse.
SurfaceMesh solved(const test::Body& body) {
  return reconstructPoisson(body.mask, body.geometry, {.depth = 10, .pointWeight = 16, .finestCell = 0.8}).mesh;
}

double medianOf(std::vector<double> values) {
  EXPECT_FALSE(values.empty());
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

/// Of each branch: the median length of its edges over its radius.
std::array<double, kTree.size()> edgesOverRadius(const SurfaceMesh& mesh) {
  std::array<std::vector<double>, kTree.size()> lengths;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec3& a = mesh.vertices[t[e]];
      const Vec3& b = mesh.vertices[t[(e + 1) % 3]];
      const std::size_t n = branchAt(0.5 * (a + b));
      if (kTree[n].isBeside(0.5 * (a + b))) {
        lengths[n].push_back((b - a).norm() / kTree[n].radius);
      }
    }
  }
  std::array<double, kTree.size()> medians{};
  std::ranges::transform(lengths, medians.begin(), medianOf);
  return medians;
}

double largestOverSmallest(const std::array<double, kTree.size()>& values) {
  return *std::ranges::max_element(values) / *std::ranges::min_element(values);
}

/// Mean distance of the surface (not of its vertices alone) to the tree, mm.
double trueErrorMm(const SurfaceMesh& mesh) {
  double sum = 0;
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 u = mesh.vertices[t[1]] - a;
    const Vec3 v = mesh.vertices[t[2]] - a;
    const double whole = 0.5 * u.cross(v).norm();
    const int parts = 1 + static_cast<int>(std::sqrt(whole) / 0.3);
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; j + i < parts; ++j) {
        const double share = whole / (0.5 * parts * (parts + 1));
        sum += share * std::abs(distanceToTree(a + ((i + 1.0 / 3) * u + (j + 1.0 / 3) * v) / parts));
        area += share;
      }
    }
  }
  return sum / area;
}

TEST(LocalRadius, IsInOneProportionToEveryBranchsOwn) {
  const test::Body body = tree();
  const SurfaceMesh mesh = solved(body);
  const std::vector<double> radii = localRadii(mesh);
  ASSERT_EQ(radii.size(), mesh.vertices.size());
  std::array<std::vector<double>, kTree.size()> shares;
  for (std::size_t v = 0; v < radii.size(); ++v) {
    EXPECT_GT(radii[v], 0);
    const std::size_t n = branchAt(mesh.vertices[v]);
    if (kTree[n].isBeside(mesh.vertices[v])) {
      shares[n].push_back(radii[v] / kTree[n].radius);
    }
  }
  std::array<double, kTree.size()> medians{};
  std::ranges::transform(shares, medians.begin(), medianOf);
  for (const double median : medians) {
    EXPECT_GT(median, 0.65);
    EXPECT_LT(median, 1.05);
  }
  EXPECT_LT(largestOverSmallest(medians), 1.25);
}

TEST(LocalRadius, OfABallIsTheBalls) {
  const test::Body body =
      test::bodyWhere({60, 60, 40}, Vec3(0.5, 0.5, 0.8), [](const Vec3& p) { return (p - Vec3(15, 15, 16)).norm() < 11; });
  const SurfaceMesh mesh = solved(body);
  EXPECT_NEAR(medianOf(localRadii(mesh)), 11, 1.7);
}

TEST(GradedTriangles, EdgesHaveOneProportionToTheRadiusOnTrunkAndTwigs) {
  const test::Body body = tree();
  const SurfaceMesh before = solved(body);
  EXPECT_GT(largestOverSmallest(edgesOverRadius(before)), 4) << "cells of one size everywhere";
  const SurfaceMesh graded = variantOf(listedMethod("vessels"), "v1").make({body.mask, body.geometry}, {}).mesh;
  EXPECT_LT(largestOverSmallest(edgesOverRadius(graded)), 1.35);
  EXPECT_LT(graded.triangles.size(), before.triangles.size() / 3);
}

TEST(GradedTriangles, TheSurfaceStaysWhereItWas) {
  const test::Body body = tree();
  const SurfaceMesh before = solved(body);
  const double volume = signedVolumeMm3(before);
  for (const double boundMm : {0.1, 0.5}) {
    const SurfaceMesh graded = gradeTriangles(before, 0.8, boundMm);
    EXPECT_FALSE(graded.defects().any());
    EXPECT_EQ(countSelfIntersections(graded), 0U);
    EXPECT_NEAR(signedVolumeMm3(graded), volume, 1e-4 * volume);
    const std::vector<double> distances = MeshDistance(graded).to(before.vertices);
    EXPECT_LE(*std::ranges::max_element(distances), boundMm);
    EXPECT_LT(trueErrorMm(graded), (boundMm < kPixelMm ? 1.02 : 1.1) * trueErrorMm(before)) << boundMm;
  }
}

TEST(GradedTriangles, AreTheSameBytesForAnyNumberOfThreads) {
  const test::Body body = tree();
  const SurfaceMesh before = solved(body);
  SurfaceMesh first;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    const SurfaceMesh graded = gradeTriangles(before, 0.8, 0.5);
    if (first.empty()) {
      first = graded;
    }
    EXPECT_EQ(graded.vertices, first.vertices) << threads;
    EXPECT_EQ(graded.triangles, first.triangles) << threads;
  }
}

TEST(GradedTriangles, StopWhenTheyAreCancelled) {
  const test::Body body = tree();
  const SurfaceMesh before = solved(body);
  ExecutionContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(gradeTriangles(before, 0.8, 0.5, cancelled), Cancelled);
}

}  // namespace
}  // namespace glisson
