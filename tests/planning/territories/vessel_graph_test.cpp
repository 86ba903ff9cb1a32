#include "planning/territories/vessel_graph.h"

#include <gtest/gtest.h>

#include <random>

#include "fork.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {
using namespace test;

Vec3 placeOf(const VesselGraph& graph, std::int32_t node) {
  return graph.sites[static_cast<std::size_t>(graph.nodes[static_cast<std::size_t>(node)].site)].positionMm;
}

/// A graph is a forest in order: parents before children, branches of consecutive sites, nodes at their ends.
void expectSound(const VesselGraph& graph) {
  for (std::size_t s = 0; s < graph.sites.size(); ++s) {
    ASSERT_LT(graph.sites[s].parent, static_cast<std::int32_t>(s));
    ASSERT_GT(graph.sites[s].radiusMm, 0);
  }
  std::int32_t next = 0;
  for (std::size_t b = 0; b < graph.branches.size(); ++b) {
    const VesselBranch& branch = graph.branches[b];
    ASSERT_LT(branch.parent, static_cast<std::int32_t>(b));
    ASSERT_EQ(branch.firstSite, next);
    ASSERT_GT(branch.siteCount, 0);
    next += branch.siteCount;
    ASSERT_EQ(graph.nodes[static_cast<std::size_t>(branch.toNode)].site, next - 1);
    ASSERT_LE(branch.minRadiusMm, branch.meanRadiusMm + 1e-9);
    if (branch.parent >= 0) {
      ASSERT_EQ(branch.fromNode, graph.branches[static_cast<std::size_t>(branch.parent)].toNode);
    }
  }
  ASSERT_EQ(static_cast<std::size_t>(next), graph.sites.size());
}

TEST(VesselGraphs, ForkHasATrunkTwoArmsAndItsKnownJunction) {
  const VesselGraph graph = portalOf(forkCase());
  expectSound(graph);
  EXPECT_EQ(graph.pieces, 1);
  ASSERT_EQ(graph.branches.size(), 3U);
  EXPECT_EQ(graph.branches[0].role, BranchRole::Trunk);
  EXPECT_EQ(graph.nodes[static_cast<std::size_t>(graph.branches[0].fromNode)].kind, NodeKind::Root);
  EXPECT_LT(placeOf(graph, graph.branches[0].fromNode).z(), -65);
  ASSERT_TRUE(graph.mainBifurcation);
  EXPECT_LT((placeOf(graph, *graph.mainBifurcation) - Vec3(5, -10, -36)).norm(), 5);
  for (const int arm : {1, 2}) {
    const VesselBranch& branch = graph.branches[static_cast<std::size_t>(arm)];
    EXPECT_EQ(branch.role, BranchRole::Supplying);
    EXPECT_NEAR(branch.lengthMm, 15 + 75, 6);  // the corner is cut
    EXPECT_NEAR(branch.inLiverMm, 59, 3);
    EXPECT_NEAR(branch.meanRadiusMm, 2.6, 0.6);  // the middle lies between voxels
  }
}

TEST(VesselGraphs, StraightTubeInAnyDirectionHasItsLengthAndRadius) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 12; ++n) {
    const Vec3 way = n < 3 ? Vec3(Vec3::Unit(n)) : Vec3(normal(random), normal(random), normal(random)).normalized();
    const ImageGeometry g = gridOf({160, 160, 60}, Vec3(0.6, 0.6, 1.6), Vec3(-47.7, -47.7, -47.2));
    const auto tube = voxelised(g, rod(-30 * way, 30 * way, 4));
    const VesselGraph graph = vesselGraphOf(VesselSystem::Portal, *tube, g, *tube);
    expectSound(graph);
    ASSERT_EQ(graph.branches.size(), 1U) << way.transpose();
    EXPECT_NEAR(graph.branches[0].lengthMm, 68, 5) << way.transpose();  // round ends count
    EXPECT_NEAR(graph.branches[0].meanRadiusMm, 3.1, 0.9) << way.transpose();
  }
}

TEST(VesselGraphs, AreTheSameInTurnedAndMirroredGrids) {
  const Case straight = forkCase(Vec3(1, 1, 2));
  const VesselGraph a = portalOf(straight);
  ImageGeometry turned = straight.liver->geometry;
  turned.direction = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  turned.origin = Vec3(300, -200, 100);
  const VesselGraph b =
      vesselGraphOf(VesselSystem::Portal, *straight.segmentation->structures[1].mask, turned, straight.liver->liver);
  ASSERT_EQ(a.sites.size(), b.sites.size());
  ASSERT_EQ(a.branches.size(), b.branches.size());
  for (std::size_t n = 0; n < a.branches.size(); ++n) {
    EXPECT_EQ(a.branches[n].role, b.branches[n].role);
    EXPECT_EQ(a.branches[n].parent, b.branches[n].parent);
    EXPECT_NEAR(a.branches[n].lengthMm, b.branches[n].lengthMm, 1e-9);
    const Vec3 there = turned.toWorld(straight.liver->geometry.toIndex(a.branches[n].lineMm.back()));
    EXPECT_LT((there - b.branches[n].lineMm.back()).norm(), 1e-9);
  }
}

TEST(VesselGraphs, RoughWallsGrowNoBranches) {
  const ImageGeometry g = gridOf({60, 30, 30}, Vec3(1, 1, 1));
  std::mt19937 random(3);
  const auto rough = voxelised(g, [&](const Vec3& p) {
    const double r = Vec3(p.x() - std::clamp(p.x(), 8.0, 50.0), p.y() - 15, p.z() - 15).norm();
    return r <= 4 || (r <= 5 && random() % 3 == 0);
  });
  const VesselGraph graph = vesselGraphOf(VesselSystem::Portal, *rough, g, *rough);
  expectSound(graph);
  std::int32_t longest = 0;
  for (const VesselBranch& branch : graph.branches) {
    longest = std::max(longest, branch.siteCount);
  }
  EXPECT_LE(graph.branches.size(), 3U);
  EXPECT_GT(longest, 25);
}

TEST(VesselGraphs, EmptyMaskAndSingleVoxelAreNoFailure) {
  const ImageGeometry g = gridOf({9, 9, 9}, Vec3(0.5, 0.5, 3));
  const auto liver = voxelised(g, [](const Vec3&) { return true; });
  const VesselGraph none = vesselGraphOf(VesselSystem::Portal, Mask(), g, *liver);
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.mainBifurcation);
  const auto single = voxelised(g, ball(g.toWorld(Vec3(4, 4, 4)), 0.1));
  const VesselGraph one = vesselGraphOf(VesselSystem::Portal, *single, g, *liver);
  expectSound(one);
  ASSERT_EQ(one.branches.size(), 1U);
  EXPECT_EQ(one.branches[0].siteCount, 1);
  EXPECT_EQ(one.branches[0].lengthMm, 0);
  const auto solid = voxelised(g, [](const Vec3&) { return true; });
  expectSound(vesselGraphOf(VesselSystem::Hepatic, *solid, g, Mask()));
}

TEST(VesselGraphs, RingIsOpened) {
  const ImageGeometry g = gridOf({60, 60, 12}, Vec3(1, 1, 1));
  const auto ring = voxelised(g, [](const Vec3& p) {
    const double flat = std::hypot(p.x() - 30, p.y() - 30) - 20;
    return flat * flat + (p.z() - 6) * (p.z() - 6) <= 9;
  });
  const VesselGraph graph = vesselGraphOf(VesselSystem::Portal, *ring, g, *ring);
  expectSound(graph);
  double whole = 0;
  for (const VesselBranch& branch : graph.branches) {
    whole += branch.lengthMm;
  }
  EXPECT_NEAR(whole, 2 * 3.14159 * 20, 15);
}

TEST(VesselGraphs, NoiseGivesASoundForest) {
  const ImageGeometry g = gridOf({40, 40, 20}, Vec3(0.7, 0.7, 2));
  for (const unsigned share : {2U, 5U, 20U}) {
    std::mt19937 random(share);
    const auto noise = voxelised(g, [&](const Vec3&) { return random() % share == 0; });
    expectSound(vesselGraphOf(VesselSystem::Hepatic, *noise, g, *noise));
  }
}

TEST(VesselGraphs, SmallPieceNearABranchContinuesItAndAFarOneOwnsNothing) {
  const ImageGeometry g = gridOf({120, 40, 160}, Vec3(1, 1, 1), Vec3(-60, -20, -80));
  const auto liver = voxelised(g, box(Vec3(-50, -20, -20), Vec3(50, 20, 78)));
  const auto withGap =
      voxelised(g, anyOf({rod({0, 0, -70}, {0, 0, 45}, 3), rod({0, 0, 54}, {0, 0, 61}, 2), rod({40, 0, 60}, {45, 0, 60}, 1)}));
  const VesselGraph graph = vesselGraphOf(VesselSystem::Portal, *withGap, g, *liver);
  expectSound(graph);
  EXPECT_EQ(graph.pieces, 2);
  ASSERT_EQ(graph.notes.size(), 2U);
  EXPECT_NE(graph.notes[0].find("continuations"), std::string::npos);
  EXPECT_NE(graph.notes[1].find("own nothing"), std::string::npos);
  for (const VesselBranch& branch : graph.branches) {
    EXPECT_EQ(branch.role == BranchRole::Outside, branch.piece == 1);
  }
}

TEST(VesselGraphs, AreTheSameForAnyNumberOfThreadsAndCanBeCancelled) {
  const Case source = forkCase(Vec3(1, 1, 1.5));
  std::vector<VesselGraph> made;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    made.push_back(portalOf(source));
  }
  for (const VesselGraph& graph : made) {
    ASSERT_EQ(graph.sites.size(), made[0].sites.size());
    for (std::size_t s = 0; s < graph.sites.size(); ++s) {
      EXPECT_EQ(graph.sites[s].voxel, made[0].sites[s].voxel);
      EXPECT_EQ(graph.sites[s].radiusMm, made[0].sites[s].radiusMm);
    }
  }
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, source.liver->geometry,
                             source.liver->liver, nullptr, context),
               Cancelled);
}

TEST(VesselGraphs, MaskOfAnotherGridIsRefused) {
  const Case& source = forkCase();
  ImageGeometry smaller = source.liver->geometry;
  smaller.size[2] /= 2;
  EXPECT_THROW(vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, smaller, source.liver->liver),
               PlanningError);
}

}  // namespace
}  // namespace glisson
