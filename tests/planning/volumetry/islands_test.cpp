// Separated pieces of the two sides: found, listed, given to the other side and back, with volumes that add up exactly.

#include <gtest/gtest.h>

#include <random>

#include "planning/resection/plan_edit.h"
#include "planning/volumetry/assessment.h"
#include "planning/volumetry/side_pieces.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

const Vec3 kArchSpacing(0.8, 0.9, 2.5);

/// A bar along x (0 to 60 mm) with two legs up z at its ends: 12 mm wide, of 40 and 30 mm. Cut at half height across the legs the
/// upper side falls into two pieces. The shorter leg holds a tumour, a vessel runs through the longer one.
Case archLiver() {
  const ImageGeometry g = gridOf({90, 34, 28}, kArchSpacing, Vec3(-5, -5, -5));
  const Inside bar = box(Vec3(0, 0, 0), Vec3(60, 20, 15));
  const Inside longLeg = box(Vec3(0, 0, 0), Vec3(12, 20, 55));
  const Inside shortLeg = box(Vec3(48, 0, 0), Vec3(60, 20, 45));
  const auto liver = [=](const Vec3& p) { return bar(p) || longLeg(p) || shortLeg(p); };
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, liver},
                                             {"tumour", StructureKind::Tumour, box(Vec3(51, 5, 32), Vec3(57, 12, 40))},
                                             {"portal vein", StructureKind::PortalVein, tube(Vec3(6, 10, 0), Vec3::UnitZ(), 3)}}));
}

const HalfSpace kAcrossLegs{Vec3(30, 10, 25.3), Vec3::UnitZ()};

TEST(Islands, LegsAboveAPlaneAreTwoPiecesAndTheSmallerOneIsListed) {
  const PlanAssessor assessor(archLiver());
  const PlanAssessment r = assessor.assess(planOf({{kAcrossLegs}}));
  ASSERT_EQ(r.islands.size(), 1U);
  EXPECT_EQ(r.islands[0].side, PlanSide::Resected);
  EXPECT_FALSE(r.islands[0].assigned);
  // The voxels' own boxes: 15 voxels by 22 across, up to the slice's upper face.
  const PlanAssessment shortLeg = assessor.volumes(planOf({{kAcrossLegs, {Vec3(30, 0, 0), Vec3::UnitX()}}}));
  EXPECT_NEAR(r.islands[0].volumeMl, shortLeg.resectedMl, 1e-7);
  EXPECT_NEAR(r.islands[0].volumeMl, 15 * 0.8 * 22 * 0.9 * (43.75 - 25.3) * kMlPerMm3, 1e-6);
  const PlanAssessment longLeg = assessor.volumes(planOf({{kAcrossLegs, {Vec3(30, 0, 0), -Vec3::UnitX()}}}));
  EXPECT_NEAR(longLeg.resectedMl + r.islands[0].volumeMl, r.resectedMl, 1e-7);
  EXPECT_GT(r.islands[0].point.x(), 48);
  EXPECT_GT(r.islands[0].point.z(), 25);
}

TEST(Islands, TurnedAroundTheyAreTheRemnants) {
  const PlanAssessor assessor(archLiver());
  const PlanAssessment up = assessor.assess(planOf({{kAcrossLegs}}));
  const PlanAssessment down = assessor.assess(planOf({{flipped(kAcrossLegs)}}));
  ASSERT_EQ(down.islands.size(), 1U);
  EXPECT_EQ(down.islands[0].side, PlanSide::Remnant);
  EXPECT_NEAR(down.islands[0].volumeMl, up.islands[0].volumeMl, 1e-7);
}

TEST(Islands, GivenToTheOtherSideTheirVolumeMovesExactlyAndBack) {
  const PlanAssessor assessor(archLiver());
  for (const HalfSpace& plane : {kAcrossLegs, flipped(kAcrossLegs), HalfSpace{Vec3(30, 10, 30), Vec3(0.1, 0.2, 1).normalized()}}) {
    const ResectionPlan plan = planOf({{plane}});
    const PlanAssessment before = assessor.assess(plan);
    ASSERT_EQ(before.islands.size(), 1U);
    const IslandAssessment& island = before.islands[0];
    const PlanSide to = island.side == PlanSide::Resected ? PlanSide::Remnant : PlanSide::Resected;
    const ResectionPlan given = apply(plan, AssignIsland{{island.point, to}});
    const PlanAssessment after = assessor.assess(given);
    const double sign = to == PlanSide::Resected ? 1 : -1;
    EXPECT_NEAR(after.resectedMl, before.resectedMl + sign * island.volumeMl, 1e-9);
    EXPECT_NEAR(after.functionalRemnantMl, before.functionalRemnantMl - sign * island.functionalMl, 1e-9);
    EXPECT_EQ(after.resectedMl + after.remnantMl, after.totalMl);
    EXPECT_LT(after.resections[0].cutAreaMm2, before.resections[0].cutAreaMm2) << "the cut in front of the island is none";
    EXPECT_TRUE(after.warning.empty()) << after.warning;
    ASSERT_EQ(after.islands.size(), 1U) << "still listed, so that it can be given back";
    EXPECT_TRUE(after.islands[0].assigned);
    EXPECT_EQ(assessor.volumes(given).resectedMl, after.resectedMl);
    const PlanAssessment back = assessor.assess(apply(given, ReleaseIsland{{0}}));
    EXPECT_EQ(toJson(back), toJson(before));
  }
}

TEST(Islands, AreAllThatAMovingPlanLeavesOut) {
  const PlanAssessor assessor(archLiver());
  const ResectionPlan plan = planOf({{kAcrossLegs}});
  PlanAssessment resting = assessor.assess(plan);
  const ResectionPlan given = apply(plan, AssignIsland{{resting.islands.at(0).point, PlanSide::Remnant}});
  for (const ResectionPlan& each : {plan, given}) {
    resting = assessor.assess(each);
    ASSERT_FALSE(resting.islands.empty());
    resting.islands.clear();
    EXPECT_EQ(toJson(assessor.assessMoving(each)), toJson(resting));
  }
}

TEST(Islands, KnowWhichAssignmentsGiveThemAway) {
  const PlanAssessor assessor(archLiver());
  ResectionPlan plan = planOf({{kAcrossLegs}});
  // Two points of the shorter leg, with one between them that gives nothing away: it lies nearer to the leg's own point.
  plan.islands = {
      {Vec3(54, 10, 28), PlanSide::Remnant}, {Vec3(54, 10, 35), PlanSide::Resected}, {Vec3(54, 10, 42), PlanSide::Remnant}};
  const PlanAssessment given = assessor.assess(plan);
  ASSERT_EQ(given.islands.size(), 1U);
  EXPECT_EQ(given.islands[0].assignments, (std::vector<std::size_t>{0, 2}));
  const PlanAssessment back = assessor.assess(apply(plan, ReleaseIsland{given.islands[0].assignments}));
  ASSERT_EQ(back.islands.size(), 1U);
  EXPECT_FALSE(back.islands[0].assigned);
  EXPECT_TRUE(back.islands[0].assignments.empty());
}

TEST(Islands, FunctionalVolumeLeavesTheTumourOut) {
  const Case arch = archLiver();
  const PlanAssessment r = PlanAssessor(arch).assess(planOf({{kAcrossLegs}}));
  EXPECT_NEAR(r.islands[0].volumeMl - r.islands[0].functionalMl, arch.liver->tumourMl(), 1e-9);
}

TEST(Islands, TumoursAndVesselsBelongToTheSideTheirIslandIsGivenTo) {
  const PlanAssessor assessor(archLiver());
  const ResectionPlan plan = planOf({{kAcrossLegs}});
  const PlanAssessment before = assessor.assess(plan);
  EXPECT_EQ(before.tumours[0].state, TumourState::Removed);
  EXPECT_NEAR(before.tumours[0].marginMm.value(), 31.25 - 25.3, 1e-9) << "from the lower face of the tumour's first slice";
  EXPECT_EQ(before.vesselsCrossed.size(), 1U);
  const PlanAssessment after = assessor.assess(apply(plan, AssignIsland{{before.islands[0].point, PlanSide::Remnant}}));
  EXPECT_EQ(after.tumours[0].state, TumourState::Left);
  EXPECT_GT(after.tumours[0].distanceMm.value(), 30) << "to the cut of the other leg, not to the plane beside it";
  EXPECT_EQ(after.vesselsCrossed.size(), 1U) << "the vessel is in the other leg";
}

TEST(Islands, DepthOfACutTumourIsToTheSurfaceThatStillDividesTheSides) {
  const ImageGeometry g = gridOf({90, 34, 28}, kArchSpacing, Vec3(-5, -5, -5));
  const Inside bar = box(Vec3(0, 0, 0), Vec3(60, 20, 15));
  const Inside longLeg = box(Vec3(0, 0, 0), Vec3(12, 20, 55));
  const Inside shortLeg = box(Vec3(48, 0, 0), Vec3(60, 20, 45));
  const Inside foot = box(Vec3(3, 5, 8), Vec3(57, 12, 12));
  const Inside shaft = box(Vec3(3, 5, 8), Vec3(9, 12, 30));
  const PlanAssessor assessor(newCase(
      nullptr,
      segmentationOf(g, {{"liver", StructureKind::Liver, [=](const Vec3& p) { return bar(p) || longLeg(p) || shortLeg(p); }},
                         {"tumour", StructureKind::Tumour, [=](const Vec3& p) { return foot(p) || shaft(p); }}})));
  const ResectionPlan plan = planOf({{kAcrossLegs}});
  const PlanAssessment before = assessor.assess(plan);
  ASSERT_EQ(before.tumours[0].state, TumourState::Cut);
  const double down = 25.3 - 8.75;  // the lower face of the foot's first slice
  EXPECT_NEAR(before.tumours[0].marginMm.value(), -down, 1e-9);
  // Under the shorter leg nothing is cut any more: the way goes to the edge of the other leg's cut.
  ASSERT_EQ(before.islands.size(), 1U);
  const PlanAssessment after = assessor.assess(apply(plan, AssignIsland{{before.islands[0].point, PlanSide::Remnant}}));
  ASSERT_EQ(after.tumours[0].state, TumourState::Cut);
  const double across = 57.0 - 12.2;  // faces of the last voxels of foot and longer leg
  const double depth = std::hypot(across, down);
  EXPECT_NEAR(after.tumours[0].marginMm.value(), -depth, 1e-9);
  EXPECT_NEAR(after.tumours[0].marginAtLeastMm.value(), -depth - 0.5 * (across * 0.8 + down * 2.5) / depth, 1e-9);
  EXPECT_TRUE(after.warning.empty()) << after.warning;
}

TEST(Islands, MainPiecesAndPlacesOutsideCannotBeGivenAway) {
  const PlanAssessor assessor(archLiver());
  const ResectionPlan plan = planOf({{kAcrossLegs}});
  const PlanAssessment before = assessor.volumes(plan);
  for (const IslandAssignment& wrong :
       {IslandAssignment{Vec3(6, 10, 40), PlanSide::Remnant}, IslandAssignment{Vec3(30, 10, 7), PlanSide::Resected},
        IslandAssignment{Vec3(30, 10, 40), PlanSide::Remnant}, IslandAssignment{Vec3(1e9, 0, 0), PlanSide::Remnant},
        IslandAssignment{Vec3(54, 10, 35), PlanSide::Resected}}) {
    ResectionPlan given = plan;
    given.islands = {wrong};
    const PlanAssessment after = assessor.assess(given);
    EXPECT_EQ(after.resectedMl, before.resectedMl);
    EXPECT_NE(after.warning.find("no island"), std::string::npos) << after.warning;
  }
}

TEST(Islands, ResectionsOfOnePlanAreNoIslandsOfEachOther) {
  const PlanAssessor assessor(archLiver());
  const HalfSpace left{Vec3(9, 0, 0), -Vec3::UnitX()};
  const HalfSpace right{Vec3(51, 0, 0), Vec3::UnitX()};
  EXPECT_TRUE(assessor.assess(planOf({{left}, {right}})).islands.empty());
}

TEST(Islands, PieceOfAMillilitreOrLessIsNotListedButCanBeGiven) {
  const PlanAssessor assessor(archLiver());
  const HalfSpace high{Vec3(30, 10, 43.2), Vec3::UnitZ()};  // some 2 mm of the shorter leg
  const ResectionPlan plan = planOf({{high}});
  const PlanAssessment r = assessor.assess(plan);
  EXPECT_TRUE(r.islands.empty());
  const PlanAssessment given = assessor.assess(apply(plan, AssignIsland{{Vec3(54, 10, 43.3), PlanSide::Remnant}}));
  EXPECT_LT(given.resectedMl, r.resectedMl - 0.1);
  EXPECT_EQ(given.islands.size(), 1U);
}

TEST(Islands, ConvexLiverHasNone) {
  const ImageGeometry g = gridOf({60, 60, 24}, kArchSpacing);
  const PlanAssessor assessor(
      newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, box(Vec3(3, 3, 3), Vec3(44, 50, 55))}})));
  std::mt19937 random(21);
  std::normal_distribution<double> normal;
  for (int n = 0; n < test::trials(100); ++n) {
    const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 origin = Vec3(23, 26, 29) + 8 * Vec3(normal(random), normal(random), normal(random));
    EXPECT_TRUE(assessor.assess(planOf({{{origin, direction}}})).islands.empty()) << n;
  }
}

TEST(SidePieces, OfBothSidesAddUpToTheLiver) {
  const Case arch = archLiver();
  const VoxelRows rows = rowsOf(arch.liver->liver);
  std::mt19937 random(22);
  std::normal_distribution<double> normal;
  for (int n = 0; n < test::trials(100); ++n) {
    const auto plane = [&] {
      return HalfSpace{Vec3(30, 10, 20) + 15 * Vec3(normal(random), normal(random), normal(random)),
                       Vec3(normal(random), normal(random), normal(random)).normalized()};
    };
    const ResectionPlan plan = n % 3 == 0 ? planOf({{plane(), plane()}, {plane()}}) : planOf({{plane()}});
    const auto resections = toImage(plan, arch.liver->geometry);
    const SidePieces pieces(rows, kArchSpacing, resections);
    std::int64_t resected = 0;
    std::int64_t all = 0;
    for (const SidePiece& piece : pieces.pieces()) {
      EXPECT_GT(piece.units, 0);
      EXPECT_TRUE(pieces.pieceAt(piece.side, piece.point).has_value());
      resected += piece.side == PlanSide::Resected ? piece.units : 0;
      all += piece.units;
    }
    EXPECT_EQ(all, static_cast<std::int64_t>(rows.voxels) << 32);
    const double mm3 = static_cast<double>(resected - resect(rows, kArchSpacing, resections).totalUnits()) / kUnitsPerVoxel;
    EXPECT_NEAR(mm3, 0, 1e-5) << "voxel by voxel as run by run";
  }
}

}  // namespace
}  // namespace glisson
