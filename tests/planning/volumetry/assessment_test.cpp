#include "planning/volumetry/assessment.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/json.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

const Vec3 kBlockSpacing(0.8, 0.8, 2.5);

/// A liver that fills a block of voxels [20, 60) x [20, 60) x [5, 15): 32 x 32 x 25 mm about (31.6, 31.6, 23.75).
Case blockLiver() {
  const ImageGeometry g = gridOf({80, 80, 20}, kBlockSpacing);
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, [g](const Vec3& p) {
                                                const Vec3 i = g.toIndex(p);
                                                return i[0] > 19.5 && i[0] < 59.5 && i[1] > 19.5 && i[1] < 59.5 && i[2] > 4.5 &&
                                                       i[2] < 14.5;
                                              }}}));
}
const Vec3 kBlockCentre(0.8 * 39.5, 0.8 * 39.5, 2.5 * 9.5);

Case ballLiver() {
  const ImageGeometry g = gridOf({90, 90, 30}, kBlockSpacing, Vec3(-100, 50, 7));
  const Vec3 c = g.toWorld(Vec3(44.5, 44.5, 14.5));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(c, 30)},
                                             {"tumour", StructureKind::Tumour, ball(c + Vec3(12, 0, 0), 6)},
                                             {"portal vein", StructureKind::PortalVein, tube(c, Vec3::UnitX(), 4)}}));
}

TEST(Volumes, BlockCutAtAnyAngleIsExact) {
  const PlanAssessor assessor(blockLiver());
  const Box block{kBlockCentre, Vec3(16, 16, 12.5)};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-20, 20);
  for (int n = 0; n < 200; ++n) {
    const Vec3 normal = n < 3 ? Vec3(Vec3::Unit(n)) : randomDirection(random);
    const Vec3 origin = kBlockCentre + shift(random) * normal;
    const ImagePlane plane{normal, -normal.dot(origin)};
    const PlanAssessment result = assessor.volumes(planOf({{{origin, normal}}}));
    EXPECT_NEAR(result.resectedMl, volumeOf(block, {&plane, 1}) * kMlPerMm3, 1e-8);  // 400 runs of 2^-33 voxel of 1.6 mm^3 each
    EXPECT_NEAR(result.resections[0].cutAreaMm2, areaOf(sectionOf(block, plane)), 1e-5);
  }
}

TEST(Volumes, ResectedAndRemnantAddUpExactlyForRandomPlans) {
  const Case liver = ballLiver();
  const PlanAssessor assessor(liver);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-35, 35);
  const Vec3 centre = liver.liver->geometry.toWorld(Vec3(44.5, 44.5, 14.5));
  const auto plane = [&] { return HalfSpace{centre + Vec3(shift(random), shift(random), shift(random)), randomDirection(random)}; };
  for (int n = 0; n < test::trials(1000); ++n) {
    const ResectionPlan plan = n % 10 == 0 ? planOf({{plane(), plane()}, {plane()}}) : planOf({{plane()}});
    const PlanAssessment r = assessor.volumes(plan);
    EXPECT_EQ(r.resectedMl + r.remnantMl, r.totalMl);
    EXPECT_GE(r.resectedMl, 0);
    EXPECT_GE(r.remnantMl, 0);
    EXPECT_LE(r.functionalRemnantMl, r.remnantMl + 1e-9);
    double sum = 0;
    for (const ResectionVolume& part : r.resections) {
      sum += part.volumeMl;
    }
    EXPECT_NEAR(sum, r.resectedMl, 1e-9);
  }
}

TEST(Volumes, OppositePlanesShareTheLiverWithoutGapOrOverlap) {
  const PlanAssessor assessor(ballLiver());
  std::mt19937 random(3);
  for (int n = 0; n < test::trials(100); ++n) {
    const Vec3 normal = randomDirection(random);
    const Vec3 origin = Vec3(-65, 85, 43) + 10 * randomDirection(random);
    const double one = assessor.volumes(planOf({{{origin, normal}}})).resectedMl;
    const double other = assessor.volumes(planOf({{{origin, -normal}}})).resectedMl;
    EXPECT_NEAR(one + other, assessor.volumes({}).totalMl, 1e-7);
  }
}

TEST(Volumes, PlaneThroughTheCentreHalvesABall) {
  const PlanAssessor assessor(ballLiver());
  const Vec3 centre = Vec3(-100, 50, 7) + Vec3(44.5, 44.5, 14.5).cwiseProduct(kBlockSpacing);
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(1, 2, 3)}) {
    const PlanAssessment r = assessor.volumes(planOf({{{centre, normal.normalized()}}}));
    EXPECT_NEAR(r.resectedMl / r.totalMl, 0.5, 1e-9);  // the voxels are symmetric about it
    EXPECT_NEAR(r.resections[0].cutAreaMm2, std::numbers::pi * 900, 0.02 * std::numbers::pi * 900);
    EXPECT_NEAR(r.totalMl, 4.0 / 3 * std::numbers::pi * 27, 0.01 * 113);
  }
}

TEST(Volumes, MovingAPlaneByATenthOfAMillimetreMovesAreaTimesThat) {
  const PlanAssessor assessor(ballLiver());
  std::mt19937 random(4);
  for (int n = 0; n < test::trials(100); ++n) {
    const HalfSpace plane{Vec3(-65, 85, 43), n < 3 ? Vec3(Vec3::Unit(n)) : randomDirection(random)};
    const PlanAssessment before = assessor.volumes(planOf({{plane}}));
    const PlanAssessment after = assessor.volumes(planOf({{movedAlongNormal(plane, -0.1)}}));
    const double expected = before.resections[0].cutAreaMm2 * 0.1 * kMlPerMm3;
    EXPECT_NEAR(after.resectedMl - before.resectedMl, expected, 0.01 * expected) << n;
  }
}

TEST(Volumes, AreTheSameInATurnedShiftedAndMirroredGrid) {
  const Case straight = ballLiver();
  auto turnedSegmentation = std::make_shared<Segmentation>(*straight.segmentation);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  turnedSegmentation->geometry.direction = turn;
  turnedSegmentation->geometry.origin = Vec3(300, -200, 100);
  const PlanAssessor a(straight);
  const PlanAssessor b(newCase(nullptr, turnedSegmentation));
  const ImageGeometry& from = straight.segmentation->geometry;
  const ImageGeometry& to = turnedSegmentation->geometry;
  std::mt19937 random(5);
  for (int n = 0; n < 50; ++n) {
    const HalfSpace plane{Vec3(-65, 85, 43), randomDirection(random)};
    const HalfSpace same{to.toWorld(from.toIndex(plane.origin)), turn * plane.normal};
    const PlanAssessment x = a.assess(planOf({{plane}}));
    const PlanAssessment y = b.assess(planOf({{same}}));
    EXPECT_NEAR(x.resectedMl, y.resectedMl, 1e-8);
    ASSERT_EQ(x.tumours[0].state, y.tumours[0].state);
    EXPECT_NEAR(x.tumours[0].marginMm.value_or(0), y.tumours[0].marginMm.value_or(0), 1e-9);
    ASSERT_EQ(x.vesselsCrossed.size(), y.vesselsCrossed.size());
    for (std::size_t v = 0; v < x.vesselsCrossed.size(); ++v) {
      EXPECT_NEAR((to.toWorld(from.toIndex(x.vesselsCrossed[v].positionMm)) - y.vesselsCrossed[v].positionMm).norm(), 0, 1e-6);
    }
  }
}

TEST(Volumes, ResectionOfTwoPlanesIsTheirWedge) {
  const PlanAssessor assessor(blockLiver());
  const std::vector<ResectionPlane> quarter{{kBlockCentre + Vec3(0.13, 0, 0), Vec3::UnitX()},
                                            {kBlockCentre + Vec3(0, 0.21, 0), Vec3::UnitY()}};
  const PlanAssessment r = assessor.volumes(planOf({quarter}));
  EXPECT_NEAR(r.resectedMl, 15.87 * 15.79 * 25 * kMlPerMm3, 1e-9);
  EXPECT_NEAR(r.resections[0].cutAreaMm2, (15.87 + 15.79) * 25, 1e-4);
}

TEST(Volumes, OverlappingResectionsCountOnce) {
  const PlanAssessor assessor(blockLiver());
  const HalfSpace right{kBlockCentre + Vec3(0.13, 0, 0), Vec3::UnitX()};
  const HalfSpace front{kBlockCentre + Vec3(0, 0.21, 0), Vec3::UnitY()};
  const PlanAssessment r = assessor.volumes(planOf({{right}, {front}}));
  const double rightMl = 15.87 * 32 * 25 * kMlPerMm3;
  EXPECT_NEAR(r.resections[0].volumeMl, rightMl, 1e-9);
  EXPECT_NEAR(r.resections[1].volumeMl, 16.13 * 15.79 * 25 * kMlPerMm3, 1e-9);
  // The surface is the outer boundary of both: each plane ends where the other resection begins.
  EXPECT_NEAR(r.resections[0].cutAreaMm2, 16.21 * 25, 1e-4);
  EXPECT_NEAR(r.resections[1].cutAreaMm2, 16.13 * 25, 1e-4);
  EXPECT_NEAR(assessor.volumes(planOf({{right}, {right}})).resectedMl, rightMl, 1e-9);
}

TEST(Volumes, UnionOfObliqueResectionsFollowsInclusionAndExclusion) {
  const PlanAssessor assessor(ballLiver());
  std::mt19937 random(6);
  for (int n = 0; n < test::trials(20); ++n) {
    const HalfSpace a{Vec3(-65, 85, 43) + 8 * randomDirection(random), randomDirection(random)};
    const HalfSpace b{Vec3(-65, 85, 43) + 8 * randomDirection(random), randomDirection(random)};
    const auto ml = [&](const ResectionPlan& plan) { return assessor.volumes(plan).resectedMl; };
    EXPECT_NEAR(ml(planOf({{a}, {b}})), ml(planOf({{a}})) + ml(planOf({{b}})) - ml(planOf({{a, b}})), 1e-7);
  }
}

TEST(Volumes, UncertaintyIsHalfASliceTimesTheCut) {
  const PlanAssessment r = PlanAssessor(blockLiver()).volumes(planOf({{{kBlockCentre, Vec3::UnitX()}}}));
  EXPECT_NEAR(r.volumeUncertaintyMl, 0.5 * 2.5 * 32 * 25 * kMlPerMm3, 1e-6);
}

TEST(Volumes, PlaneThatMissesTheLiverSaysSo) {
  const PlanAssessor assessor(blockLiver());
  const PlanAssessment beyond = assessor.volumes(planOf({{{kBlockCentre + Vec3(100, 0, 0), Vec3::UnitX()}}}));
  EXPECT_EQ(beyond.resectedMl, 0);
  EXPECT_FALSE(beyond.divides);
  const auto json = Json::parse(toJson(beyond));
  for (const char* key : {"resectedMl", "remnantMl", "functionalRemnantMl", "flrPercent", "volumeUncertaintyMl"}) {
    EXPECT_TRUE(json[key].is_null()) << key << " is a number of no plan";
  }
  EXPECT_TRUE(json["resections"][0]["volumeMl"].is_null());
  EXPECT_TRUE(json["totalMl"].is_number()) << "the liver is there";
  EXPECT_NE(beyond.warning.find("does not divide the liver"), std::string::npos);
  const PlanAssessment all = assessor.volumes(planOf({{{kBlockCentre - Vec3(100, 0, 0), Vec3::UnitX()}}}));
  EXPECT_EQ(all.remnantMl, 0);
  EXPECT_FALSE(all.divides);
  EXPECT_FALSE(all.warning.empty());
  EXPECT_TRUE(assessor.volumes(planOf({{{kBlockCentre, Vec3::UnitX()}}})).warning.empty());
  EXPECT_TRUE(assessor.volumes(planOf({{{kBlockCentre, Vec3::UnitX()}}})).divides);
  // One of two resections misses: the other one still divides.
  const PlanAssessment both =
      assessor.volumes(planOf({{{kBlockCentre, Vec3::UnitX()}}, {{kBlockCentre + Vec3(100, 0, 0), Vec3::UnitX()}}}));
  EXPECT_TRUE(both.divides);
  EXPECT_NE(both.warning.find("Resection 2 does not divide"), std::string::npos);
}

TEST(Volumes, ResectionsThatTakeAllTogetherSayWhyThereAreNone) {
  const PlanAssessor assessor(blockLiver());
  const HalfSpace right{kBlockCentre, Vec3::UnitX()};
  const PlanAssessment all = assessor.volumes(planOf({{right}, {flipped(right)}}));
  EXPECT_FALSE(all.divides);
  EXPECT_EQ(all.warning, "The resections of the plan together take all of the liver, so nothing of it remains.");
  const PlanAssessment overlapping = assessor.volumes(planOf({{right}, {{kBlockCentre + Vec3(5, 0, 0), -Vec3::UnitX()}}}));
  EXPECT_EQ(overlapping.warning, all.warning);
  const PlanAssessment one = assessor.volumes(planOf({{right}, {{kBlockCentre - Vec3(100, 0, 0), Vec3::UnitX()}}}));
  EXPECT_EQ(one.warning, "Resection 2 does not divide the liver: all of it is resected.");
}

TEST(Volumes, ResectionInsideAnotherIsToldSo) {
  const PlanAssessor assessor(blockLiver());
  const PlanAssessment r =
      assessor.volumes(planOf({{{kBlockCentre, Vec3::UnitX()}}, {{kBlockCentre + Vec3(5, 0, 0), Vec3::UnitX()}}}));
  EXPECT_TRUE(r.divides);
  EXPECT_EQ(r.resections[1].volumeMl, 0);
  EXPECT_TRUE(r.resections[1].dividesByItself);
  EXPECT_EQ(r.warning, "Resection 2 takes nothing: other resections of the plan already take all that it would.");
  // The other way round the first one has its part of what both take.
  const PlanAssessment turned =
      assessor.volumes(planOf({{{kBlockCentre + Vec3(5, 0, 0), Vec3::UnitX()}}, {{kBlockCentre, Vec3::UnitX()}}}));
  EXPECT_TRUE(turned.warning.empty()) << turned.warning;
}

TEST(Volumes, PlanWithoutResectionLeavesEverything) {
  const PlanAssessment r = PlanAssessor(ballLiver()).assess({"Plan 1", {}, 10});
  EXPECT_EQ(r.remnantMl, r.totalMl);
  EXPECT_EQ(r.flrPercent, 100);
  EXPECT_TRUE(r.warning.empty());
  ASSERT_EQ(r.tumours.size(), 1U);
  EXPECT_EQ(r.tumours[0].state, TumourState::Left);
  EXPECT_FALSE(r.tumours[0].distanceMm);
}

TEST(Volumes, TumourLeftBehindIsNoFunction) {
  const Case liver = ballLiver();
  const PlanAssessor assessor(liver);
  const PlanAssessment r = assessor.volumes(planOf({{{Vec3(-100, 0, 0), -Vec3::UnitX()}}}));  // resects nothing of the liver
  EXPECT_NEAR(r.functionalRemnantMl, liver.liver->functionalMl(), 1e-9);
  EXPECT_LT(r.functionalRemnantMl, r.remnantMl - 0.8);
  EXPECT_NEAR(r.flrPercent, 100, 1e-9);
}

TEST(Json, HasTheKeysOfTheContract) {
  const PlanAssessment r = PlanAssessor(ballLiver()).assess(planOf({{{Vec3(-65, 85, 43), Vec3::UnitX()}}}));
  const auto json = Json::parse(toJson(r));
  const auto keys = [](const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) {
      names.push_back(name);
    }
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(keys(json), (Names{"totalMl", "tumourMl", "functionalMl", "resectedMl", "remnantMl", "volumeUncertaintyMl",
                               "functionalRemnantMl", "flrPercent", "resections", "islands", "tumours", "vesselsCrossed"}));
  EXPECT_EQ(keys(json["resections"][0]), (Names{"name", "volumeMl", "cutAreaMm2"}));
  EXPECT_EQ(keys(json["tumours"][0]), (Names{"name", "kind", "state", "marginMm", "marginAtLeastMm", "distanceMm"}));
  EXPECT_EQ(keys(json["vesselsCrossed"][0]), (Names{"name", "positionMm", "diameterMm", "runsAlongCut"}));
  EXPECT_EQ(json["totalMl"].get<double>(), r.totalMl);
  EXPECT_EQ(json["tumours"][0]["state"], "removed");
  EXPECT_TRUE(json["tumours"][0]["distanceMm"].is_null());
}

}  // namespace
}  // namespace glisson
