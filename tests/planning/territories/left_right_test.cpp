#include <gtest/gtest.h>

#include "fork.h"
#include "planning/territories/territories.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {
using namespace test;

double endX(const VesselGraph& graph, std::int32_t branch) {
  return graph.branches[static_cast<std::size_t>(branch)].lineMm.back().x();
}

/// A portal vein of parallel arms in the fork's liver, each from a junction on the trunk at x = 0 below it.
struct Arm {
  double x;
  double leavesAt;  ///< z
};
VesselGraph portalWith(const std::vector<Arm>& arms) {
  std::vector<Inside> parts{rod({0, 0, -100}, {0, 0, -36}, 4)};
  for (const Arm& arm : arms) {
    parts.push_back(rod({0, 0, arm.leavesAt}, {arm.x, 0, arm.leavesAt}, 2.5));
    parts.push_back(rod({arm.x, 0, arm.leavesAt}, {arm.x, 0, 34}, 2.5));
  }
  const ImageGeometry g = gridOf({100, 44, 150}, Vec3(1, 1, 1), Vec3(-49.5, -21.5, -106.5));
  return vesselGraphOf(VesselSystem::Portal, *voxelised(g, anyOf(parts)), g, *voxelised(g, box(kForkLow, kForkHigh)));
}

TEST(LeftAndRight, AreProposedByThePatientsSidesAndNotConfirmed) {
  const VesselGraph graph = portalOf(forkCase());
  const TerritoryChoice choice = proposeLeftRight(graph);
  EXPECT_FALSE(choice.confirmed);
  EXPECT_EQ(choice.source, TerritorySource::Proposal);
  ASSERT_EQ(choice.picks.size(), 2U);
  EXPECT_EQ(choice.picks[0].name, "left");
  EXPECT_EQ(choice.picks[1].name, "right");
  EXPECT_NEAR(endX(graph, choice.picks[0].branches.at(0)), 20, 1.5);  // LPS: x to the patient's left
  EXPECT_NEAR(endX(graph, choice.picks[1].branches.at(0)), -10, 1.5);
}

TEST(LeftAndRight, ChangeSidesInAMirroredPatient) {
  const Case& source = forkCase();
  ImageGeometry mirrored = source.liver->geometry;
  mirrored.direction.col(0) = -mirrored.direction.col(0);
  mirrored.origin[0] = -mirrored.origin[0];
  const VesselGraph graph =
      vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, mirrored, source.liver->liver);
  const TerritoryChoice choice = proposeLeftRight(graph);
  EXPECT_NEAR(endX(graph, choice.picks.at(0).branches.at(0)), 10, 1.5);
  EXPECT_NEAR(endX(graph, choice.picks.at(1).branches.at(0)), -20, 1.5);
}

TEST(LeftAndRight, RightPosteriorBranchThatLeavesFirstStaysRight) {
  const VesselGraph graph = portalWith({{-30, -70}, {-12, -37}, {30, -37}});
  const TerritoryChoice choice = proposeLeftRight(graph);
  ASSERT_EQ(choice.picks.size(), 2U);
  ASSERT_EQ(choice.picks[0].branches.size(), 1U);
  EXPECT_NEAR(endX(graph, choice.picks[0].branches[0]), 30, 1.5);
  ASSERT_EQ(choice.picks[1].branches.size(), 2U);
  EXPECT_NEAR(endX(graph, choice.picks[1].branches[0]) + endX(graph, choice.picks[1].branches[1]), -42, 3);
}

TEST(LeftAndRight, TrifurcationHasOneLeftAndTwoRightBranches) {
  const VesselGraph graph = portalWith({{-30, -36}, {-12, -36}, {30, -36}});
  const TerritoryChoice choice = proposeLeftRight(graph);
  ASSERT_EQ(choice.picks.size(), 2U);
  EXPECT_NEAR(endX(graph, choice.picks[0].branches.at(0)), 30, 1.5);
  for (const std::int32_t branch : choice.picks[1].branches) {
    EXPECT_LT(graph.branches[static_cast<std::size_t>(branch)].centreMm.x(), 0);
  }
}

TEST(LeftAndRight, AreNotProposedWithoutABifurcation) {
  const VesselGraph graph = portalWith({{10, -36}});
  const TerritoryChoice choice = proposeLeftRight(graph);
  EXPECT_TRUE(choice.picks.empty());
  ASSERT_EQ(choice.notes.size(), 1U);
  EXPECT_NE(choice.notes[0].find("no main bifurcation"), std::string::npos);
}

TEST(LeftAndRight, SideBranchesThatNeverEnterTheLiverOwnNothing) {
  // A splenic vein as wide as the trunk, and longer.
  const ImageGeometry g = gridOf({100, 44, 150}, Vec3(1, 1, 1), Vec3(-49.5, -21.5, -106.5));
  const auto portal =
      voxelised(g, anyOf({forkPortal(), rod({5, -10, -56}, {45, -10, -60}, 4), rod({45, -10, -60}, {45, 15, -90}, 4)}));
  const VesselGraph graph = vesselGraphOf(VesselSystem::Portal, *portal, g, *voxelised(g, box(kForkLow, kForkHigh)));
  const TerritoryChoice choice = proposeLeftRight(graph);
  ASSERT_EQ(choice.picks.size(), 2U);
  EXPECT_NEAR(endX(graph, choice.picks[0].branches.at(0)), 20, 1.5);
  EXPECT_NEAR(endX(graph, choice.picks[1].branches.at(0)), -10, 1.5);
  int supplying = 0;
  for (const VesselBranch& branch : graph.branches) {
    supplying += branch.role == BranchRole::Supplying ? 1 : 0;
    EXPECT_TRUE(branch.role != BranchRole::Supplying || branch.inLiverMm > 50);
  }
  EXPECT_EQ(supplying, 2);
}

}  // namespace
}  // namespace glisson
