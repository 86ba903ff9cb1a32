// Margin colours of the resection surface: which points are red, yellow or plain.

#include "viewer/resection_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace glisson {
namespace {

/// Distances that rise by 1 mm a column; lower bounds 0.5 mm below.
MarginMap ramp() {
  MarginMap map{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 1.0, 31, 5}, {}};
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 31; ++column) {
      map.ways.push_back({static_cast<double>(column), column - 0.5});
    }
  }
  return map;
}

TEST(MarginPicture, IsRedInsideTheMarginYellowWhereOnlyTheLowerBoundIsAndPlainBeyond) {
  const int pixels = 10;
  const QImage picture = marginPicture(ramp(), 12, pixels);
  ASSERT_EQ(picture.size(), QSize(300, 40));
  int hatched = 0;
  for (int x = 0; x < 300; ++x) {
    const double mm = (x + 0.5) / pixels;
    const QColor colour = picture.pixelColor(x, 20);
    if (std::abs(mm - 5 * std::round(mm / 5)) < 0.1 && mm > 4) {
      EXPECT_LT(colour.red(), 60) << mm;  // an iso line
      EXPECT_GT(colour.alpha(), 100) << mm;
    } else if (mm < 12) {
      EXPECT_GE(colour.red(), 100) << mm;
      EXPECT_LT(colour.green(), 10) << mm;
      hatched += colour.red() < 200 ? 1 : 0;
    } else if (mm < 12.5) {
      EXPECT_GT(colour.red(), 240) << mm;
      EXPECT_GT(colour.green(), 240) << mm;
    } else {
      EXPECT_EQ(colour.alpha(), 0) << mm;
    }
  }
  EXPECT_GT(hatched, 20);
}

TEST(GridOver, HoldsEveryPointOfTheOutline) {
  const HalfSpace plane{Vec3(1, 2, 3), Vec3(0.6, 0, 0.8)};
  const PlaneAxes axes = axesOf(plane.normal);
  const Loop loop{plane.origin + 12 * axes.u, plane.origin - 7 * axes.u + 3 * axes.v, plane.origin - 9 * axes.v};
  const PlaneGrid grid = gridOver({loop}, plane, 1.5);
  for (const Vec3& point : loop) {
    const double column = (point - grid.origin).dot(grid.u) / grid.stepMm;
    const double row = (point - grid.origin).dot(grid.v) / grid.stepMm;
    EXPECT_TRUE(column >= 0 && column <= grid.columns - 1 && row >= 0 && row <= grid.rows - 1);
  }
  EXPECT_NEAR(grid.u.cross(grid.v).dot(plane.normal), 1, 1e-12);  // seen from the resected side, u right and v up
  EXPECT_EQ(gridOver({}, plane, 1).columns, 0);
}

}  // namespace
}  // namespace glisson
