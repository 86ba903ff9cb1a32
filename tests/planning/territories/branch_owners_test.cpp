#include "planning/territories/branch_owners.h"

#include <gtest/gtest.h>

#include "fork.h"

namespace glisson {
namespace {
using namespace test;

VesselGraph forkGraph() {
  const Case& source = forkCase();
  return vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, source.liver->geometry, source.liver->liver);
}

TEST(BranchOwners, EveryVoxelNextToABranchBelongsToTheTerritoryOfTheBranch) {
  const VesselGraph graph = forkGraph();
  const TerritoryChoice choice = proposeLeftRight(graph);
  const Territories made = territoriesOf(*forkCase().liver, graph, choice);
  const std::vector<std::int32_t> owners = ownersOfBranches(graph, choice);
  std::size_t looked = 0;
  for (const VesselSite& site : graph.sites) {
    const std::int32_t owner = owners.at(static_cast<std::size_t>(site.branch));
    if (!site.inLiver || owner == kOwnsNothing) {
      continue;
    }
    const auto& runs = made.parts.at(static_cast<std::size_t>(owner)).rows.runs;
    EXPECT_TRUE(std::ranges::any_of(runs, [&](const RowRun& run) {
      return run.k == site.voxel[2] && run.j == site.voxel[1] && run.i <= site.voxel[0] && site.voxel[0] < run.i + run.n;
    })) << owner;
    ++looked;
  }
  EXPECT_GT(looked, 80U);
}

TEST(BranchOwners, TheTrunkOwnsNothingAndLeftLiesOnThePatientsLeft) {
  const VesselGraph graph = forkGraph();
  const std::vector<std::int32_t> owners = ownersOfBranches(graph, proposeLeftRight(graph));
  for (std::size_t n = 0; n < owners.size(); ++n) {
    const VesselBranch& branch = graph.branches[n];
    if (branch.role != BranchRole::Supplying) {
      EXPECT_EQ(owners[n], kOwnsNothing) << n;
    } else {
      EXPECT_EQ(owners[n], branch.lineMm.back().x() > kForkBorder ? 0 : 1) << n;
    }
  }
}

TEST(BranchOwners, WhatIsNotPickedCompetesWithPicksAndIsNoPartOfAProposal) {
  const VesselGraph graph = forkGraph();
  TerritoryChoice choice = proposeLeftRight(graph);
  choice.picks.pop_back();
  const auto has = [&](std::int32_t owner) { return std::ranges::count(ownersOfBranches(graph, choice), owner) > 0; };
  EXPECT_FALSE(has(1));
  choice.source = TerritorySource::Picked;
  EXPECT_TRUE(has(1));
  EXPECT_TRUE(has(0));
}

}  // namespace
}  // namespace glisson
