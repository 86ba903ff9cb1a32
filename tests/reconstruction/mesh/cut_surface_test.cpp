// Cuts along curved surfaces: closed halves that share the section, volumes that add up, a section that follows the curve.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <set>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/cut.h"
#include "reconstruction/mesh/refine.h"
#include "reconstruction/mesh/self_intersection.h"
#include "tests/reconstruction/mesh/solids.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

using test::box;
using test::sphere;

/// As a file of floats holds it.
SurfaceMesh onFloats(SurfaceMesh mesh) {
  for (Vec3& v : mesh.vertices) {
    v = v.cast<float>().cast<double>();
  }
  return mesh;
}

/// Height a u^2 + b u v + c v^2 over the plane.
CuttingSurface quadric(const HalfSpace& plane, double a, double b, double c) {
  const Vec3 u = plane.normal.unitOrthogonal();
  const Vec3 v = plane.normal.cross(u);
  const auto above = [=](const Vec3& p) {
    const Vec3 from = p - plane.origin;
    const double x = u.dot(from);
    const double y = v.dot(from);
    return plane.normal.dot(from) - (a * x * x + b * x * y + c * y * y);
  };
  return {plane, above, 2 * std::max(std::abs(a), std::abs(c)) + std::abs(b)};
}

std::set<std::array<double, 3>> placesOf(const SurfaceMesh& mesh) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& v : mesh.vertices) {
    places.insert({v[0], v[1], v[2]});
  }
  return places;
}

void expectSound(const SurfaceMesh& mesh, const CuttingSurface& surface, const CutResult& halves) {
  const double spacing = floatSpacingMm(mesh);
  ASSERT_FALSE(halves.positive.empty());
  ASSERT_FALSE(halves.negative.empty());
  for (const SurfaceMesh* half : {&halves.positive, &halves.negative}) {
    ASSERT_EQ(half->defects().names(), std::vector<std::string>{});
    ASSERT_EQ(countSelfIntersections(*half), 0U);
  }
  const double volume = signedVolumeMm3(mesh);
  ASSERT_NEAR(signedVolumeMm3(halves.positive) + signedVolumeMm3(halves.negative), volume, 40 * spacing * areaMm2(mesh));
  for (const Vec3& v : halves.positive.vertices) {
    ASSERT_GE(surface.above(v), -40 * spacing);
  }
  for (const Vec3& v : halves.negative.vertices) {
    ASSERT_LE(surface.above(v), 40 * spacing);
  }
  const auto up = placesOf(halves.positive);
  const auto down = placesOf(halves.negative);
  for (const Triangle& t : halves.section.triangles) {
    const auto& v = halves.section.vertices;
    ASSERT_GT((v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).dot(surface.plane.normal), 0.0);
    for (std::size_t n = 0; n < 3; ++n) {
      ASSERT_TRUE(up.contains({v[t[n]][0], v[t[n]][1], v[t[n]][2]})) << "both halves have the same section";
      ASSERT_TRUE(down.contains({v[t[n]][0], v[t[n]][1], v[t[n]][2]}));
      ASSERT_LE(std::abs(surface.above(0.5 * (v[t[n]] + v[t[(n + 1) % 3]]))), kCurvedCutMm);
    }
    ASSERT_LE(std::abs(surface.above((v[t[0]] + v[t[1]] + v[t[2]]) / 3)), kCurvedCutMm);
  }
}

TEST(CurvedCut, BallsAreClosedHalvesThatFollowTheSurface) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < test::trials(40); ++n) {
    const Vec3 centre(-104.3, 57.9, 1013.7);
    const SurfaceMesh mesh = onFloats(sphere(centre, 40, n % 2 == 0 ? 4 : 3));
    const Vec3 normal = Vec3(unit(random), unit(random), unit(random)).normalized();
    const CuttingSurface surface = quadric({centre + 8 * Vec3(unit(random), unit(random), unit(random)), normal},
                                           0.02 * unit(random), 0.02 * unit(random), 0.02 * unit(random));
    expectSound(mesh, surface, cutForFloats(mesh, surface));
  }
}

TEST(CurvedCut, LargeTrianglesAreSplitSoThatTheirBorderFollowsToo) {
  const SurfaceMesh mesh = box(Vec3(-40, -40, -40), Vec3(80, 80, 80));
  const CuttingSurface surface = quadric({Vec3(0.1, 0.2, 0.3), Vec3::UnitZ()}, 0.01, 0.003, -0.008);
  const CutResult halves = cutForFloats(mesh, surface);
  expectSound(mesh, surface, halves);
  // The mean height over the square; a chord's error is within the allowed deviation.
  const double mean = (0.01 - 0.008) * 80 * 80 / 12;
  EXPECT_NEAR(signedVolumeMm3(halves.positive), 80 * 80 * (40 - 0.3 - mean), 80 * 80 * kCurvedCutMm);
}

TEST(CurvedCut, FlatSurfaceCutsAsThePlane) {
  const SurfaceMesh mesh = onFloats(sphere(Vec3(1, 2, 3), 40, 4));
  const HalfSpace plane{Vec3(4, 5, 6), Vec3(1, 2, 2) / 3};
  const CutResult flat = cutForFloats(mesh, plane);
  const CutResult curved = cutForFloats(mesh, quadric(plane, 0, 0, 0));
  EXPECT_NEAR(signedVolumeMm3(curved.positive), signedVolumeMm3(flat.positive), 1e-5 * signedVolumeMm3(flat.positive));
  EXPECT_NEAR(areaMm2(curved.section), areaMm2(flat.section), 1e-4 * areaMm2(flat.section));
}

TEST(CurvedCut, SurfaceBesideTheMeshLeavesItWhole) {
  const SurfaceMesh mesh = onFloats(sphere(Vec3::Zero(), 40, 3));
  const CutResult halves = cutForFloats(mesh, quadric({Vec3(0, 0, 80), Vec3::UnitZ()}, 0.01, 0, 0.01));
  EXPECT_TRUE(halves.positive.empty());
  EXPECT_NEAR(signedVolumeMm3(halves.negative), signedVolumeMm3(mesh), 1e-9 * signedVolumeMm3(mesh));
}

TEST(CurvedCut, CancelEndsIt) {
  ExecutionContext context;
  context.cancel();
  EXPECT_THROW(cutForFloats(sphere(Vec3::Zero(), 40, 3), quadric({}, 0.01, 0, 0), context), Cancelled);
}

TEST(Refine, SplitsConformingAndKeepsTheBody) {
  const SurfaceMesh mesh = box(Vec3(-40, -20, -30), Vec3(80, 40, 60));
  const SurfaceMesh fine = splitLongEdges(mesh, 7, [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::min({a[0], b[0], c[0]}) <= 10;
  });
  EXPECT_EQ(fine.defects().names(), std::vector<std::string>{});
  EXPECT_NEAR(signedVolumeMm3(fine), 80 * 40 * 60, 1e-6);
  EXPECT_GT(fine.triangles.size(), 500U);
  for (const Triangle& t : fine.triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      const Vec3& a = fine.vertices[t[n]];
      const Vec3& b = fine.vertices[t[(n + 1) % 3]];
      if (std::min(a[0], b[0]) <= 10) {
        EXPECT_LE((a - b).norm(), 7);
      }
    }
  }
}

}  // namespace
}  // namespace glisson
