// The view that compares surfaces: colours by error, one camera for two views, the line that swipes.

#include "viewer/surface_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include "tests/viewer/bodies.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/error_colours.h"
#include "viewer/swipe_divider.h"

namespace glisson {
namespace {

const Vec3 kRadii(60, 50, 40);

std::shared_ptr<const DisplayMesh> body(const Vec3& radii) {
  auto made = std::make_shared<Reconstruction>();
  made->mesh = test::sphere(Vec3::Zero(), radii);
  return makeDisplayMesh(made);
}

ShownSurface coloured(const std::shared_ptr<const DisplayMesh>& mesh, const std::function<double(const Vec3&)>& errorAt) {
  return {mesh, makeSurfaceErrors(*mesh, [&](std::span<const Vec3> points) {
            std::vector<double> values;
            for (const Vec3& point : points) {
              values.push_back(errorAt(point));
            }
            return values;
          })};
}

ShownSurface uniform(double errorMm) {
  return coloured(body(kRadii), [errorMm](const Vec3&) { return errorMm; });
}

bool isYellow(const QColor& c) { return c.red() > 110 && c.green() > 110 && c.blue() < c.red() / 2; }
bool isPurple(const QColor& c) { return c.blue() > c.green() + 20 && c.red() > c.green() + 10; }

class SurfaceViewTest : public testing::Test {
 protected:
  SurfaceView view;
  void SetUp() override {
    view.resize(640, 480);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  }
  QImage shown(const char* name) { return test::kept(view.picture(), name); }
};

double shareOf(const QImage& image, int fromX, int toX, bool (*rule)(const QColor&)) {
  int hits = 0;
  int all = 0;
  for (int y = image.height() / 3; y < 2 * image.height() / 3; ++y) {
    for (int x = fromX; x < toX; ++x) {
      hits += rule(image.pixelColor(x, y)) ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(hits) / all;
}

TEST_F(SurfaceViewTest, ColoursFollowTheScale) {
  view.setSurfaces(uniform(1.0));
  view.setScale(1.0);
  const QImage end = shown("surface_end_of_scale");
  EXPECT_GT(shareOf(end, 240, 400, isYellow), 0.9);
  view.setScale(100.0);
  EXPECT_GT(shareOf(shown("surface_start_of_scale"), 240, 400, isPurple), 0.9);
}

TEST_F(SurfaceViewTest, ErrorsAreOfTheirVertices) {
  // Large on the patient's left half, which is on the right of a view from anterior.
  view.setSurfaces(coloured(body(kRadii), [](const Vec3& at) { return at.x() > 0 ? 2.0 : 0.0; }));
  view.setScale(2.0);
  const QImage image = shown("surface_half");
  EXPECT_GT(shareOf(image, 360, 420, isYellow), 0.9);
  EXPECT_GT(shareOf(image, 220, 280, isPurple), 0.9);
}

TEST_F(SurfaceViewTest, TheLineStandsBetweenTheTwo) {
  view.setSurfaces(uniform(1.0), uniform(0.0));
  view.setScale(1.0);
  ASSERT_TRUE(view.swipes());
  view.setDivider(0.5);
  QImage image = shown("surface_swipe");
  EXPECT_GT(shareOf(image, 230, 310, isYellow), 0.9);
  EXPECT_LT(shareOf(image, 330, 410, isYellow), 0.01);
  EXPECT_GT(shareOf(image, 330, 410, isPurple), 0.9);
  view.setDivider(0.6);
  image = shown("surface_swipe_on");
  EXPECT_GT(shareOf(image, 330, 370, isYellow), 0.9) << "what was right of the line is left of it now";
  EXPECT_GT(shareOf(image, 392, 420, isPurple), 0.9);
}

TEST_F(SurfaceViewTest, TheLineIsDraggedAndMovedByKeys) {
  view.setSurfaces(uniform(1.0), uniform(0.0));
  auto* divider = view.findChild<SwipeDivider*>();
  ASSERT_NE(divider, nullptr);
  ASSERT_TRUE(divider->isVisible());
  view.setDivider(0.5);
  QTest::mousePress(divider, Qt::LeftButton, {}, QPoint(divider->width() / 2, 100));
  const QPointF to(divider->width() / 2.0 + 64, 100);
  QMouseEvent move(QEvent::MouseMove, to, divider->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(divider, &move);
  EXPECT_NEAR(view.divider(), 0.6, 0.01);
  const double before = view.divider();
  QTest::keyClick(divider, Qt::Key_Left);
  EXPECT_NEAR(view.divider(), before - 0.01, 1e-9);
  QTest::keyClick(divider, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(view.divider(), before + 0.09, 1e-9);
}

TEST_F(SurfaceViewTest, OneSurfaceAloneIsWholeAgain) {
  view.setScale(1.0);
  view.setSurfaces(uniform(1.0), uniform(0.0));
  view.setSurfaces(uniform(1.0));
  EXPECT_FALSE(view.swipes());
  EXPECT_FALSE(view.findChild<SwipeDivider*>()->isVisible());
  EXPECT_GT(shareOf(shown("surface_whole_again"), 330, 410, isYellow), 0.9);
}

TEST_F(SurfaceViewTest, WiresLeaveTheGroundVisible) {
  view.setScale(1.0);
  view.setSurfaces(uniform(1.0));
  const double solid = shareOf(shown("surface_solid"), 240, 400, isYellow);
  view.setWireframe(true);
  const double wires = shareOf(shown("surface_wires"), 240, 400, isYellow);
  EXPECT_GT(wires, 0.02);
  EXPECT_LT(wires, 0.7 * solid);
}

class LinkedViewsTest : public SurfaceViewTest {
 protected:
  SurfaceView other;
  void SetUp() override {
    SurfaceViewTest::SetUp();
    other.resize(400, 300);
    other.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
    SurfaceView::link(view, other);
    view.setSurfaces(uniform(1.0));
    other.setSurfaces(uniform(0.5));
  }
};

TEST_F(LinkedViewsTest, HaveOneCamera) {
  EXPECT_EQ(view.pose(), other.pose());
  QTest::keyClick(&view, Qt::Key_7);  // before either has drawn a frame
  EXPECT_NEAR(view.camera().forward.z(), -1, 1e-9) << "seen from above";
  EXPECT_EQ(view.pose(), other.pose());
  QTest::keyClick(&other, Qt::Key_3);
  EXPECT_NEAR(view.camera().forward.x(), -1, 1e-9) << "and back again";
  constexpr int kDrawnMs = 600;
  QTest::qWait(kDrawnMs);
  EXPECT_NEAR(view.camera().forward.x(), -1, 1e-9) << "frames change nothing";
  EXPECT_EQ(view.pose(), other.pose());
}

TEST_F(LinkedViewsTest, StayTogetherInEveryDragAndTheLastOneMovedIsFollowed) {
  for (int n = 0; n < 20; ++n) {
    SurfaceView& moved = n % 2 == 0 ? view : other;
    const Pose before = moved.pose();
    const QPoint to(150 + 7 * (n + 1), 120 + 3 * n);
    QTest::mousePress(&moved, Qt::LeftButton, {}, {150, 120});
    QTest::mouseMove(&moved, to);
    QTest::mouseRelease(&moved, Qt::LeftButton, {}, to);
    EXPECT_NE(moved.pose(), before) << n;
    EXPECT_EQ(view.pose(), other.pose()) << n;
  }
}

TEST_F(SurfaceViewTest, AnotherSurfaceKeepsTheCamera) {
  view.setSurfaces(uniform(1.0));
  QTest::keyClick(&view, Qt::Key_3);
  const Pose before = view.pose();
  view.setSurfaces(coloured(body(0.9 * kRadii), [](const Vec3&) { return 0.1; }));
  EXPECT_EQ(view.pose(), before);
}

TEST(ErrorColours, GrowLighterAllTheWay) {
  const auto lightness = [](const Rgb& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (int n = 0; n < 100; ++n) {
    EXPECT_LT(lightness(errorColour(n / 100.0)), lightness(errorColour((n + 1) / 100.0)) + 1e-9) << n;
  }
  EXPECT_EQ(errorColour(-1), errorColour(0));
  EXPECT_EQ(errorColour(7), errorColour(1));
}

TEST(ErrorColours, TheScaleEndsAtARoundNumberAboveTheWorst) {
  EXPECT_DOUBLE_EQ(errorScaleMm(0.0), 0.1);
  EXPECT_DOUBLE_EQ(errorScaleMm(0.13), 0.2);
  EXPECT_DOUBLE_EQ(errorScaleMm(0.2), 0.2);
  EXPECT_DOUBLE_EQ(errorScaleMm(1.3), 2.0);
  EXPECT_DOUBLE_EQ(errorScaleMm(4.2), 5.0);
  EXPECT_DOUBLE_EQ(errorScaleMm(6.0), 10.0);
}

}  // namespace
}  // namespace glisson
