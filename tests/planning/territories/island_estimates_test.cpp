// Territories and perfusion of plans whose islands are given to the other side.

#include <gtest/gtest.h>

#include "fork.h"
#include "planning/resection/plan_edit.h"
#include "planning/territories/perfusion.h"
#include "planning/territories/territories.h"
#include "planning/volumetry/assessment.h"

namespace glisson {
namespace {
using namespace test;

/// A bar along x (0 to 60 mm) with two legs up z at its ends, of 40 and 30 mm, a tumour in the shorter one. The portal vein comes
/// from below and has a branch in each leg; the hepatic vein leaves the shorter leg through its top.
const Case& perfusedArch() {
  static const Case arch = [] {
    const ImageGeometry g = gridOf({90, 34, 48}, Vec3(0.8, 0.9, 2), Vec3(-5, -5, -35));
    const Inside liver = anyOf({box({0, 0, 0}, {60, 20, 15}), box({0, 0, 0}, {12, 20, 55}), box({48, 0, 0}, {60, 20, 45})});
    const Inside portal = anyOf({rod({30, 6, -30}, {30, 6, 4}, 3), rod({5, 6, 4}, {55, 6, 4}, 2), rod({5, 6, 4}, {5, 6, 50}, 2),
                                 rod({55, 6, 4}, {55, 6, 40}, 2)});
    const Inside vein = anyOf({rod({54, 14, 4}, {54, 14, 58}, 2), rod({20, 14, 4}, {54, 14, 4}, 2)});
    return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, liver},
                                               {"portal vein", StructureKind::PortalVein, portal},
                                               {"hepatic vein", StructureKind::HepaticVein, vein},
                                               {"tumour", StructureKind::Tumour, box({49, 10, 32}, {53, 17, 40})}}));
  }();
  return arch;
}

const HalfSpace kAcrossPerfusedLegs{Vec3(30, 10, 25.3), Vec3::UnitZ()};

/// The plan with its only island given to the other side.
ResectionPlan withIslandGiven(const PlanAssessor& assessor, const HalfSpace& plane) {
  const ResectionPlan plan = planOf({{plane}});
  const PlanAssessment assessed = assessor.assess(plan);
  EXPECT_EQ(assessed.islands.size(), 1U);
  const IslandAssessment& island = assessed.islands.at(0);
  return apply(plan, AssignIsland{{island.point, island.side == PlanSide::Resected ? PlanSide::Remnant : PlanSide::Resected}});
}

TEST(IslandEstimates, PerfusedRemnantIsNoLargerThanTheRemnant) {
  const PlanAssessor assessor(perfusedArch());
  const LiverPerfusion perfusion(perfusedArch());
  for (const HalfSpace& plane : {kAcrossPerfusedLegs, flipped(kAcrossPerfusedLegs)}) {
    const ResectionPlan plan = withIslandGiven(assessor, plane);
    const PlanAssessment assessed = assessor.volumes(plan);
    const PerfusionEstimate effect = perfusion.effectOf(plan);
    ASSERT_TRUE(effect.isKnown());
    EXPECT_NEAR(effect.functionalRemnantMl, assessed.functionalRemnantMl, 1e-6);
    EXPECT_LE(effect.perfusedFlrMl, assessed.functionalRemnantMl + 1e-6);
    EXPECT_LE(effect.devascularisedOrCongestedMl, assessed.remnantMl + 1e-6);
  }
}

TEST(IslandEstimates, VesselsOfAPieceThatIsGivenBackAreNotCut) {
  const PlanAssessor assessor(perfusedArch());
  const LiverPerfusion perfusion(perfusedArch());
  const PerfusionEstimate planes = perfusion.effectOf(planOf({{kAcrossPerfusedLegs}}));
  EXPECT_EQ(planes.portalCuts.size(), 2U);
  EXPECT_GT(planes.congestedMl.value(), 10) << "all veins drain through the shorter leg";
  const PerfusionEstimate given = perfusion.effectOf(withIslandGiven(assessor, kAcrossPerfusedLegs));
  ASSERT_EQ(given.portalCuts.size(), 1U);
  EXPECT_LT(given.portalCuts[0].positionMm.x(), 12);
  EXPECT_TRUE(given.hepaticCuts.empty());
  EXPECT_EQ(given.congestedMl.value(), 0);
}

TEST(IslandEstimates, VesselsOfAPieceThatIsResectedWithTheRestAreCut) {
  const PlanAssessor assessor(perfusedArch());
  const LiverPerfusion perfusion(perfusedArch());
  // The bar is resected, and the shorter leg with it: the vein is cut where it enters the leg from above.
  const PerfusionEstimate planes = perfusion.effectOf(planOf({{flipped(kAcrossPerfusedLegs)}}));
  ASSERT_EQ(planes.hepaticCuts.size(), 1U);
  EXPECT_LT(planes.hepaticCuts[0].positionMm.z(), 26);
  const PerfusionEstimate given = perfusion.effectOf(withIslandGiven(assessor, flipped(kAcrossPerfusedLegs)));
  ASSERT_EQ(given.hepaticCuts.size(), 1U);
  EXPECT_GT(given.hepaticCuts[0].positionMm.z(), 40);
}

TEST(IslandEstimates, TerritoriesAddUpToWhatThePlanTakes) {
  const PlanAssessor assessor(perfusedArch());
  const LiverPerfusion perfusion(perfusedArch());
  const TerritoryChoice choice = proposeLeftRight(perfusion.portal());
  ASSERT_FALSE(choice.picks.empty());
  const Territories territories = territoriesOf(*perfusedArch().liver, perfusion.portal(), choice);
  for (const HalfSpace& plane : {kAcrossPerfusedLegs, flipped(kAcrossPerfusedLegs)}) {
    const ResectionPlan plan = withIslandGiven(assessor, plane);
    double resected = 0;
    for (const TerritoryVolume& part : volumesOf(territories, plan)) {
      EXPECT_NEAR(part.resectedMl + part.remnantMl, part.volumeMl, 1e-9);
      resected += part.resectedMl;
    }
    EXPECT_NEAR(resected, assessor.volumes(plan).resectedMl, 1e-6);
  }
}

}  // namespace
}  // namespace glisson
