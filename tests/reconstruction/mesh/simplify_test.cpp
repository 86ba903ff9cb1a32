#include "reconstruction/mesh/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/mesh/half_edges.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/poisson/poisson.h"
#include "tests/reconstruction/mesh/solids.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

SurfaceMesh joined(SurfaceMesh a, const SurfaceMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return a;
}

/// A torus about the z axis, n x m vertices.
SurfaceMesh torus(double major, double minor, std::uint32_t n, std::uint32_t m) {
  SurfaceMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2 * M_PI * i / n;
      const double v = 2 * M_PI * j / m;
      mesh.vertices.emplace_back((major + minor * std::cos(v)) * std::cos(u), (major + minor * std::cos(v)) * std::sin(u),
                                 minor * std::sin(v));
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return (a % n) * m + b % m; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Random balls and rods of voxels, some of them thin or touching by an edge.
Mask randomMask(std::mt19937& random, const Index3& size) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0);
  std::uniform_int_distribution<int> at(3, size[0] - 4);
  std::uniform_int_distribution<int> radius(0, 5);
  for (int part = 0; part < 6; ++part) {
    const Index3 centre{at(random), at(random), at(random)};
    const Index3 reach{radius(random), radius(random), radius(random)};
    for (int k = std::max(0, centre[2] - reach[2]); k <= std::min(size[2] - 1, centre[2] + reach[2]); ++k) {
      for (int j = std::max(0, centre[1] - reach[1]); j <= std::min(size[1] - 1, centre[1] + reach[1]); ++j) {
        for (int i = std::max(0, centre[0] - reach[0]); i <= std::min(size[0] - 1, centre[0] + reach[0]); ++i) {
          values[static_cast<std::size_t>(i + size[0] * (j + size[1] * k))] = 1;
        }
      }
    }
  }
  return Mask::fromGrid(size, values);
}

TEST(Simplify, ABoxOfManySquaresBecomesTwelveTrianglesWithinTenMicrometres) {
  const SurfaceMesh fine = test::box({-10, 5, 100}, {40, 30, 20}, 16);
  const SurfaceMesh coarse = simplify(fine, {.triangles = 12});
  EXPECT_EQ(coarse.triangles.size(), 12U);
  EXPECT_FALSE(coarse.defects().any());
  EXPECT_NEAR(signedVolumeMm3(coarse), 24000, 1e-6);
  EXPECT_LT(std::ranges::max(MeshDistance(coarse).to(fine.vertices)), 1e-2);
}

TEST(Simplify, KeepsVolumePiecesAndHandles) {
  const SurfaceMesh fine = joined(torus(20, 6, 96, 48), test::sphere({60, 0, 0}, 10, 4));
  const SurfaceMesh coarse = simplify(fine, {.triangles = 600});
  EXPECT_EQ(coarse.triangles.size(), 600U);
  EXPECT_FALSE(coarse.defects().any());
  EXPECT_NEAR(signedVolumeMm3(coarse) / signedVolumeMm3(fine), 1, 1e-9);
  EXPECT_EQ(eulerCharacteristic(coarse), 2) << "a torus has 0, a sphere 2";
  std::uint32_t pieces = 0;
  componentOfTriangles(coarse, pieces);
  EXPECT_EQ(pieces, 2U);
  EXPECT_LT(std::ranges::max(MeshDistance(coarse).to(fine.vertices)), 0.7);
}

TEST(Simplify, NoPieceBecomesLessThanATetrahedron) {
  const SurfaceMesh coarse = simplify(joined(test::sphere({0, 0, 0}, 5, 2), test::box({20, 0, 0}, {4, 4, 4}, 2)), {.triangles = 4});
  EXPECT_EQ(coarse.triangles.size(), 8U);
  EXPECT_FALSE(coarse.defects().any());
}

TEST(Simplify, ADistanceIsKeptAndUsed) {
  const SurfaceMesh fine = test::sphere({3, -2, 7}, 25, 5);
  std::size_t before = fine.triangles.size();
  for (const double distance : {0.05, 0.2, 1.0}) {
    const SurfaceMesh coarse = simplify(fine, {.distanceMm = distance});
    EXPECT_LE(std::ranges::max(MeshDistance(coarse).to(fine.vertices)), distance);
    EXPECT_LE(std::ranges::max(MeshDistance(fine).to(coarse.vertices)), distance);
    EXPECT_LT(coarse.triangles.size(), before / 2) << distance;
    EXPECT_FALSE(coarse.defects().any());
    before = coarse.triangles.size();
  }
}

TEST(Simplify, RandomLabelMapsStaySoundAndKeepTheirVolume) {
  std::mt19937 random(20260);
  const Index3 size{26, 26, 26};
  for (int n = 0; n < test::trials(60); ++n) {
    ImageGeometry geometry;
    geometry.size = size;
    geometry.spacing = Vec3(0.7, 0.9, 1.0 + 0.1 * (n % 30));
    const SurfaceMesh fine = reconstructPoisson(randomMask(random, size), geometry, {.depth = 6}).mesh;
    const SurfaceMesh coarse = simplify(fine, {.triangles = std::max<std::size_t>(200, fine.triangles.size() / 10)});
    EXPECT_FALSE(coarse.defects().any()) << n;
    EXPECT_EQ(countSelfIntersections(coarse), 0U) << n;
    EXPECT_EQ(eulerCharacteristic(coarse), eulerCharacteristic(fine)) << n;
    EXPECT_NEAR(signedVolumeMm3(coarse) / signedVolumeMm3(fine), 1, 5e-4) << n;
  }
}

TEST(Simplify, TheSameMeshGivesTheSameBytesTwice) {
  const SurfaceMesh fine = torus(20, 6, 64, 32);
  const SurfaceMesh once = simplify(fine, {.triangles = 500});
  const SurfaceMesh twice = simplify(fine, {.triangles = 500});
  EXPECT_EQ(once.triangles, twice.triangles);
  EXPECT_EQ(once.vertices, twice.vertices);
}

TEST(Simplify, WhatIsNotClosedOrMakesNoSenseIsRefused) {
  SurfaceMesh open = test::tetrahedron();
  open.triangles.pop_back();
  EXPECT_THROW(simplify(open, {.triangles = 4}), CheckFailed);
  EXPECT_THROW(simplify(test::tetrahedron(), {}), UsageError);
  EXPECT_THROW(simplify(test::tetrahedron(), {.triangles = 3}), UsageError);
  EXPECT_THROW(simplify(test::tetrahedron(), {.triangles = 10, .distanceMm = 1}), UsageError);
  EXPECT_THROW(simplify(test::tetrahedron(), {.distanceMm = -1}), UsageError);
}

TEST(Simplify, ACancelEndsIt) {
  ExecutionContext context([](double, std::string_view) {});
  context.cancel();
  EXPECT_THROW(simplify(test::sphere({0, 0, 0}, 10, 4), {.triangles = 100}, context), Cancelled);
}

TEST(HalfEdges, ATetrahedronHasNoEdgeToCollapse) {
  const SurfaceMesh mesh = test::tetrahedron();
  HalfEdges connectivity(mesh.vertices.size(), mesh.triangles);
  for (std::uint32_t h = 0; h < connectivity.count(); ++h) {
    EXPECT_FALSE(connectivity.canCollapse(h));
  }
}

TEST(HalfEdges, ACollapseTakesTwoTrianglesAndTheEdgesTarget) {
  const SurfaceMesh mesh = test::sphere({0, 0, 0}, 1, 0);
  HalfEdges connectivity(mesh.vertices.size(), mesh.triangles);
  ASSERT_TRUE(connectivity.canCollapse(0));
  const std::uint32_t gone = connectivity.target(0);
  connectivity.collapse(0);
  EXPECT_EQ(connectivity.triangleCount(), 18U);
  const SurfaceMesh left{mesh.vertices, connectivity.triangles()};
  EXPECT_FALSE(left.defects().any());
  for (const Triangle& t : left.triangles) {
    EXPECT_EQ(std::ranges::find(t, gone), t.end());
  }
}

}  // namespace
}  // namespace glisson
