// The proposed plane against bodies whose best plane is known, against brute force, and where there is none.

#include "planning/volumetry/margin_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/parallel.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

Case caseOf(const Vec3& spacing, const Inside& liver, const Inside& tumour) {
  const Index3 size{static_cast<int>(110 / spacing[0]), static_cast<int>(110 / spacing[1]), static_cast<int>(110 / spacing[2])};
  const ImageGeometry g = gridOf(size, spacing, Vec3(-5, -5, -5));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, liver},
                                             {"met", StructureKind::Tumour, tumour},
                                             {"portal vein", StructureKind::PortalVein, tube(Vec3(50, 50, 50), Vec3::UnitX(), 4)},
                                             {"artery", StructureKind::Artery, tube(Vec3(50, 60, 50), Vec3::UnitX(), 1.2)}}));
}

const Inside kBox = box(Vec3(0, 0, 0), Vec3(100, 100, 100));

/// The functional volume of a plane, mL.
double functionalMl(const Case& source, const HalfSpace& plane) {
  const PlanAssessment r = PlanAssessor(source).volumes(planOf({{plane}}));
  return r.functionalMl - r.functionalRemnantMl;
}

/// The nearest plane of a direction that keeps the margin everywhere, straight from the definition.
HalfSpace clearPlane(const Case& source, const Vec3& direction, double margin) {
  const ImageGeometry& g = source.liver->geometry;
  const double clearance = margin + resolutionMm(g.direction.transpose() * direction, g.spacing) + 1e-6;
  double lowest = 1e9;
  for (const RowRun& run : rowsOf(*source.segmentation->structures[1].mask).runs) {
    const Box b = boxOf(run, g.spacing);
    const Vec3 image = g.direction.transpose() * direction;
    lowest = std::min(lowest, image.dot(b.centre) - image.cwiseAbs().dot(b.half));
  }
  const double height = lowest + direction.dot(g.origin) - clearance;
  return {height * direction, direction};
}

void expectKept(const Case& source, const MarginProposal& proposal) {
  ASSERT_TRUE(proposal.plane.has_value()) << proposal.reason;
  const PlanAssessment r = PlanAssessor(source).assess(planOf({{*proposal.plane}}));
  EXPECT_EQ(r.tumours[0].state, TumourState::Removed);
  EXPECT_GE(r.tumours[0].marginAtLeastMm.value(), proposal.safetyMarginMm);
  EXPECT_EQ(r.tumours[0].marginAtLeastMm.value(), proposal.marginAtLeastMm);
  EXPECT_NEAR(r.functionalMl - r.functionalRemnantMl, proposal.resectedFunctionalMl, 1e-9);
  EXPECT_TRUE(r.divides);
}

TEST(MarginPlane, OfABallNearABoxsSideIsParallelToThatSide) {
  // The mean depth of a plane that touches a ball on the box's axis is smallest where it is parallel to the face.
  const Vec3 centre(82, 50, 50);
  const Case made = caseOf(Vec3(1, 1, 1), kBox, ball(centre, 8));
  const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", 10);
  expectKept(made, proposal);
  EXPECT_NEAR(std::acos(std::min(1.0, proposal.plane->normal.dot(Vec3::UnitX()))), 0, 0.002);
  EXPECT_NEAR(proposal.marginAtLeastMm, 10, 1e-3);
  EXPECT_NEAR(proposal.marginMm, 10.5, 1e-3) << "half a voxel above the lower bound";
  const HalfSpace known = clearPlane(made, Vec3::UnitX(), 10);
  EXPECT_LE(proposal.resectedFunctionalMl, functionalMl(made, known) + 1e-6);
  EXPECT_NEAR(proposal.resectedFunctionalMl, functionalMl(made, known), 0.01);
  EXPECT_NEAR(known.origin.x(), 82 - 8 - 0.5 - 10.5, 0.51) << "the definition itself: ball, half voxel, margin and half a voxel";
}

TEST(MarginPlane, OfABallInABallIsAcrossTheLineOfTheirCentres) {
  const Vec3 liverCentre(50, 50, 50);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(1, 1, 0)}) {
    const Vec3 unit = direction.normalized();
    const Case made = caseOf(Vec3(1, 1, 1), ball(liverCentre, 48), ball(liverCentre + 30 * unit, 7));
    const MarginProposal proposal = proposeMarginPlane(made, "met", 5);
    expectKept(made, proposal);
    EXPECT_GT(proposal.plane->normal.dot(unit), std::cos(0.2)) << unit.transpose();
    // The cap of a ball of 48 mm beyond a plane d from its centre: pi h^2 (3 R - h) / 3 with h = R - d.
    const double d = 30 - 7 - 5 - resolutionMm(unit, Vec3(1, 1, 1)) - 0.5;
    const double h = 48 - d;
    const double cap = std::numbers::pi * h * h * (3 * 48 - h) / 3 * kMlPerMm3 - made.liver->tumourMl();
    EXPECT_NEAR(proposal.resectedFunctionalMl, cap, 0.05 * cap);
  }
}

TEST(MarginPlane, NoOtherPlaneThatIsClearOfTheTumourTakesLess) {
  struct Trial {
    Vec3 spacing;
    Vec3 tumour;
    double radius;
    double margin;
  };
  std::mt19937 random(41);
  std::normal_distribution<double> normal;
  for (const Trial& t : {Trial{Vec3(1, 1, 1), Vec3(85, 88, 80), 6, 8}, Trial{Vec3(0.8, 0.8, 2.5), Vec3(70, 40, 85), 9, 10},
                         Trial{Vec3(0.8, 0.8, 2.5), Vec3(50, 50, 50), 5, 3}}) {
    const Case made = caseOf(t.spacing, kBox, ball(t.tumour, t.radius));
    const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", t.margin);
    expectKept(made, proposal);
    const PlanAssessor assessor(made);
    for (int n = 0; n < test::trials(3000); ++n) {
      const HalfSpace other = clearPlane(made, Vec3(normal(random), normal(random), normal(random)).normalized(), t.margin);
      const PlanAssessment r = assessor.volumes(planOf({{other}}));
      if (r.divides && r.functionalRemnantMl > 0) {
        ASSERT_GE(r.functionalMl - r.functionalRemnantMl, proposal.resectedFunctionalMl * (1 - 1e-6)) << other.normal.transpose();
      }
    }
  }
}

TEST(MarginPlane, InACornerItCutsTheCornerOff) {
  const Case made = caseOf(Vec3(1, 1, 1), kBox, ball(Vec3(90, 90, 90), 4));
  const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", 3);
  expectKept(made, proposal);
  EXPECT_GT(proposal.plane->normal.dot(Vec3(1, 1, 1).normalized()), 0.95);
}

TEST(MarginPlane, ComesNearerWhereTheNearestPartOfThePlaneLiesOutsideTheLiver) {
  // A tumour on a stalk beside the liver's body: towards the body there is only the stalk, so the plane may stand close to the
  // tumour where nothing of the liver is near.
  const Inside body = box(Vec3(0, 0, 0), Vec3(40, 100, 100));
  const Inside stalk = box(Vec3(39, 0, 45), Vec3(95, 100, 55));
  const Case made = caseOf(
      Vec3(1, 1, 1), [=](const Vec3& p) { return body(p) || stalk(p); }, ball(Vec3(80, 50, 62), 8));
  const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", 6);
  expectKept(made, proposal);
  EXPECT_LE(proposal.resectedFunctionalMl, functionalMl(made, clearPlane(made, Vec3::UnitX(), 6)) + 1e-6);
}

TEST(MarginPlane, FollowsATurnedAndMirroredGrid) {
  const Case straight = caseOf(Vec3(1, 1, 2), kBox, ball(Vec3(80, 60, 50), 8));
  auto turned = std::make_shared<Segmentation>(*straight.segmentation);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  turned->geometry.direction = turn;
  turned->geometry.origin = Vec3(300, -200, 100);
  const Case made = newCase(nullptr, turned);
  const MarginProposal a = proposeMarginPlane(straight, "met", 10);
  const MarginProposal b = proposeMarginPlane(made, "met", 10);
  expectKept(made, b);
  EXPECT_NEAR((turn * a.plane->normal - b.plane->normal).norm(), 0, 1e-9);
  EXPECT_NEAR(a.resectedFunctionalMl, b.resectedFunctionalMl, 1e-7);
}

TEST(MarginPlane, IsNoneWhereTheMarginLeavesNothingOfTheLiver) {
  const Case made = caseOf(Vec3(2, 2, 2), kBox, ball(Vec3(50, 50, 50), 20));
  const MarginProposal none = proposeMarginPlane(made, "tumour_01", 90);
  EXPECT_FALSE(none.plane);
  EXPECT_NE(none.reason.find("No plane keeps 90 mm around met"), std::string::npos) << none.reason;
  const auto json = Json::parse(toJson(none));
  EXPECT_TRUE(json["plane"].is_null());
  EXPECT_TRUE(json["marginAtLeastMm"].is_null());
  EXPECT_TRUE(json["reason"].is_string());
  // A little less and there is one.
  EXPECT_TRUE(proposeMarginPlane(made, "tumour_01", 20).plane);
}

TEST(MarginPlane, SaysWhatItIgnoresAndListsVesselsOfThreeMillimetresOnly) {
  const Case made = caseOf(Vec3(1, 1, 1), kBox, ball(Vec3(80, 52, 50), 8));
  const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", 10);
  for (const char* word : {"inflow", "outflow", "access"}) {
    EXPECT_NE(proposal.notice.find(word), std::string::npos);
  }
  ASSERT_EQ(proposal.vessels.size(), 1U) << "the portal vein of 8 mm, not the artery of 2.4 mm";
  EXPECT_EQ(proposal.vessels[0].name, "portal vein");
  EXPECT_GE(proposal.vessels[0].diameterMm, 3);
}

TEST(MarginPlane, OriginLiesOnThePlaneInsideTheLiver) {
  const Case made = caseOf(Vec3(1, 1, 1), kBox, ball(Vec3(82, 50, 50), 8));
  const MarginProposal proposal = proposeMarginPlane(made, "tumour_01", 10);
  EXPECT_NEAR((proposal.plane->origin - Vec3(proposal.plane->origin.x(), 50, 50)).norm(), 0, 0.6);
}

TEST(MarginPlane, IsTheSameForAnyNumberOfThreads) {
  const Case made = caseOf(Vec3(2, 2, 2), kBox, ball(Vec3(75, 60, 40), 8));
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return toJson(proposeMarginPlane(made, "tumour_01", 10));
  };
  const std::string one = with(1);
  EXPECT_EQ(with(2), one);
  EXPECT_EQ(with(8), one);
}

TEST(MarginPlane, UnknownTumourAndImpossibleMarginAreRefusedAndCancelEndsIt) {
  const Case made = caseOf(Vec3(2, 2, 2), kBox, ball(Vec3(75, 60, 40), 8));
  EXPECT_THROW(proposeMarginPlane(made, "tumour_02", 10), PlanningError);
  EXPECT_THROW(proposeMarginPlane(made, "portal vein", 10), PlanningError);
  EXPECT_THROW(proposeMarginPlane(made, "tumour_01", -1), PlanningError);
  EXPECT_THROW(proposeMarginPlane(made, "tumour_01", NAN), PlanningError);
  ExecutionContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(proposeMarginPlane(made, "tumour_01", 10, cancelled), Cancelled);
  // At every phase.
  for (const double when : {0.4, 0.7}) {
    std::unique_ptr<ExecutionContext> context;
    context = std::make_unique<ExecutionContext>([&](double fraction, std::string_view) {
      if (fraction > when) {
        context->cancel();
      }
    });
    EXPECT_THROW(proposeMarginPlane(made, "tumour_01", 10, *context), Cancelled) << when;
  }
}

}  // namespace
}  // namespace glisson
