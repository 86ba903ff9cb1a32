#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/tumour_margin.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

const Vec3 kBallSpacing(0.8, 0.8, 2.5);

/// A ball of liver about the origin, radius 40 mm, with one tumour.
Case liverWith(const Inside& tumour) {
  const ImageGeometry g = gridOf({112, 112, 36}, kBallSpacing, -0.5 * kBallSpacing.cwiseProduct(Vec3(111, 111, 35)));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3::Zero(), 40)},
                                             {"tumour", StructureKind::Tumour, tumour}}));
}

TumourAssessment assessOne(const Case& liver, const ResectionPlan& plan) { return PlanAssessor(liver).assess(plan).tumours.at(0); }

/// Smallest signed distance of the tumour's voxel boxes to a plane.
double boxesToPlane(const Case& liver, const HalfSpace& plane) {
  const ImageGeometry& g = liver.segmentation->geometry;
  const ImagePlane image = toImage(plane, g);
  double least = 1e9;
  for (const RowRun& run : rowsOf(liver.liver->tumour).runs) {
    const Box box = boxOf(run, g.spacing);
    least = std::min(least, image.distance(box.centre) - image.support(box.half));
  }
  return least;
}

TEST(ShortestWay, AgreesWithDenseSampling) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 200; ++n) {
    const Box box{Vec3::Zero(), Vec3(0.4, 0.4, 1.25)};
    const Vec3 centre = 3.0 * randomDirection(random);
    const Polygon polygon = sectionOf({centre, Vec3(0.8, 0.4, 1.25)}, [&] {
      ImagePlane plane{randomDirection(random), 0};
      plane.offset = -plane.normal.dot(centre);
      return plane;
    }());
    const CutDistance::Way way = shortestWay(box, polygon);
    double sampled = 1e9;
    for (int s = 0; s < 4000; ++s) {
      Vec3 p = Vec3::Zero();
      double weights = 0;
      for (const Vec3& corner : polygon) {
        const double w = std::pow(0.5 * (1 + unit(random)), 4);
        p += w * corner;
        weights += w;
      }
      p /= weights;
      sampled = std::min(sampled, (p - p.cwiseMax(-box.half).cwiseMin(box.half)).norm());
    }
    EXPECT_LE(way.mm, sampled + 1e-12);
    EXPECT_GE(way.mm, sampled - 0.15);
    EXPECT_NEAR((way.to - way.from).norm(), way.mm, 1e-12);
  }
}

TEST(Margin, AxisParallelIsTheDistanceOfTheVoxelFace) {
  const Case liver = liverWith(ball(Vec3::Zero(), 5));
  // The outermost tumour voxel's centre lies at -4.4 - 0.4 mm or beyond: read it from the mask.
  const HalfSpace plane{Vec3(-20, 0, 0), Vec3::UnitX()};
  const TumourAssessment t = assessOne(liver, planOf({{plane}}));
  EXPECT_EQ(t.state, TumourState::Removed);
  const IndexBox& box = liver.liver->tumour.box();
  const double face = liver.segmentation->geometry.toWorld(Vec3(box.first[0] - 0.5, 0, 0))[0];
  EXPECT_NEAR(t.marginMm.value(), face + 20, 1e-9);
  EXPECT_NEAR(t.marginAtLeastMm.value(), face + 20 - 0.4, 1e-9);
  EXPECT_FALSE(t.distanceMm);
}

TEST(Margin, ObliquePlaneUnderTheTumourIsTheBoxesDistanceToIt) {
  const Case liver = liverWith(ball(Vec3(3, -2, 1), 7));
  std::mt19937 random(2);
  for (int n = 0; n < 30; ++n) {
    const Vec3 normal = randomDirection(random);
    const HalfSpace plane{-15 * normal, normal};
    const TumourAssessment t = assessOne(liver, planOf({{plane}}));
    ASSERT_EQ(t.state, TumourState::Removed);
    EXPECT_NEAR(t.marginMm.value(), boxesToPlane(liver, plane), 1e-9);
    EXPECT_NEAR(t.marginMm.value(), normal.dot(Vec3(3, -2, 1)) + 15 - 7, 1.6);
  }
}

TEST(Margin, FastSearchEqualsBruteForceWhereTheCutEndsBesideTheTumour) {
  // The tumour sits at the liver's edge, so the nearest point of the plane may lie outside the liver and does not count.
  std::mt19937 random(3);
  int beside = 0;
  for (int n = 0; n < test::trials(12); ++n) {
    const Vec3 seat = 36 * randomDirection(random);
    const Case liver = liverWith(ball(seat, 5));
    const Vec3 across = seat.cross(randomDirection(random)).normalized();
    const Vec3 normal = (across + (n % 2 == 0 ? -0.8 : 0.5) * seat.normalized()).normalized();
    const HalfSpace plane{normal * (normal.dot(seat) - 12), normal};
    const TumourAssessment t = assessOne(liver, planOf({{plane}}));
    const ImageGeometry& g = liver.segmentation->geometry;
    double brute = 1e9;
    const auto pieces = cutSurface(rowsOf(liver.liver->liver), g.spacing, toImage(planOf({{plane}}), g));
    for (const RowRun& run : rowsOf(liver.liver->tumour).runs) {
      for (const CutPiece& piece : pieces) {
        brute = std::min(brute, shortestWay(boxOf(run, g.spacing), piece.polygon).mm);
      }
    }
    ASSERT_EQ(t.state, TumourState::Removed);
    EXPECT_NEAR(t.marginMm.value(), brute, 1e-9);
    EXPECT_GE(t.marginMm.value(), boxesToPlane(liver, plane) - 1e-6);
    beside += t.marginMm.value() > boxesToPlane(liver, plane) + 0.5 ? 1 : 0;
  }
  EXPECT_GT(beside, 0) << "no case tested what the name says";
}

TEST(Margin, CutTumourHasMinusItsDepthInTheRemnant) {
  const Case liver = liverWith(ball(Vec3::Zero(), 10));
  std::mt19937 random(4);
  for (int n = 0; n < 20; ++n) {
    const Vec3 normal = randomDirection(random);
    const HalfSpace plane{4 * normal, normal};
    const TumourAssessment t = assessOne(liver, planOf({{plane}}));
    ASSERT_EQ(t.state, TumourState::Cut);
    EXPECT_NEAR(t.marginMm.value(), boxesToPlane(liver, plane), 1e-9);
    EXPECT_NEAR(t.marginAtLeastMm.value(), *t.marginMm - 0.5 * normal.cwiseAbs().dot(kBallSpacing), 1e-9);
    EXPECT_LT(t.marginMm.value(), -13);
  }
}

TEST(Margin, CutByAWedgeIsTheDepthToItsEdge) {
  const Case liver = liverWith(ball(Vec3::Zero(), 10));
  // Resected: x >= 2 and y >= 2; the deepest voxel corner of the tumour lies towards (-1, -1, 0).
  const TumourAssessment t = assessOne(liver, planOf({{{Vec3(2, 0, 0), Vec3::UnitX()}, {Vec3(0, 2, 0), Vec3::UnitY()}}}));
  ASSERT_EQ(t.state, TumourState::Cut);
  double deepest = 0;
  const ImageGeometry& g = liver.segmentation->geometry;
  for (const RowRun& run : rowsOf(liver.liver->tumour).runs) {
    const Vec3 low = g.toWorld(Vec3(run.i - 0.5, run.j - 0.5, run.k));
    const Vec3 high = g.toWorld(Vec3(run.i + run.n - 0.5, run.j + 0.5, run.k));
    for (const double y : {low[1], high[1]}) {
      deepest = std::max(deepest, std::hypot(std::max(0.0, 2 - low[0]), std::max(0.0, 2 - y)));
    }
  }
  EXPECT_NEAR(t.marginMm.value(), -deepest, 1e-9);
}

TEST(Margin, TumourLeftBehindHasADistanceAndNoMargin) {
  const Case liver = liverWith(ball(Vec3::Zero(), 5));
  const HalfSpace plane{Vec3(15, 0, 0), Vec3::UnitX()};
  const TumourAssessment t = assessOne(liver, planOf({{plane}}));
  EXPECT_EQ(t.state, TumourState::Left);
  EXPECT_FALSE(t.marginMm);
  EXPECT_FALSE(t.marginAtLeastMm);
  EXPECT_NEAR(t.distanceMm.value(), boxesToPlane(liver, {plane.origin, -plane.normal}), 1e-9);
}

TEST(Margin, SurfaceInsideAnotherResectionDoesNotCount) {
  const Case liver = liverWith(ball(Vec3(-10, 0, 0), 4));
  const HalfSpace near{Vec3(0, 0, 0), -Vec3::UnitX()};  // 6 mm from the tumour, but swallowed by the second resection
  const HalfSpace far{Vec3(20, 0, 0), -Vec3::UnitX()};
  const double single = assessOne(liver, planOf({{far}})).marginMm.value();
  const TumourAssessment both = assessOne(liver, planOf({{near}, {far}}));
  EXPECT_EQ(both.state, TumourState::Removed);
  EXPECT_NEAR(both.marginMm.value(), single, 1e-9);
  EXPECT_NEAR(single, 26, 0.9);
}

TEST(Margin, TumourTouchingThePlaneHasMarginNil) {
  const Case liver = liverWith(ball(Vec3::Zero(), 5));
  const ImageGeometry& g = liver.segmentation->geometry;
  const double face = g.toWorld(Vec3(liver.liver->tumour.box().first[0] - 0.5, 0, 0))[0];
  const TumourAssessment t = assessOne(liver, planOf({{{Vec3(face, 0, 0), Vec3::UnitX()}}}));
  EXPECT_EQ(t.state, TumourState::Removed);
  EXPECT_NEAR(t.marginMm.value(), 0, 1e-6);
}

}  // namespace
}  // namespace glisson
