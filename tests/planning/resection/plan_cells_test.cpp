#include "planning/resection/plan_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reconstruction/errors.h"

namespace glisson {
namespace {

template <typename Plane>
bool inside(const std::vector<Plane>& bounds, const Vec3& point) {
  return std::ranges::all_of(bounds, [&](const HalfSpace& h) { return h.normal.dot(point - h.origin) > 0; });
}

TEST(PlanCells, OfAnEmptyPlanIsAllRemnant) {
  const std::vector<PlanCell> cells = cellsOf({});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].side, PlanSide::Remnant);
  EXPECT_TRUE(cells[0].bounds.empty());
}

TEST(PlanCells, OfAWedgeAreItsInsideAndTwoPartsOfTheRest) {
  const std::vector<PlanCell> cells =
      cellsOf({"Plan", {{"Wedge", {{Vec3::Zero(), Vec3::UnitX()}, {Vec3::Zero(), Vec3::UnitY()}}}}});
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(std::ranges::count(cells, PlanSide::Resected, &PlanCell::side), 1);
}

TEST(PlanCells, OfABentPlaneThereAreNone) {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  EXPECT_THROW(cellsOf({"Plan", {{"R", {ResectionPlane(plane, flatBend(plane, 50))}}}}), PlanningError);
}

TEST(PlanCells, HoldEachPointOnceAndOnItsSide) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    ResectionPlan plan;
    for (int r = 0; r < trial % 4; ++r) {
      Resection resection;
      for (int p = 0; p <= (trial + r) % 3; ++p) {
        resection.planes.push_back({vector(), vector().normalized()});
      }
      plan.resections.push_back(resection);
    }
    const std::vector<PlanCell> cells = cellsOf(plan);
    for (int n = 0; n < 100; ++n) {
      const Vec3 point = 2 * vector();
      const bool resected = std::ranges::any_of(plan.resections, [&](const Resection& r) { return inside(r.planes, point); });
      int holding = 0;
      for (const PlanCell& cell : cells) {
        if (inside(cell.bounds, point)) {
          ++holding;
          EXPECT_EQ(cell.side == PlanSide::Resected, resected);
        }
      }
      EXPECT_EQ(holding, 1);
    }
  }
}

}  // namespace
}  // namespace glisson
