#include "reconstruction/mesh/distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "reconstruction/mesh/curvature.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

SurfaceMesh sphere(double radius, int rings, int sectors) {
  SurfaceMesh mesh;
  mesh.vertices.emplace_back(0, 0, radius);
  for (int ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (int sector = 0; sector < sectors; ++sector) {
      const double angle = 2 * std::numbers::pi * sector / sectors;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(angle), radius * std::sin(polar) * std::sin(angle),
                                 radius * std::cos(polar));
    }
  }
  mesh.vertices.emplace_back(0, 0, -radius);
  const auto at = [&](int ring, int sector) { return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors); };
  const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (int sector = 0; sector < sectors; ++sector) {
    mesh.triangles.push_back({0, at(1, sector), at(1, sector + 1)});
    mesh.triangles.push_back({south, at(rings - 1, sector + 1), at(rings - 1, sector)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)});
      mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)});
    }
  }
  return mesh;
}

// Another road to the same number: the distance to the row of the triangle parallel to bc is convex in the row's place.
double slowDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto alongRow = [&](double u) {
    const Vec3 from = a + u * (b - a);
    const Vec3 to = a + u * (c - a);
    const Vec3 along = to - from;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::min(1.0, std::max(0.0, (p - from).dot(along) / length)) : 0.0;
    return (from + t * along - p).norm();
  };
  double low = 0;
  double high = 1;
  for (int i = 0; i < 200; ++i) {
    const double left = low + (high - low) / 3;
    const double right = high - (high - low) / 3;
    if (alongRow(left) < alongRow(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return alongRow(0.5 * (low + high));
}

TEST(Distance, OfAPointToATriangleAgreesWithConvexSearch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = point();
    const Vec3 b = point();
    const Vec3 c = point();
    const Vec3 p = 3 * point();
    EXPECT_NEAR(distanceToTriangle(p, a, b, c), slowDistance(p, a, b, c), 1e-6);
  }
}

TEST(Distance, OfAPointToATriangleIsExactInEveryRegion) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({0.5, 0.5, 3}, a, b, c), 3);
  EXPECT_DOUBLE_EQ(distanceToTriangle({-3, -4, 0}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(distanceToTriangle({5, 0, 4}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(distanceToTriangle({1, -2, 0}, a, b, c), 2);
  EXPECT_DOUBLE_EQ(distanceToTriangle({2, 2, 0}, a, b, c), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(distanceToTriangle({0.5, 0.25, 0}, a, b, c), 0);
}

TEST(Distance, OfAPointToACollapsedTriangleIsThatToItsSegmentOrPoint) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({1, 3, 0}, a, b, a), 3);
  EXPECT_DOUBLE_EQ(distanceToTriangle({0, 3, 4}, a, a, a), 5);
}

TEST(Distance, OfTheTreeIsThatOfBruteForce) {
  const SurfaceMesh mesh = sphere(40, 24, 37);
  const MeshDistance distance(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-80, 80);
  std::vector<Vec3> points;
  for (int i = 0; i < 3000; ++i) {
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  const std::vector<double> found = distance.to(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh.triangles) {
      best = std::min(best, distanceToTriangle(points[i], mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
    }
    ASSERT_NEAR(found[i], best, 1e-9);
  }
}

TEST(Distance, OfPointsInALineIsThatOfEachByItself) {
  // A search begins with the triangle found before: along a walk that is a good guess, after a jump a bad one.
  const SurfaceMesh mesh = sphere(40, 24, 37);
  const MeshDistance distance(mesh);
  std::vector<Vec3> points;
  for (int i = 0; i < 9000; ++i) {
    const double angle = 0.001 * i;
    points.emplace_back((i % 100 == 0 ? -60 : 38) * Vec3(std::cos(angle), std::sin(angle), 0.1 * angle));
  }
  const std::vector<double> found = distance.to(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(found[i], distance.to(points[i]), 1e-12) << i;
  }
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(distance.to(points), found) << threads;
  }
}

TEST(Distance, OfManyEqualTrianglesEndsAndIsExact) {
  SurfaceMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles.assign(5000, Triangle{0, 1, 2});
  EXPECT_DOUBLE_EQ(MeshDistance(mesh).to(Vec3(0.25, 0.25, 7)), 7);
}

TEST(Distance, ToAnEmptyMeshIsRefused) { EXPECT_THROW(MeshDistance(SurfaceMesh{}), std::invalid_argument); }

TEST(ErrorSummary, UsesTheNearestRank) {
  std::vector<double> distances;
  for (int i = 100; i >= 1; --i) {
    distances.push_back(i);
  }
  const ErrorSummary summary = summarise(distances);
  EXPECT_DOUBLE_EQ(summary.mean, 50.5);
  EXPECT_DOUBLE_EQ(summary.median, 50);
  EXPECT_DOUBLE_EQ(summary.p95, 95);
  EXPECT_DOUBLE_EQ(summary.max, 100);
}

TEST(ErrorSummary, OfNothingIsZero) { EXPECT_EQ(summarise({}).max, 0); }

TEST(Curvature, AsShippedCountsEachCopyOfAVertexWithItsOwnFan) {
  // A unit square: every corner has a right angle; two of them belong to both triangles, two to one.
  const SurfaceMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const double deficit = 3 * 1.5 * std::numbers::pi;
  EXPECT_NEAR(gaussianCurvatureAsShipped(square).untrimmedPerMm2, (2 * deficit / 1.0 + 2 * deficit / 0.5) / 4, 1e-12);
  EXPECT_EQ(meanGaussianCurvature(square).untrimmedPerMm2, 0);  // nothing but open edges
  const SurfaceMesh whole = sphere(20, 12, 24);
  EXPECT_DOUBLE_EQ(gaussianCurvatureAsShipped(whole).untrimmedPerMm2, meanGaussianCurvature(whole).untrimmedPerMm2);
}

TEST(Curvature, OfASphereIsOneOverItsRadiusSquared) {
  const double expected = 1.0 / (20.0 * 20.0);
  EXPECT_NEAR(meanGaussianCurvature(sphere(20, 60, 120)).trimmedPerMm2, expected, 0.02 * expected);
}

TEST(Curvature, IsThatOfTheMergedMeshWhereVerticesAreSplit) {
  const SurfaceMesh whole = sphere(20, 20, 40);
  SurfaceMesh split;
  for (const Triangle& t : whole.triangles) {
    const auto first = static_cast<std::uint32_t>(split.vertices.size());
    for (const std::uint32_t vertex : t) {
      split.vertices.push_back(whole.vertices[vertex]);
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(mergedVertices(split).vertices.size(), whole.vertices.size());
  EXPECT_NEAR(meanGaussianCurvature(split).untrimmedPerMm2, meanGaussianCurvature(whole).untrimmedPerMm2, 1e-12);
}

TEST(Curvature, OfAFlatSheetIsZeroAlthoughItsBorderIsOpen) {
  SurfaceMesh sheet;
  for (std::uint32_t j = 0; j < 10; ++j) {
    for (std::uint32_t i = 0; i < 10; ++i) {
      sheet.vertices.emplace_back(i, j, 0);
    }
  }
  for (std::uint32_t j = 0; j < 9; ++j) {
    for (std::uint32_t i = 0; i < 9; ++i) {
      const std::uint32_t at = 10 * j + i;
      sheet.triangles.push_back({at, at + 1, at + 11});
      sheet.triangles.push_back({at, at + 11, at + 10});
    }
  }
  EXPECT_NEAR(meanGaussianCurvature(sheet).untrimmedPerMm2, 0, 1e-12);
}

}  // namespace
}  // namespace glisson
