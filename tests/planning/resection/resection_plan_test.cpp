#include "planning/resection/resection_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "planning/resection/plan_edit.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {

ResectionPlan onePlane() { return {"Plan 1", {{"Resection 1", {{Vec3(1, 2, 3), Vec3::UnitX()}}}}, 10}; }

TEST(ResectionPlan, MovingAPlaneChangesThatPlaneOnlyAndMakesItsNormalUnit) {
  ResectionPlan plan = onePlane();
  plan.resections[0].planes.push_back({Vec3::Zero(), Vec3::UnitZ()});
  const ResectionPlan moved = apply(plan, {0, 1, {Vec3(7, 8, 9), Vec3(0, 3, 4)}});
  EXPECT_EQ(moved.resections[0].planes[0].origin, Vec3(1, 2, 3));
  EXPECT_EQ(moved.resections[0].planes[1].origin, Vec3(7, 8, 9));
  EXPECT_NEAR((moved.resections[0].planes[1].normal - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(plan.resections[0].planes[1].origin, Vec3::Zero()) << "the plan before is kept for undo";
}

TEST(ResectionPlan, PlaneThatDoesNotExistIsRefused) {
  EXPECT_THROW(apply(onePlane(), {1, 0, {}}), PlanningError);
  EXPECT_THROW(apply(onePlane(), {0, 1, {}}), PlanningError);
}

TEST(ResectionPlan, PlaneThatIsNoPlaneIsRefused) {
  EXPECT_THROW(apply(onePlane(), {0, 0, {Vec3::Zero(), Vec3::Zero()}}), PlanningError);
  EXPECT_THROW(apply(onePlane(), {0, 0, {Vec3(0, NAN, 0), Vec3::UnitX()}}), PlanningError);
  EXPECT_THROW(apply(onePlane(), {0, 0, {Vec3::Zero(), Vec3(INFINITY, 0, 0)}}), PlanningError);
}

TEST(ResectionPlan, MovesAlongItsNormalByMillimetres) {
  const HalfSpace plane{Vec3(1, 1, 1), Vec3(0, 0.6, 0.8)};
  const HalfSpace moved = movedAlongNormal(plane, -5);
  EXPECT_NEAR((moved.origin - Vec3(1, -2, -3)).norm(), 0, 1e-14);
  EXPECT_EQ(moved.normal, plane.normal);
}

TEST(ResectionPlan, TurnsAboutItsOriginAndStaysUnit) {
  const HalfSpace turnedPlane = turned({Vec3(1, 2, 3), Vec3::UnitX()}, Vec3(0, 0, 2), std::numbers::pi / 2);
  EXPECT_EQ(turnedPlane.origin, Vec3(1, 2, 3));
  EXPECT_NEAR((turnedPlane.normal - Vec3::UnitY()).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace glisson
