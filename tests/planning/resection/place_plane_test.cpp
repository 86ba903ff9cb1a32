#include "planning/resection/place_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "planning/infinity.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {

double heightOver(const HalfSpace& plane, const Vec3& p) { return plane.normal.dot(p - plane.origin); }

Vec3 randomPoint(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 50);
  return {normal(random), normal(random), normal(random)};
}

void expectSamePlane(const HalfSpace& a, const HalfSpace& b) {
  EXPECT_NEAR((a.normal - b.normal).norm(), 0, 1e-9);
  EXPECT_NEAR(heightOver(a, b.origin), 0, 1e-8);
}

TEST(PlaneFromCamera, IsSeenEdgeOnWithItsNormalToTheRight) {
  // Seen from the front (looking to posterior, +y), up is superior: the picture's right is the patient's left, +x.
  const HalfSpace plane = planeFromCamera(Vec3(10, 20, 30), Vec3::UnitY(), Vec3::UnitZ());
  EXPECT_EQ(plane.origin, Vec3(10, 20, 30));
  EXPECT_NEAR((plane.normal - Vec3::UnitX()).norm(), 0, 1e-15);
  EXPECT_THROW(planeFromCamera(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitZ()), PlanningError);
}

TEST(PlaneFromCamera, ThroughAClickedPointHoldsTheEyeOfAPerspectiveView) {
  std::mt19937 random(11);
  for (int n = 0; n < 50; ++n) {
    const Vec3 eye = 10 * randomPoint(random);
    const Vec3 clicked = randomPoint(random);
    const Vec3 up = randomPoint(random).normalized();
    const HalfSpace plane = planeFromCamera(clicked, clicked - eye, up);
    EXPECT_EQ(plane.origin, clicked);
    EXPECT_NEAR(heightOver(plane, eye), 0, 1e-9);
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-14);
    EXPECT_NEAR(plane.normal.dot(up), 0, 1e-12);
  }
}

TEST(PlaneThroughPoints, HoldsThemAndResectsTheSideTheyAreCounterClockwiseFrom) {
  const HalfSpace plane = planeThroughPoints(Vec3(0, 0, 5), Vec3(2, 0, 5), Vec3(0, 1, 5));
  EXPECT_NEAR((plane.normal - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR(heightOver(plane, Vec3(7, -8, 6)), 1, 1e-14);
  std::mt19937 random(12);
  for (int n = 0; n < 100; ++n) {
    const Vec3 a = randomPoint(random);
    const Vec3 b = randomPoint(random);
    const Vec3 c = randomPoint(random);
    const HalfSpace made = planeThroughPoints(a, b, c);
    for (const Vec3& p : {a, b, c}) {
      EXPECT_NEAR(heightOver(made, p), 0, 1e-10);
    }
    expectSamePlane(planeThroughPoints(b, c, a), made);
    expectSamePlane(planeThroughPoints(b, a, c), flipped(made));
  }
}

TEST(PlaneThroughPoints, TurnsAndShiftsWithThem) {
  const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  const Vec3 shift(100, -30, 7);
  std::mt19937 random(13);
  for (int n = 0; n < 50; ++n) {
    const Vec3 a = randomPoint(random);
    const Vec3 b = randomPoint(random);
    const Vec3 c = randomPoint(random);
    const HalfSpace before = planeThroughPoints(a, b, c);
    expectSamePlane(planeThroughPoints(turn * a + shift, turn * b + shift, turn * c + shift),
                    {turn * before.origin + shift, turn * before.normal});
  }
}

TEST(PlaneThroughPoints, PointsInLineOrNotFiniteAreRefused) {
  EXPECT_THROW(planeThroughPoints(Vec3::Zero(), Vec3(1, 2, 3), Vec3(2, 4, 6)), PlanningError);
  EXPECT_THROW(planeThroughPoints(Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(2, 4, 6)), PlanningError);
  EXPECT_THROW(planeThroughPoints(Vec3(400, 300, 200), Vec3(500, 300, 200), Vec3(450, 300, 200.0005)), PlanningError);
  EXPECT_THROW(planeThroughPoints(Vec3(NAN, 1, 1), Vec3(1, 0, 1), Vec3(2, 4, 6)), PlanningError);
  EXPECT_THROW(planeThroughPoints(Vec3(kInfinity, 1, 1), Vec3(1, 0, 1), Vec3(2, 4, 6)), PlanningError);
}

TEST(PlaneOfLine, HoldsTheStrokeAndTheViewDirectionAndResectsItsRight) {
  // From the front, drawn upwards: the right of the picture is +x, as for the camera's own plane.
  const HalfSpace plane = planeOfLine(Vec3(5, 9, 0), Vec3(5, -9, 80), Vec3::UnitY());
  EXPECT_NEAR((plane.normal - Vec3::UnitX()).norm(), 0, 1e-14);
  expectSamePlane(plane, planeFromCamera(Vec3(5, 0, 40), Vec3::UnitY(), Vec3::UnitZ()));
  // Drawn from left to right: below the stroke.
  EXPECT_GT(heightOver(planeOfLine(Vec3(0, 0, 40), Vec3(10, 0, 40), Vec3::UnitY()), Vec3(0, 0, 0)), 0);
  std::mt19937 random(14);
  for (int n = 0; n < 50; ++n) {
    const Vec3 a = randomPoint(random);
    const Vec3 b = randomPoint(random);
    const Vec3 view = randomPoint(random);
    const HalfSpace made = planeOfLine(a, b, view);
    EXPECT_NEAR(heightOver(made, a), 0, 1e-10);
    EXPECT_NEAR(heightOver(made, b), 0, 1e-10);
    EXPECT_NEAR(made.normal.dot(view), 0, 1e-10);
    expectSamePlane(planeOfLine(b, a, view), flipped(made));
    expectSamePlane(planeOfLine(a, b, 1e-3 * view), made);
    expectSamePlane(planeOfLine(a + 17 * view, b - 5 * view, view), made);  // how deep the ends are clicked does not matter
  }
}

TEST(PlaneOfLine, FromTheEyeHoldsTheEyeAndTendsToTheParallelViewFarAway) {
  std::mt19937 random(15);
  for (int n = 0; n < 50; ++n) {
    const Vec3 a = randomPoint(random);
    const Vec3 b = randomPoint(random);
    const Vec3 view = randomPoint(random).normalized();
    const Vec3 eye = 0.5 * (a + b) - 1e9 * view;
    EXPECT_NEAR((planeOfLineFromEye(a, b, eye).normal - planeOfLine(a, b, view).normal).norm(), 0, 1e-6);
    const Vec3 near = 0.5 * (a + b) - 300 * view + randomPoint(random);
    const HalfSpace made = planeOfLineFromEye(a, b, near);
    for (const Vec3& p : {a, b, near}) {
      EXPECT_NEAR(heightOver(made, p), 0, 1e-9);
    }
  }
}

TEST(PlaneOfLine, StrokeWithoutLengthInTheViewIsRefused) {
  EXPECT_THROW(planeOfLine(Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3::UnitY()), PlanningError);
  EXPECT_THROW(planeOfLine(Vec3(1, 2, 3), Vec3(1, 9, 3), Vec3::UnitY()), PlanningError);
  EXPECT_THROW(planeOfLine(Vec3(1, 2, 3), Vec3(5, 2, 3), Vec3::Zero()), PlanningError);
  EXPECT_THROW(planeOfLine(Vec3(1, 2, NAN), Vec3(5, 2, 3), Vec3::UnitY()), PlanningError);
}

TEST(PlaneParallelToSlice, ResectsSuperiorPosteriorOrLeftInEveryStraightGrid) {
  for (const Vec3& signs : {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(-1, -1, -1)}) {
    ImageGeometry g;
    g.size = {10, 10, 10};
    g.direction.col(0) = signs[0] * Vec3::UnitY();  // a sagittal acquisition: i to the back, j to the head, k to the left
    g.direction.col(1) = signs[1] * Vec3::UnitZ();
    g.direction.col(2) = signs[2] * Vec3::UnitX();
    const Vec3 p(1, 2, 3);
    EXPECT_EQ(planeParallelToSlice(g, SlicePlane::Axial, p).normal, Vec3::UnitZ());
    EXPECT_EQ(planeParallelToSlice(g, SlicePlane::Coronal, p).normal, Vec3::UnitY());
    EXPECT_EQ(planeParallelToSlice(g, SlicePlane::Sagittal, p).normal, Vec3::UnitX());
    EXPECT_EQ(planeParallelToSlice(g, SlicePlane::Sagittal, p).origin, p);
  }
}

TEST(PlaneParallelToSlice, FollowsATiltedGrid) {
  ImageGeometry g;
  g.size = {10, 10, 10};
  g.direction = Eigen::AngleAxisd(0.3, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  EXPECT_NEAR((planeParallelToSlice(g, SlicePlane::Axial, Vec3::Zero()).normal - g.direction.col(2)).norm(), 0, 1e-15);
  // All voxel centres of one slice lie on one plane.
  const HalfSpace plane = planeParallelToSlice(g, SlicePlane::Axial, g.toWorld(Vec3(4, 4, 7)));
  EXPECT_NEAR(heightOver(plane, g.toWorld(Vec3(0, 9, 7))), 0, 1e-12);
  EXPECT_NEAR(heightOver(plane, g.toWorld(Vec3(3, 1, 8))), 1, 1e-12);
  EXPECT_THROW(planeParallelToSlice(g, SlicePlane::Axial, Vec3(NAN, 0, 0)), PlanningError);
}

}  // namespace
}  // namespace glisson
