#include "planning/territories/perfusion.h"

#include <gtest/gtest.h>

#include "fork.h"
#include "planning/territories/territory_json.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {
using namespace test;

const double kFunctionalMl = 80 * 40 * 60 * 1e-3;

TEST(Perfusion, CutThroughOneBranchTakesWhatLiesBehindItAndNothingElse) {
  const LiverPerfusion perfusion(forkCase());
  const PerfusionEstimate r = perfusion.effectOf(planOf({forkSlab(0, 10)}));
  ASSERT_TRUE(r.devascularisedMl && r.congestedMl);
  EXPECT_NEAR(*r.devascularisedMl, forkSlabMl(10, 40), 0.02 * forkSlabMl(10, 40));
  EXPECT_NEAR(*r.congestedMl, forkSlabMl(-20, 0), 0.03 * forkSlabMl(-20, 0));
  EXPECT_NEAR(r.devascularisedOrCongestedMl, *r.devascularisedMl + *r.congestedMl, 1e-9);
  EXPECT_NEAR(r.functionalRemnantMl, kFunctionalMl - forkSlabMl(0, 10), 1e-6);
  EXPECT_NEAR(r.perfusedFlrMl, r.functionalRemnantMl - r.devascularisedOrCongestedMl, 1e-9);
  EXPECT_NEAR(r.perfusedFlrPercent, 100 * r.perfusedFlrMl / kFunctionalMl, 1e-9);
  ASSERT_EQ(r.portalCuts.size(), 1U);
  EXPECT_LT((r.portalCuts[0].positionMm - Vec3(20, -10, 0)).norm(), 1);
  EXPECT_NEAR(r.portalCuts[0].radiusMm, 2.6, 0.6);
  ASSERT_EQ(r.hepaticCuts.size(), 1U);
  EXPECT_LT((r.hepaticCuts[0].positionMm - Vec3(20, 10, 10)).norm(), 1);
}

TEST(Perfusion, WhatIsBothDevascularisedAndCongestedCountsOnce) {
  const LiverPerfusion perfusion(forkCase());
  const PerfusionEstimate r = perfusion.effectOf(planOf({forkSlab(-4, 0), forkSlab(10, 14)}));
  const double remnantHalf = forkSlabMl(-20, -4) + forkSlabMl(0, 10) + forkSlabMl(14, 40);
  EXPECT_NEAR(*r.devascularisedMl, forkSlabMl(0, 10) + forkSlabMl(14, 40), 1);
  EXPECT_NEAR(*r.congestedMl, forkSlabMl(-20, -4) + forkSlabMl(0, 10), 1);
  EXPECT_NEAR(r.devascularisedOrCongestedMl, remnantHalf, 1.5);
  EXPECT_NEAR(r.perfusedFlrMl, (40 + kForkBorder) * 40 * 60 * 1e-3, 1.5);
}

TEST(Perfusion, PlaneThatMissesTheLiverCutsNothing) {
  const LiverPerfusion perfusion(forkCase());
  // The second one takes the trunk and the cava, but no liver: what lies outside it is not resected.
  for (const HalfSpace& plane : {HalfSpace{Vec3(0, 0, 80), Vec3::UnitZ()}, HalfSpace{Vec3(0, 0, 41), Vec3::UnitZ()},
                                 HalfSpace{Vec3(0, 0, -21), -Vec3::UnitZ()}}) {
    const PerfusionEstimate r = perfusion.effectOf(planOf({{plane}}));
    EXPECT_EQ(*r.devascularisedMl, 0);
    EXPECT_EQ(*r.congestedMl, 0);
    EXPECT_EQ(r.perfusedFlrPercent, 100);
    EXPECT_TRUE(r.portalCuts.empty());
    EXPECT_TRUE(r.hepaticCuts.empty());
  }
  EXPECT_EQ(perfusion.effectOf({}).perfusedFlrMl, perfusion.effectOf({}).functionalRemnantMl);
}

TEST(Perfusion, ResectionOfAWholeTerritoryLeavesTheOtherPerfused) {
  const LiverPerfusion perfusion(forkCase());
  const PerfusionEstimate r = perfusion.effectOf(planOf({{{Vec3(kForkBorder, 0, 0), Vec3::UnitX()}}}));
  EXPECT_LT(*r.devascularisedMl, 0.02 * kFunctionalMl);
  EXPECT_LT(*r.congestedMl, 0.02 * kFunctionalMl);
  EXPECT_NEAR(r.perfusedFlrMl, r.functionalRemnantMl, 0.02 * kFunctionalMl);
}

TEST(Perfusion, ResectionThinnerThanAVoxelCutsTheBranchItCrosses) {
  const LiverPerfusion perfusion(forkCase());
  const PerfusionEstimate r = perfusion.effectOf(planOf({forkSlab(5.1, 5.2)}));
  EXPECT_EQ(r.portalCuts.size(), 1U);
  EXPECT_EQ(r.hepaticCuts.size(), 1U);
  EXPECT_NEAR(*r.devascularisedMl, forkSlabMl(5.2, 40), 1.5);
}

TEST(Perfusion, IsTheSameInATurnedShiftedAndMirroredGrid) {
  const Case straight = forkCase(Vec3(1, 1, 2));
  auto segmentation = std::make_shared<Segmentation>(*straight.segmentation);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  segmentation->geometry.direction = turn;
  segmentation->geometry.origin = Vec3(300, -200, 100);
  const LiverPerfusion a(straight);
  const LiverPerfusion b(newCase(nullptr, segmentation));
  const ImageGeometry& from = straight.segmentation->geometry;
  const ImageGeometry& to = segmentation->geometry;
  for (const auto& planes : {forkSlab(0.3, 9), std::vector<ResectionPlane>{{Vec3(1, 2, 3), Vec3(1, 0.4, 0.3).normalized()}}}) {
    std::vector<ResectionPlane> same;
    for (const HalfSpace& plane : planes) {
      same.push_back({to.toWorld(from.toIndex(plane.origin)), turn * plane.normal});
    }
    const PerfusionEstimate x = a.effectOf(planOf({planes}));
    const PerfusionEstimate y = b.effectOf(planOf({same}));
    EXPECT_NEAR(*x.devascularisedMl, *y.devascularisedMl, 1e-6);
    EXPECT_NEAR(*x.congestedMl, *y.congestedMl, 1e-6);
    EXPECT_NEAR(x.perfusedFlrMl, y.perfusedFlrMl, 1e-6);
    ASSERT_EQ(x.portalCuts.size(), y.portalCuts.size());
    for (std::size_t n = 0; n < x.portalCuts.size(); ++n) {
      EXPECT_LT((to.toWorld(from.toIndex(x.portalCuts[n].positionMm)) - y.portalCuts[n].positionMm).norm(), 1e-6);
    }
  }
}

TEST(Perfusion, FollowsAnObliqueLiverOnAnyGrid) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.linear() = Eigen::AngleAxisd(0.5, Vec3(0.3, 1, 0.4).normalized()).toRotationMatrix();
  place.translation() = Vec3(10, 20, -300);
  const Mat3 grid = Eigen::AngleAxisd(0.2, Vec3(1, 1, 0).normalized()).toRotationMatrix() * Vec3(-1, 1, 1).asDiagonal();
  const LiverPerfusion perfusion(forkCase(Vec3(0.8, 0.8, 2), place, grid));
  const PerfusionEstimate r = perfusion.effectOf(moved(planOf({forkSlab(0, 10)}), place));
  EXPECT_NEAR(*r.devascularisedMl, forkSlabMl(10, 40), 0.08 * forkSlabMl(10, 40));
  EXPECT_NEAR(*r.congestedMl, forkSlabMl(-20, 0), 0.1 * forkSlabMl(-20, 0));
}

TEST(Perfusion, TumourInTheLostPartIsNoFunctionThatIsLost) {
  const Case& plain = forkCase();
  auto segmentation = std::make_shared<Segmentation>(*plain.segmentation);
  LabelledMask tumour;
  tumour.name = "tumour";
  tumour.label = 9;
  tumour.kind = StructureKind::Tumour;
  tumour.mask = voxelised(segmentation->geometry, box(Vec3(25, -5, 20), Vec3(35, 5, 30)));
  segmentation->structures.push_back(tumour);
  const ResectionPlan plan = planOf({forkSlab(0, 10)});
  const PerfusionEstimate without = LiverPerfusion(plain).effectOf(plan);
  const PerfusionEstimate with = LiverPerfusion(newCase(nullptr, segmentation)).effectOf(plan);
  EXPECT_NEAR(*with.devascularisedMl, *without.devascularisedMl, 1e-9);
  EXPECT_NEAR(with.functionalRemnantMl, without.functionalRemnantMl - 1, 1e-9);
  EXPECT_NEAR(with.perfusedFlrMl, without.perfusedFlrMl, 1e-9);
}

TEST(Perfusion, WithoutVesselsIsNotKnownAndSaid) {
  const ImageGeometry g = gridOf({30, 30, 30}, Vec3(1, 1, 1));
  const LiverPerfusion perfusion(
      newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(15, 15, 15), 10)}})));
  const PerfusionEstimate r = perfusion.effectOf(planOf({{{Vec3(15, 15, 15), Vec3::UnitX()}}}));
  EXPECT_FALSE(r.devascularisedMl);
  EXPECT_FALSE(r.congestedMl);
  EXPECT_EQ(r.perfusedFlrMl, r.functionalRemnantMl);
  EXPECT_FALSE(r.isKnown());
  EXPECT_EQ(perfusion.notes().size(), 2U);
}

TEST(Perfusion, TrunkThatHardlyEntersTheLiverSaysNothing) {
  const ImageGeometry g = gridOf({100, 44, 150}, Vec3(1, 1, 1), Vec3(-49.5, -21.5, -106.5));
  const Case source = newCase(
      nullptr,
      segmentationOf(
          g, {{"liver", StructureKind::Liver, box(kForkLow, kForkHigh)},
              {"portal vein", StructureKind::PortalVein,
               anyOf({rod({0, 0, -100}, {0, 0, -30}, 5), rod({0, 0, -30}, {-8, 0, -17}, 3), rod({0, 0, -30}, {9, 0, -17}, 3)})}}));
  const LiverPerfusion perfusion(source);
  EXPECT_FALSE(perfusion.effectOf(planOf({{{Vec3(0, 0, 0), Vec3::UnitX()}}})).devascularisedMl);
  EXPECT_NE(perfusion.notes().at(0).find("too few"), std::string::npos);
  EXPECT_TRUE(proposeLeftRight(perfusion.portal()).picks.empty());
}

TEST(Perfusion, LabelledCavaIsNeverCut) {
  // The cava runs through the liver; the resection takes it and the left vein, but the right vein's way stays open.
  const ImageGeometry g = gridOf({120, 60, 120}, Vec3(1, 1, 1), Vec3(-59.5, -29.5, -59.5));
  const Case source =
      newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, box(Vec3(-50, -25, -40), Vec3(50, 25, 40))},
                                          {"hepatic vein", StructureKind::HepaticVein,
                                           anyOf({rod({10, 0, 20}, {-40, 0, 20}, 3), rod({10, 0, 20}, {45, 0, 20}, 3)})},
                                          {"inferior vena cava", StructureKind::VenaCava, rod({10, 0, -59}, {10, 0, 59}, 9)}}));
  const LiverPerfusion perfusion(source);
  const PerfusionEstimate r = perfusion.effectOf(planOf({{{Vec3(9, 0, 0), Vec3::UnitX()}}}));
  EXPECT_LT(*r.congestedMl, 0.06 * r.functionalRemnantMl);
  const PerfusionEstimate all = perfusion.effectOf(planOf({{{Vec3(-5, 0, 0), Vec3::UnitX()}}}));
  EXPECT_GT(*all.congestedMl, 0.95 * all.functionalRemnantMl);
}

TEST(Perfusion, IsTheSameForAnyNumberOfThreadsAndCanBeCancelled) {
  const Case source = forkCase(Vec3(1, 1, 2));
  const ResectionPlan plan = planOf({{{Vec3(1, 2, 3), Vec3(1, 0.4, 0.3).normalized()}}, forkSlab(-8, -2)});
  std::vector<double> made;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    made.push_back(LiverPerfusion(source).effectOf(plan).perfusedFlrMl);
  }
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(LiverPerfusion(source, context), Cancelled);
}

TEST(TerritoryJson, HasTheKeysOfTheContractBehindThoseOfThePlan) {
  const Case& source = forkCase();
  const LiverPerfusion perfusion(source);
  const ResectionPlan plan = planOf({forkSlab(0, 10)});
  TerritoryReport report;
  report.territories = territoriesOf(*source.liver, perfusion.portal(), proposeLeftRight(perfusion.portal()));
  report.volumes = volumesOf(report.territories, plan);
  report.effect = perfusion.effectOf(plan);
  const auto json = Json::parse(toJson(PlanAssessor(source).assess(plan), report, perfusion));
  EXPECT_TRUE(json.contains("flrPercent"));
  const auto& estimates = json["estimates"];
  std::vector<std::string> keys;
  for (const auto& [key, value] : estimates.items()) {
    keys.push_back(key);
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"territoriesFrom", "territoriesConfirmed", "territories", "tumours", "devascularisedMl",
                                            "congestedMl", "devascularisedOrCongestedMl", "perfusedFlrMl", "perfusedFlrPercent",
                                            "portalCuts", "hepaticCuts", "mainBifurcationMm", "portalBranches", "notes"}));
  EXPECT_EQ(estimates["territories"][0]["name"], "left");
  EXPECT_EQ(estimates["territoriesConfirmed"], false);
  EXPECT_EQ(estimates["devascularisedMl"].get<double>(), *report.effect.devascularisedMl);
}

}  // namespace
}  // namespace glisson
