// Outlines of compared surfaces: segments joined to lines, styles that differ without colour, letters.

#include "viewer/compared_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/viewer/bodies.h"
#include "viewer/mesh_slices.h"
#include "viewer/slice_view.h"

namespace glisson {
namespace {

using Segments = std::vector<std::pair<SlicePoint, SlicePoint>>;

/// A ball of 20 mm in the middle of an oblique grid of 1 mm voxels, cut in its slice 30.
Segments ballOutline() {
  auto ball = std::make_shared<Reconstruction>();
  ball->mesh = test::sphere(Vec3(30, 30, 30.3), Vec3::Constant(20), 60);
  ImageGeometry grid;
  grid.size = {61, 61, 61};
  return MeshSlices(ball, SliceGeometry(grid, SliceAxis::Axial)).outline(30);
}

std::size_t pointsOf(const std::vector<std::vector<SlicePoint>>& lines) {
  std::size_t points = 0;
  for (const auto& line : lines) {
    points += line.size();
  }
  return points;
}

TEST(ComparedOutlines, ASurfacesOutlineIsOneClosedLineInWhateverOrderItsSegmentsCome) {
  Segments segments = ballOutline();
  ASSERT_GT(segments.size(), 100U);
  std::mt19937 random(7);
  for (int trial = 0; trial < 5; ++trial) {
    const auto lines = chained(segments);
    ASSERT_EQ(lines.size(), 1U) << trial;
    EXPECT_EQ(lines[0].front(), lines[0].back());
    EXPECT_EQ(lines[0].size(), segments.size() + 1);
    std::ranges::shuffle(segments, random);
    std::swap(segments.front().first, segments.front().second);
  }
}

TEST(ComparedOutlines, LinesThatAreApartStayApartAndNothingIsLost) {
  Segments segments{{{0, 0}, {1, 0}}, {{2, 0}, {1, 0}}, {{5, 5}, {6, 5}}, {{0, 0}, {0, 1}}};
  const auto lines = chained(segments);
  EXPECT_EQ(lines.size(), 2U);
  EXPECT_EQ(pointsOf(lines), segments.size() + lines.size());
  EXPECT_TRUE(chained({}).empty());
}

/// Pixels of a colour along the ball's outline.
int drawnPixels(std::size_t number, const QString& badge = {}) {
  QImage image(400, 400, QImage::Format_RGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  QTransform toWidget;
  toWidget.scale(6, 6);
  drawComparedOutline(painter, toWidget, ballOutline(), number, Qt::magenta, badge);
  painter.end();
  int drawn = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      drawn += image.pixelColor(x, y) == QColor(Qt::magenta) ? 1 : 0;
    }
  }
  return drawn;
}

TEST(ComparedOutlines, DifferWithoutColour) {
  const int solid = drawnPixels(0);
  EXPECT_GT(solid, 500);
  EXPECT_LT(drawnPixels(1), 0.8 * solid) << "dashes leave gaps";
  EXPECT_GT(drawnPixels(1), 0.3 * solid);
  EXPECT_LT(drawnPixels(2), drawnPixels(1));
  EXPECT_EQ(comparedPen(0, Qt::red).style(), Qt::SolidLine);
  EXPECT_GT(drawnPixels(0, "A"), solid + 60) << "its letter stands at the line";
}

}  // namespace
}  // namespace glisson
