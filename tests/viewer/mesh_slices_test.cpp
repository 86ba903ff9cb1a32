// Surfaces cut by slices: a ball's circles on straight, flipped and permuted grids, closed lines, nothing beside the ball.

#include "viewer/mesh_slices.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/viewer/bodies.h"
#include "viewer/slice_view.h"

namespace glisson {
namespace {

const Vec3 kMiddle(5, -40, 120);
constexpr double kRadius = 20;

std::shared_ptr<const Reconstruction> ball() {
  auto made = std::make_shared<Reconstruction>();
  made->mesh = test::sphere(kMiddle, Vec3::Constant(kRadius), 60);
  return made;
}

ImageGeometry gridWith(const Mat3& direction) {
  ImageGeometry grid;
  grid.size = {40, 50, 60};
  grid.spacing = Vec3(2.0, 1.5, 1.2);
  grid.direction = direction;
  grid.origin = Vec3::Zero();
  grid.origin = kMiddle + Vec3(4, 3, -5) - grid.toWorld(Vec3(19.5, 24.5, 29.5));
  return grid;
}

std::vector<Mat3> directions() {
  Mat3 permuted;
  permuted << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  const Mat3 oblique = (Eigen::AngleAxisd(0.3, Vec3::UnitZ()) * Eigen::AngleAxisd(-0.2, Vec3::UnitX())).toRotationMatrix();
  return {Mat3::Identity(), Vec3(-1, -1, 1).asDiagonal(), Vec3(1, 1, -1).asDiagonal(), permuted, oblique};
}

TEST(MeshSlices, ABallIsACircleOfTheRightPlaceAndSizeInEverySlice) {
  for (const Mat3& direction : directions()) {
    const ImageGeometry grid = gridWith(direction);
    for (const SliceAxis axis : {SliceAxis::Axial, SliceAxis::Coronal, SliceAxis::Sagittal}) {
      const SliceGeometry geometry(grid, axis);
      const MeshSlices slices(ball(), geometry);
      const Vec3 along = grid.direction.col(static_cast<Eigen::Index>(geometry.sliceAxis));
      for (int slice = 0; slice < geometry.slices(); ++slice) {
        const double height = along.dot(geometry.toWorld({0, 0}, slice) - kMiddle);
        const auto lines = slices.outline(slice);
        if (std::abs(height) > kRadius) {
          EXPECT_TRUE(lines.empty());
          continue;
        }
        const double radius = std::sqrt(kRadius * kRadius - height * height);
        double length = 0;
        for (const auto& [a, b] : lines) {
          const Vec3 world = geometry.toWorld(a, slice);
          EXPECT_NEAR((world - kMiddle).norm(), kRadius, 0.05);
          length += (geometry.toWorld(b, slice) - world).norm();
        }
        if (radius > 3) {
          EXPECT_NEAR(length / (2 * std::numbers::pi * radius), 1, 0.02) << slice;  // a polygon near the poles
        }
      }
    }
  }
}

TEST(MeshSlices, TheLinesAreClosedAlsoThroughVertices) {
  ImageGeometry grid = gridWith(Mat3::Identity());
  grid.spacing = Vec3(1, 1, 1);
  grid.origin = kMiddle - Vec3(20, 25, 20);  // slice 20 runs through the equator's vertices, slice 0 and 40 through the poles
  const SliceGeometry geometry(grid, SliceAxis::Axial);
  const MeshSlices slices(ball(), geometry);
  for (const int slice : {0, 1, 20, 33, 40}) {
    std::map<std::pair<long, long>, int> ends;
    for (const auto& [a, b] : slices.outline(slice)) {
      for (const SlicePoint& end : {a, b}) {
        ++ends[{std::lround(1e4 * end.x()), std::lround(1e4 * end.y())}];
      }
    }
    for (const auto& [end, count] : ends) {
      EXPECT_EQ(count % 2, 0) << "slice " << slice;
    }
  }
  EXPECT_FALSE(slices.outline(20).empty());
  EXPECT_TRUE(slices.outline(-1).empty());
  EXPECT_TRUE(slices.outline(60).empty());
}

}  // namespace
}  // namespace glisson
