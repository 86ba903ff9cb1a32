#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/inscribed_balls.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;

/// A ball of liver about the origin, radius 35 mm, with a vessel.
std::vector<VesselCrossing> crossings(const Inside& vessel, const HalfSpace& plane) {
  const ImageGeometry g = gridOf({160, 160, 100}, Vec3(0.5, 0.5, 0.8), Vec3(-39.75, -39.75, -39.6));
  const Case liver = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3::Zero(), 35)},
                                                         {"portal vein", StructureKind::PortalVein, vessel}}));
  return PlanAssessor(liver).assess(planOf({{plane}})).vesselsCrossed;
}

TEST(Vessels, CrossedAtRightAnglesHaveTheirDiameterAndPlace) {
  const auto found = crossings(tube(Vec3(4, 5, 0), Vec3::UnitZ(), 4), {Vec3(0, 0, 3), Vec3::UnitZ()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "portal vein");
  EXPECT_NEAR(found[0].diameterMm, 8, 0.2);
  EXPECT_NEAR((found[0].positionMm - Vec3(4, 5, 3)).norm(), 0, 0.1);
}

TEST(Vessels, CrossedObliquelyAreCorrectedForIt) {
  for (const double degrees : {30.0, 45.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 normal(std::sin(angle), 0, std::cos(angle));
    const auto found = crossings(tube(Vec3::Zero(), Vec3::UnitZ(), 3), {Vec3::Zero(), normal});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].diameterMm, 6, 0.3) << degrees;  // uncorrected: 6.4, 7.1, 8.5
  }
}

TEST(Vessels, NeighboursAreTwoCrossingsLargestFirst) {
  const auto both = [](const Vec3& p) {
    return tube(Vec3(-6, 0, 0), Vec3::UnitZ(), 3)(p) || tube(Vec3(4, 0, 0), Vec3::UnitZ(), 4)(p);
  };
  const auto found = crossings(both, {Vec3::Zero(), Vec3(0.1, 0.2, 1).normalized()});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].diameterMm, 8, 0.3);
  EXPECT_NEAR(found[1].diameterMm, 6, 0.3);
}

TEST(Vessels, OutsideTheLiverOrThePlaneAreNotCrossed) {
  EXPECT_TRUE(crossings(ball(Vec3(0, 0, 10), 3), {Vec3::Zero(), Vec3::UnitZ()}).empty());
  EXPECT_TRUE(crossings(tube(Vec3(38, 0, 0), Vec3::UnitZ(), 1.5), {Vec3::Zero(), Vec3::UnitZ()}).empty());
}

TEST(Vessels, RunningAlongTheCutAreAsWideAsTheyAreAndSaySo) {
  for (const double degrees : {80.0, 89.0, 90.0}) {
    for (const double off : {0.0, 2.4, 2.9}) {  // through the middle, near the wall, and touching it
      const double angle = degrees * std::numbers::pi / 180;
      const auto found =
          crossings(tube(Vec3::Zero(), Vec3::UnitZ(), 3), {Vec3(off, 0, 0), Vec3(std::sin(angle), 0, std::cos(angle))});
      ASSERT_EQ(found.size(), 1U) << degrees;
      EXPECT_GE(found[0].diameterMm, 5.4) << degrees << " degrees, " << off << " mm off";
      EXPECT_LE(found[0].diameterMm, 6.6) << degrees << " degrees, " << off << " mm off";
      EXPECT_TRUE(found[0].runsAlong) << degrees;
    }
  }
  EXPECT_FALSE(crossings(tube(Vec3::Zero(), Vec3::UnitZ(), 3), {Vec3::Zero(), Vec3(1, 0, 1).normalized()}).at(0).runsAlong);
}

TEST(Vessels, NarrowOnesBesideWideOnesKeepTheirOwnDiameter) {
  const auto both = [](const Vec3& p) {
    return tube(Vec3::Zero(), Vec3::UnitZ(), 5)(p) || (p[0] > 0 && tube(Vec3::Zero(), Vec3::UnitX(), 1.5)(p));
  };
  const auto found = crossings(both, {Vec3(12, 0, 0), Vec3::UnitX()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].diameterMm, 3, 0.3);
}

TEST(InscribedBalls, AreAsWideAsATubeEverywhereInIt) {
  const Vec3 spacing(0.5, 0.5, 0.8);
  const ImageGeometry g = gridOf({40, 40, 30}, spacing, Vec3(-10, -10, -12));
  const auto mask = voxelised(g, tube(Vec3::Zero(), Vec3::UnitZ(), 4));
  const InscribedBalls balls(*mask, spacing);
  EXPECT_NEAR(balls.radiusAt({20, 20, 15}), 4, 0.3);
  EXPECT_LT(balls.radiusAt({27, 20, 15}), 1);
  EXPECT_NEAR(balls.widestAround({27, 20, 15}), 4, 0.3) << "a voxel of the wall";
  EXPECT_NEAR(balls.calibreAround({27, 20, 15}), 8, 0.3);
  EXPECT_EQ(balls.widestAround({0, 0, 15}), 0) << "outside";
}

}  // namespace
}  // namespace glisson
