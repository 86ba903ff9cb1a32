#include "reconstruction/mesh/cut.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mcsd/mcsd.h"
#include "tests/reconstruction/mesh/solids.h"
#include "tests/support/real_data.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

using test::box;
using test::reversed;
using test::sphere;
using test::together;

/// What holds for every cut: volume conserved, halves sound, on their own sides, the section's area the same from both.
void expectSoundCut(const SurfaceMesh& mesh, const HalfSpace& plane, const CutResult& halves) {
  const double volume = signedVolumeMm3(mesh);
  const double above = signedVolumeMm3(halves.positive);
  const double below = signedVolumeMm3(halves.negative);
  ASSERT_LE(std::abs(above + below - volume), 1e-9 * volume);
  for (const auto* half : {&halves.positive, &halves.negative}) {
    if (!half->empty()) {
      ASSERT_EQ(half->defects().names(), std::vector<std::string>{});
    }
  }
  for (const Vec3& v : halves.positive.vertices) {
    ASSERT_GE(plane.normal.dot(v - plane.origin), -4e-6);
  }
  for (const Vec3& v : halves.negative.vertices) {
    ASSERT_LE(plane.normal.dot(v - plane.origin), 4e-6);
  }
  for (const Triangle& t : halves.section.triangles) {
    const auto& v = halves.section.vertices;
    ASSERT_GT((v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).dot(plane.normal), 0.0);
  }
  // Each half has the section once, and together they have the whole surface.
  ASSERT_LE(std::abs(areaMm2(halves.positive) + areaMm2(halves.negative) - areaMm2(mesh) - 2.0 * areaMm2(halves.section)),
            1e-6 * areaMm2(mesh));
}

Vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// A lumpy body on a grid, with noise on its border: pinches, tunnels, islands.
SurfaceMesh blob(std::mt19937& random, int smoothing, double noise) {
  const Index3 size{18, 18, 18};
  std::vector<std::uint8_t> values(18 * 18 * 18, 0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<std::pair<Vec3, double>> balls;
  for (int n = 0; n < 4; ++n) {
    balls.emplace_back(Vec3(4 + 10 * share(random), 4 + 10 * share(random), 4 + 10 * share(random)), 2.0 + 3.0 * share(random));
  }
  std::size_t n = 0;
  for (int k = 0; k < 18; ++k) {
    for (int j = 0; j < 18; ++j) {
      for (int i = 0; i < 18; ++i, ++n) {
        for (const auto& [centre, radius] : balls) {
          if ((Vec3(i, j, k) - centre).norm() + noise * (share(random) - 0.5) < radius) {
            values[n] = 1;
          }
        }
      }
    }
  }
  ImageGeometry geometry;
  geometry.size = size;
  geometry.spacing = Vec3(0.5, 0.75, 2.5);
  geometry.origin = Vec3(-100, 50.5, -700.25);
  McsdParameters parameters;
  parameters.smoothing = smoothing;
  parameters.decimation = 0.0;
  return reconstructMcsd(Mask::fromGrid(size, values), geometry, parameters).mesh;
}

TEST(Cut, ABoxIsHalvedWithASectionOfKnownArea) {
  const SurfaceMesh mesh = box({0, 0, 0}, {10, 20, 30}, 4);
  const HalfSpace plane{{0, 0, 12}, Vec3::UnitZ()};
  const CutResult halves = cut(mesh, plane);
  expectSoundCut(mesh, plane, halves);
  EXPECT_NEAR(signedVolumeMm3(halves.positive), 3600.0, 1e-9);
  EXPECT_NEAR(signedVolumeMm3(halves.negative), 2400.0, 1e-9);
  EXPECT_NEAR(areaMm2(halves.section), 200.0, 1e-9);
}

TEST(Cut, ASphereCutOffItsCentreLeavesTheCapOfTheFormula) {
  const SurfaceMesh mesh = sphere({5, 6, 7}, 10.0, 6);
  const Vec3 normal = Vec3(1, 2, -2).normalized();
  const HalfSpace plane{Vec3(5, 6, 7) + 4.0 * normal, normal};
  const CutResult halves = cut(mesh, plane);
  expectSoundCut(mesh, plane, halves);
  const double height = 6.0;
  EXPECT_NEAR(signedVolumeMm3(halves.positive) / (std::numbers::pi * height * height * (30.0 - height) / 3.0), 1.0, 2e-3);
  EXPECT_NEAR(areaMm2(halves.section) / (std::numbers::pi * 84.0), 1.0, 2e-3);
}

TEST(Cut, APlaneBesideTheBodyLeavesItWhole) {
  const SurfaceMesh mesh = sphere(Vec3::Zero(), 1.0, 2);
  const CutResult below = cut(mesh, {{0, 0, 2}, Vec3::UnitZ()});
  EXPECT_TRUE(below.positive.empty());
  EXPECT_TRUE(below.section.empty());
  EXPECT_EQ(below.negative.triangles, mesh.triangles);
  const CutResult above = cut(mesh, {{0, 0, -2}, Vec3::UnitZ()});
  EXPECT_TRUE(above.negative.empty());
  EXPECT_EQ(above.positive.triangles, mesh.triangles);
}

TEST(Cut, APlaneThroughAFaceLeavesTheBodyWhole) {
  const SurfaceMesh mesh = box({0, 0, 0}, {1, 1, 1}, 3);
  for (const double z : {0.0, 1.0}) {
    const CutResult halves = cut(mesh, {{0, 0, z}, Vec3::UnitZ()});
    EXPECT_EQ(halves.positive.empty(), z == 1.0);
    EXPECT_EQ(halves.negative.empty(), z == 0.0);
    EXPECT_TRUE(halves.section.empty());
  }
}

TEST(Cut, PlanesThroughEdgesAndVerticesOfTheGridCutCleanly) {
  const SurfaceMesh mesh = box({0, 0, 0}, {8, 8, 8}, 8);
  for (int n = 1; n < 8; ++n) {
    for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(1, 1, 0).normalized(), Vec3(1, -1, 0).normalized(), Vec3(1, 1, 1).normalized(),
                               Vec3(2, -1, 0).normalized()}) {
      const HalfSpace plane{Vec3(n, 4, 4), normal};
      expectSoundCut(mesh, plane, cut(mesh, plane));
    }
  }
}

TEST(Cut, ASectionMayHaveHolesAndIslandsInHoles) {
  const SurfaceMesh shells = together(together(sphere(Vec3::Zero(), 10, 4), reversed(sphere(Vec3::Zero(), 8, 4))),
                                      together(sphere(Vec3::Zero(), 6, 4), reversed(sphere(Vec3::Zero(), 4, 4))));
  for (const double height : {0.0, 1.0, 5.0, 7.0, 9.0}) {
    const HalfSpace plane{{0, 0, height}, Vec3::UnitZ()};
    const CutResult halves = cut(shells, plane);
    expectSoundCut(shells, plane, halves);
    double area = 0;
    for (const auto& [radius, sign] : {std::pair{10.0, 1.0}, {8.0, -1.0}, {6.0, 1.0}, {4.0, -1.0}}) {
      area += sign * std::numbers::pi * std::max(0.0, radius * radius - height * height);
    }
    EXPECT_NEAR(areaMm2(halves.section), area, 0.02 * area);
  }
}

TEST(Cut, AValleyThatTouchesThePlaneInAnEdgeStaysManifold) {
  // A box with a roof-shaped groove whose bottom edge runs in the plane z = 1 between two points of its rim.
  SurfaceMesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}, {0, 2, 1}, {4, 2, 1}},
                   {{0, 3, 2},
                    {0, 2, 1},
                    {0, 1, 5},
                    {0, 5, 4},
                    {3, 7, 6},
                    {3, 6, 2},
                    {4, 5, 9},
                    {4, 9, 8},
                    {8, 9, 6},
                    {8, 6, 7},
                    {0, 4, 8},
                    {0, 8, 3},
                    {3, 8, 7},
                    {1, 2, 9},
                    {1, 9, 5},
                    {2, 6, 9}}};
  ASSERT_EQ(mesh.defects().names(), std::vector<std::string>{});
  const HalfSpace plane{{0, 0, 1}, Vec3::UnitZ()};
  const CutResult halves = cut(mesh, plane);
  expectSoundCut(mesh, plane, halves);
  EXPECT_NEAR(areaMm2(halves.section), 16.0, 1e-12);
}

// 2,000 random and 1,000 degenerate planes; 100,000 and 20,000 in the long runs.
TEST(Cut, RandomPlanesConserveVolumeToOneInABillion) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const int wanted = test::trials(test::longRuns() ? 100000 : 2000);
  for (int body = 0, planes = 0; planes < wanted; ++body) {
    const SurfaceMesh mesh = blob(random, body % 2 == 0 ? 0 : 10, body % 4 < 2 ? 0.0 : 1.5);
    if (mesh.defects().any()) {
      continue;
    }
    const Bounds bounds = boundsOf(mesh);
    planes += 50;
    for (int n = 0; n < 50; ++n) {
      const Vec3 through = bounds.low + (bounds.high - bounds.low).cwiseProduct(Vec3(share(random), share(random), share(random)));
      const HalfSpace plane{through, randomDirection(random)};
      SCOPED_TRACE(std::to_string(body) + " " + std::to_string(n));
      expectSoundCut(mesh, plane, cut(mesh, plane));
    }
  }
}

TEST(Cut, DegeneratePlanesConserveVolumeToOneInABillion) {
  std::mt19937 random(2);
  const int wanted = test::trials(test::longRuns() ? 20000 : 1000);
  for (int body = 0, planes = 0; planes < wanted; ++body) {
    const SurfaceMesh mesh = blob(random, body % 5 == 0 ? 10 : 0, body % 2 == 0 ? 0.0 : 2.0);
    if (mesh.defects().any()) {
      continue;
    }
    planes += 25;
    for (int n = 0; n < 25; ++n) {
      const Triangle& t = mesh.triangles[random() % mesh.triangles.size()];
      const Vec3& a = mesh.vertices[t[0]];
      const Vec3& b = mesh.vertices[t[1]];
      const Vec3& c = mesh.vertices[t[2]];
      HalfSpace plane{a, Vec3::Unit(n % 3)};  // along the grid, through a vertex
      if (n % 5 == 3) {
        plane.normal = (b - a).cross(c - a).normalized();  // in a face
      } else if (n % 5 == 4) {
        plane.normal = (b - a).cross(randomDirection(random)).normalized();  // along an edge
      }
      if (n % 2 == 1) {
        plane.normal = -plane.normal;
      }
      SCOPED_TRACE(std::to_string(body) + " " + std::to_string(n));
      expectSoundCut(mesh, plane, cut(mesh, plane));
    }
  }
}

TEST(Cut, AHalfCanBeCutAgainByAPlaneThroughTheSameEdges) {
  std::mt19937 random(3);
  const SurfaceMesh mesh = blob(random, 0, 1.0);
  const HalfSpace first{mesh.vertices.front(), Vec3::UnitX()};
  const CutResult halves = cut(mesh, first);
  for (const auto* half : {&halves.positive, &halves.negative}) {
    if (half->empty()) {
      continue;
    }
    const Bounds bounds = boundsOf(*half);
    const HalfSpace second{0.5 * (bounds.low + bounds.high), Vec3(1, 1, 0.2).normalized()};
    expectSoundCut(*half, second, cut(*half, second));
    expectSoundCut(*half, first, cut(*half, first));  // along the cap it has
  }
}

TEST(Cut, AMeshWithDefectsOrAPlaneWithoutDirectionIsRefused) {
  SurfaceMesh mesh = sphere(Vec3::Zero(), 1.0, 2);
  EXPECT_THROW(cut(mesh, {Vec3::Zero(), Vec3::Zero()}), ReconstructionError);
  mesh.triangles.pop_back();
  EXPECT_THROW(cut(mesh, {}), CheckFailed);
}

TEST(Cut, ACancelledCutEnds) {
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(cut(sphere(Vec3::Zero(), 1.0, 2), {}, context), Cancelled);
}

}  // namespace
}  // namespace glisson
