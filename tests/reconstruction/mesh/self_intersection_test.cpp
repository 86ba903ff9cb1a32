#include "reconstruction/mesh/self_intersection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/predicates.h"
#include "tests/reconstruction/mesh/solids.h"

namespace glisson {
namespace {

using test::box;
using test::sphere;
using test::tetrahedron;
using test::together;

TEST(Predicates, AreExactWhereRoundingHidesTheAnswer) {
  // Points one rounding step off a line or plane, far from the origin.
  const double base = 1e6;
  const double step = std::nextafter(base + 24.0, 1e9) - (base + 24.0);
  for (int n = -3; n <= 3; ++n) {
    const double off = n * step;
    EXPECT_EQ(orientation(Vec2(base, base), Vec2(base + 12, base + 12), Vec2(base + 24, base + 24 + off)), (n > 0) - (n < 0));
    EXPECT_EQ(orientation(Vec3(base, 0.1, base), Vec3(base + 12, 0.1, base + 12), Vec3(base + 12, 1e-7, base + 12),
                          Vec3(base + 24, 0.1, base + 24 + off)),
              (n < 0) - (n > 0))
        << n;
  }
}

TEST(Predicates, TheSideIsTheCounterClockwiseNormals) {
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), 1);
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)), -1);
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 0)), 0);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)), 1);
}

TEST(Predicates, SidesOfAPlaneAgreeWhateverTheOrderOfItsPoints) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(-3, 3);
  const auto point = [&] { return Vec3(coordinate(random) * 0.1, coordinate(random) * 0.7, coordinate(random) * 2.5); };
  for (int n = 0; n < 20000; ++n) {
    const Vec3 a = point();
    const Vec3 b = point();
    const Vec3 c = point();
    const Vec3 d = point();
    const int side = orientation(a, b, c, d);
    ASSERT_EQ(orientation(b, c, a, d), side);
    ASSERT_EQ(orientation(b, a, c, d), -side);
    ASSERT_EQ(orientation(a, b, d, c), -side);
    ASSERT_EQ(orientation(d, c, b, a), side);
  }
}

TEST(SelfIntersection, ClosedConvexBodiesHaveNone) {
  EXPECT_EQ(countSelfIntersections(tetrahedron()), 0U);
  EXPECT_EQ(countSelfIntersections(box({0.1, 0.2, 0.3}, {1, 2, 3}, 6)), 0U);
  EXPECT_EQ(countSelfIntersections(sphere({100, 200, 300}, 10, 4)), 0U);
  EXPECT_EQ(countSelfIntersections(SurfaceMesh{}), 0U);
}

TEST(SelfIntersection, TwoTrianglesThroughEachOtherAreOnePair) {
  const SurfaceMesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(countSelfIntersections(mesh), 1U);
}

TEST(SelfIntersection, TrianglesThatTouchInAPointOfTheirInsideArePairs) {
  const SurfaceMesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {3, 3, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(countSelfIntersections(mesh), 1U);
  SurfaceMesh apart = mesh;
  apart.vertices[3][2] = 1e-300;
  EXPECT_EQ(countSelfIntersections(apart), 0U);
}

TEST(SelfIntersection, OverlappingTrianglesOfOnePlaneAreAPair) {
  const SurfaceMesh overlapping{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.1, 0.1, 0}, {0.2, 0.1, 0}, {0.1, 0.2, 0}},
                                {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(countSelfIntersections(overlapping), 1U);
  const SurfaceMesh apart{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {5, 5, 0}, {6, 5, 0}, {5, 6, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(countSelfIntersections(apart), 0U);
}

TEST(SelfIntersection, TrianglesFoldedOntoEachOtherAtTheirCommonSideAreAPair) {
  const SurfaceMesh folded{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(countSelfIntersections(folded), 1U);
  const SurfaceMesh flat{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(countSelfIntersections(flat), 0U);
}

TEST(SelfIntersection, TrianglesWithOneCommonCornerMayMeetOnlyThere) {
  const SurfaceMesh crossing{{{0, 0, 0}, {4, -1, 0}, {4, 1, 0}, {2, 0, -1}, {2, 0, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(countSelfIntersections(crossing), 1U);
  const SurfaceMesh apart{{{0, 0, 0}, {4, -1, 0}, {4, 1, 0}, {-2, 0, -1}, {-2, 0, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(countSelfIntersections(apart), 0U);
}

TEST(SelfIntersection, ATriangleGivenTwiceIsAPair) {
  const SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
  EXPECT_EQ(countSelfIntersections(mesh), 1U);
}

TEST(SelfIntersection, CopiesOfOneVertexAreNoIntersection) {
  const SurfaceMesh mesh = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {1, 1, 1}));
  EXPECT_EQ(countSelfIntersections(mesh), 0U);
}

TEST(SelfIntersection, PenetratingSpheresAreFoundAsOftenAsByEveryPair) {
  const SurfaceMesh mesh = together(sphere({0, 0, 0}, 10, 2), sphere({9, 1, 2}, 7, 2));
  std::size_t pairs = 0;
  for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a) {
    for (std::uint32_t b = a + 1; b < mesh.triangles.size(); ++b) {
      SurfaceMesh two{{}, {{0, 1, 2}, {3, 4, 5}}};
      for (const std::uint32_t triangle : {a, b}) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
          two.vertices.push_back(mesh.vertices[corner]);
        }
      }
      pairs += countSelfIntersections(two);
    }
  }
  EXPECT_GT(pairs, 20U);
  EXPECT_EQ(countSelfIntersections(mesh), pairs);
  // Looked at from one of the spheres only, they are the same pairs.
  std::vector<std::uint32_t> second(320);
  std::iota(second.begin(), second.end(), 320U);
  EXPECT_EQ(selfIntersections(mesh, second), selfIntersections(mesh));
}

TEST(SelfIntersection, ADentThroughTheOtherSideIsFound) {
  SurfaceMesh mesh = sphere(Vec3::Zero(), 10, 3);
  ASSERT_EQ(countSelfIntersections(mesh), 0U);
  mesh.vertices[0] = -1.5 * mesh.vertices[0];
  EXPECT_GT(countSelfIntersections(mesh), 0U);
}

TEST(SelfIntersection, ACancelledCheckEnds) {
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(countSelfIntersections(sphere(Vec3::Zero(), 1, 3), context), Cancelled);
}

}  // namespace
}  // namespace glisson
