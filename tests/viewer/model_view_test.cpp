// The 3D view: patient sides, transparency, the plane's two sides, handles under real mouse and key events.

#include "viewer/model_view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <algorithm>
#include <ctime>
#include <random>

#include "planning/resection/place_plane.h"
#include "tests/viewer/bodies.h"
#include "tests/viewer/colour_difference.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/plane_handles.h"
#include "viewer/resectogram.h"

namespace glisson {
namespace {

using test::asymmetricModel;
using test::isWarm;

/// Mean position (0..1, from left and from top) of the pixels that satisfy a rule, and their number.
struct Spot {
  double x = 0;
  double y = 0;
  int pixels = 0;
};

template <typename Rule>
Spot spotOf(const QImage& image, Rule&& rule) {
  Spot spot;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (x < image.width() / 6 && y > image.height() * 3 / 4) {
        continue;  // the orientation cube
      }
      if (rule(image.pixelColor(x, y))) {
        spot.x += (x + 0.5) / image.width();
        spot.y += (y + 0.5) / image.height();
        ++spot.pixels;
      }
    }
  }
  if (spot.pixels > 0) {
    spot.x /= spot.pixels;
    spot.y /= spot.pixels;
  }
  return spot;
}

bool isGreen(const QColor& c) { return c.green() > 80 && c.red() < c.green() / 2 && c.blue() < c.green() / 2; }
bool isBlue(const QColor& c) { return c.blue() > 80 && c.red() < c.blue() / 2 && c.green() < c.blue() / 2; }
class ModelViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view.resize(640, 480);
    view.setModel(asymmetricModel());
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  }

  QImage shown(const char* name) { return test::kept(view.picture(), name); }

  void mouse(QEvent::Type type, const Pixel& at, Qt::MouseButton button) {
    const QPointF pixel(at.x(), at.y());
    const Qt::MouseButtons held =
        type == QEvent::MouseButtonRelease ? Qt::MouseButtons(Qt::NoButton) : Qt::MouseButtons(Qt::LeftButton);
    QMouseEvent event(type, pixel, view.mapToGlobal(pixel), button, held, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  }

  void drag(const Pixel& from, const Pixel& to) {
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    for (int step = 1; step <= 4; ++step) {
      mouse(QEvent::MouseMove, from + step * (to - from) / 4, Qt::NoButton);
    }
    mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton);
  }

  ModelView view;
};

TEST_F(ModelViewTest, FromAnteriorThePatientsLeftIsOnThePicturesRightAndTheHeadIsUp) {
  view.setStandardView(ModelView::StandardView::Anterior);
  const QImage image = shown("anterior");
  const Spot left = spotOf(image, isGreen);
  const Spot front = spotOf(image, isBlue);
  ASSERT_GT(left.pixels, 100);
  ASSERT_GT(front.pixels, 100);
  EXPECT_GT(left.x, 0.6);
  EXPECT_LT(left.y, 0.45);
  EXPECT_NEAR(front.x, 0.5, 0.08);
  EXPECT_GT(front.y, 0.55);
}

TEST_F(ModelViewTest, FromTheLeftTheFrontIsOnThePicturesLeft) {
  view.setStandardView(ModelView::StandardView::Left);
  const QImage image = shown("left");
  ASSERT_GT(spotOf(image, isBlue).pixels, 100);
  EXPECT_LT(spotOf(image, isBlue).x, 0.45);
  EXPECT_GT(spotOf(image, isBlue).y, 0.55);
  EXPECT_NEAR(spotOf(image, isGreen).x, 0.5, 0.1);
}

TEST_F(ModelViewTest, FromSuperiorTheFrontIsUpAndThePatientsLeftOnThePicturesLeft) {
  view.setStandardView(ModelView::StandardView::Superior);
  const QImage image = shown("superior");
  ASSERT_GT(spotOf(image, isGreen).pixels, 100);
  EXPECT_LT(spotOf(image, isGreen).x, 0.4);
  EXPECT_LT(spotOf(image, isBlue).y, 0.4);
}

TEST_F(ModelViewTest, KeysChooseTheStandardViews) {
  QTest::keyClick(&view, Qt::Key_3);
  EXPECT_TRUE(view.viewDirection().isApprox(-Vec3::UnitX(), 1e-9));
  QTest::keyClick(&view, Qt::Key_7);
  EXPECT_TRUE(view.viewDirection().isApprox(-Vec3::UnitZ(), 1e-9));
  EXPECT_TRUE(view.viewUp().isApprox(-Vec3::UnitY(), 1e-9));
  QTest::keyClick(&view, Qt::Key_1);
  EXPECT_TRUE(view.viewDirection().isApprox(Vec3::UnitY(), 1e-9));
}

TEST_F(ModelViewTest, ATumourInsideTheTranslucentLiverIsSeenAndInsideAnOpaqueOneIsNot) {
  for (const double opacity : {0.35, 1.0}) {
    auto model = std::make_shared<LiverModel>();
    model->structures.push_back(test::structure("parenchyma", StructureKind::Liver, test::kLiverColour, opacity,
                                                test::sphere({0, 0, 0}, test::kLiverRadii)));
    model->structures.push_back(
        test::structure("tumour_01", StructureKind::Tumour, {0, 255, 0}, 1.0, test::sphere({0, 0, 0}, {20, 20, 20})));
    view.setModel(model);
    const QColor centre = shown("inside").pixelColor(320, 240);
    if (opacity < 1) {
      EXPECT_GT(centre.green(), centre.red()) << opacity;
    } else {
      EXPECT_LT(centre.green(), centre.red()) << opacity;
    }
  }
}

TEST_F(ModelViewTest, AnOpenSurfaceIsSeenFromItsInsideAndAClosedOneFromOutsideAlone) {
  SurfaceMesh bowl = test::sphere({0, 0, 0}, {60, 60, 60});
  std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.vertices[t[0]].y() < 0; });  // open to the front
  for (const bool open : {true, false}) {
    auto model = std::make_shared<LiverModel>();
    Structure structure = test::structure("artery", StructureKind::Artery, {0, 0, 255}, 1.0, bowl);
    auto made = std::make_shared<Reconstruction>(*structure.reconstruction);
    made->defects = open ? bowl.defects() : MeshDefects();
    ASSERT_EQ(made->defects.openEdges > 0, open);
    structure.reconstruction = made;
    model->structures.push_back(structure);
    view.setModel(model);
    EXPECT_EQ(isBlue(shown(open ? "bowl" : "bowl_called_closed").pixelColor(320, 240)), open);
  }
}

TEST_F(ModelViewTest, NoPixelLetsTheDesktopShineThrough) {
  for (const QImage& image : {view.picture(), view.nextFrame()}) {
    ASSERT_EQ(image.format(), QImage::Format_RGB32);
    int clear = 0;
    for (int y = 0; y < image.height(); ++y) {
      const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
      clear += static_cast<int>(std::count_if(row, row + image.width(), [](QRgb pixel) { return qAlpha(pixel) != 255; }));
    }
    EXPECT_EQ(clear, 0);
  }
  EXPECT_LE(view.window()->windowHandle()->format().alphaBufferSize(), 0);
}

TEST_F(ModelViewTest, AHiddenStructureIsNotDrawn) {
  auto model = std::make_shared<LiverModel>(*asymmetricModel());
  model->structures[1].visible = false;
  view.setModel(model);
  EXPECT_EQ(spotOf(shown("hidden"), isGreen).pixels, 0);
}

TEST_F(ModelViewTest, WithoutAModelNothingIsDrawn) {
  view.setModel(nullptr);
  const QImage image = shown("empty");
  EXPECT_EQ(spotOf(image, isWarm).pixels + spotOf(image, isGreen).pixels + spotOf(image, isBlue).pixels, 0);
}

TEST_F(ModelViewTest, TheResectedSideIsPaleAndTheRemnantKeepsItsColour) {
  const QImage before = shown("uncut");
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});  // resected: the patient's left, on the picture's right
  const QImage image = shown("cut");
  const auto middle = [](const QImage& picture, double x) {
    return picture.pixelColor(static_cast<int>(x * picture.width()), picture.height() * 11 / 20);
  };
  EXPECT_TRUE(isWarm(middle(before, 0.7)));
  EXPECT_TRUE(isWarm(middle(image, 0.3)));
  EXPECT_FALSE(isWarm(middle(image, 0.7)));
  EXPECT_GT(middle(image, 0.7).blue(), middle(image, 0.7).red());
}

TEST_F(ModelViewTest, ASurfaceInsideAnotherResectionIsNotDrawn) {
  view.setStandardView(ModelView::StandardView::Left);
  view.setHandlesShown(false);
  const HalfSpace left{Vec3::Zero(), Vec3::UnitX()};
  const HalfSpace up{Vec3(0, 0, 10), Vec3::UnitZ()};
  const auto pictures = [&](std::vector<ResectionPlane> first, std::vector<ResectionPlane> second, const char* name) {
    ResectionPlan plan;
    plan.resections = {{"Resection 1", std::move(first)}, {"Resection 2", std::move(second)}};
    view.setPlan(plan, {0, 0});
    const QImage picture = shown(name);
    return std::pair(picture, view.findChild<Resectogram*>("resectogram")->grab().toImage());
  };
  const auto differing = [](const QImage& a, const QImage& b) {
    int pixels = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const QColor p = a.pixelColor(x, y);
        const QColor q = b.pixelColor(x, y);
        const int most = std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
        pixels += most > 12 ? 1 : 0;
      }
    }
    return pixels;
  };
  // The same region twice: overlapping, and as two resections side by side, whose common face is no surface either.
  const auto [overlapping, mapOfOverlapping] = pictures({left}, {up}, "overlapping_resections");
  const auto [beside, mapOfBeside] = pictures({left, flipped(up)}, {up}, "resections_side_by_side");
  EXPECT_LT(differing(overlapping, beside), 2000) << "the translucent shells are blended in another order";
  EXPECT_LT(differing(mapOfOverlapping, mapOfBeside), 800) << "the borders' anti-aliasing";
  // What stands against it: the whole face of the first one.
  ResectionPlan alone;
  alone.resections = {{"Resection 1", {left}}};
  view.setPlan(alone, {0, 0});
  const QImage whole = shown("one_resection");
  EXPECT_GT(differing(view.findChild<Resectogram*>("resectogram")->grab().toImage(), mapOfOverlapping), 4000);
  EXPECT_GT(differing(whole, overlapping), 10000);
}

TEST_F(ModelViewTest, ThePlaneIsDrawnOnlyInsideTheLiver) {
  view.setStandardView(ModelView::StandardView::Left);
  const QImage before = shown("face_before");
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});
  const QImage after = shown("face_on");
  const auto changed = [&](double mmBack, double mmUp) {
    const Pixel at = view.camera().toPixel(Vec3(0, mmBack, mmUp));
    const QPoint pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    return before.pixelColor(pixel) != after.pixelColor(pixel);
  };
  EXPECT_TRUE(changed(30, 5));
  EXPECT_FALSE(changed(85, 5));
  EXPECT_FALSE(changed(30, 75));
}

TEST_F(ModelViewTest, DraggingTheArrowToTheRightMovesThePlaneToThePatientsLeftInOneStep) {
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  QSignalSpy dragged(&view, &ModelView::planeDragged);
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  const HandleLayout handles = *view.handles();
  const Pixel tip = view.camera().toPixel(handles.arrowTip);
  drag(tip, tip + Pixel(40, 0));
  EXPECT_EQ(started.count(), 1);
  EXPECT_EQ(dragged.count(), 4);
  EXPECT_EQ(finished.count(), 1);
  ASSERT_TRUE(view.plane());
  // Off the picture's middle perspective shortens a little: within 10 %.
  EXPECT_NEAR(view.plane()->origin.x(), 40 * handles.mmPerPixel, 0.1 * 40 * handles.mmPerPixel);
  EXPECT_TRUE(view.plane()->normal.isApprox(Vec3::UnitX(), 1e-12));
  drag(view.camera().toPixel(view.handles()->arrowTip), tip);
  EXPECT_NEAR(view.plane()->origin.x(), 0.0, 0.6);
}

TEST_F(ModelViewTest, DraggingABorderHandleTiltsThePlaneAboutItsCentre) {
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});
  const HandleLayout handles = *view.handles();
  const Pixel top = view.camera().toPixel(handles.tilts[1]);
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  drag(top, top + Pixel(30, 0));
  EXPECT_EQ(finished.count(), 1);
  const HalfSpace tilted = *view.plane();
  // The upper border went to the patient's left: the normal turns to the feet.
  EXPECT_LT(tilted.normal.z(), -0.05);
  EXPECT_NEAR(tilted.normal.y(), 0.0, 0.02);
  EXPECT_NEAR(tilted.normal.norm(), 1.0, 1e-12);
  EXPECT_NEAR(tilted.normal.dot(handles.anchor - tilted.origin), 0.0, 1e-9);
}

TEST_F(ModelViewTest, TheSpinHandleTurnsABentPlaneAboutItsNormalAndOfAFlatOneTheHandles) {
  const HalfSpace facing{Vec3::Zero(), -view.viewDirection()};
  view.setPlane(facing);
  const auto quarter = [&] {  // with the hands of a clock, as seen
    const HandleLayout handles = *view.handles();
    ASSERT_TRUE(handles.spinShown);
    const Pixel centre = view.camera().toPixel(handles.anchor);
    const Pixel from = view.camera().toPixel(handles.spin) - centre;
    drag(centre + from, centre + Pixel(-from.y(), from.x()));
  };
  const auto angleOf = [&](const Vec3& from, const Vec3& to) {
    return std::atan2(from.cross(to).dot(facing.normal), from.dot(to));
  };
  const Vec3 right = view.handles()->tilts[0];
  quarter();
  EXPECT_EQ(view.plane(), ResectionPlane(facing));
  EXPECT_NEAR(angleOf(right, view.handles()->tilts[0]), -std::numbers::pi / 2, 0.01);

  view.setPlane(std::nullopt);
  view.setPlane(facing);
  EXPECT_EQ(view.handles()->tilts[0], right) << "another plane";
  const auto cubePixels = [&] {
    const QImage image = view.picture();
    const Pixel cube = view.camera().toPixel(view.handles()->spin);
    const QColor colour = image.pixelColor(static_cast<int>(cube.x()), static_cast<int>(cube.y()));
    return colour.red() > 150 && colour.blue() < 120 && colour.red() > colour.blue() + 80;
  };
  EXPECT_TRUE(cubePixels());
  view.setHandlesShown(false);
  EXPECT_FALSE(cubePixels());
  view.setHandlesShown(true);

  const Bend bend = flatBend(facing, 60);
  view.setPlane(ResectionPlane(facing, bend));
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  quarter();
  EXPECT_EQ(finished.count(), 1);
  EXPECT_EQ(view.plane()->normal, facing.normal);
  EXPECT_EQ(view.plane()->bend->heightsMm, bend.heightsMm);
  EXPECT_NEAR(angleOf(bend.u, view.plane()->bend->u), -std::numbers::pi / 2, 0.01);
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_NEAR(angleOf(bend.u, view.plane()->bend->u), -std::numbers::pi / 2 + std::numbers::pi / 180, 0.01);
  EXPECT_EQ(finished.count(), 2);
}

TEST_F(ModelViewTest, EscapeTakesADragBack) {
  const HalfSpace start{Vec3(3, 0, 0), Vec3::UnitX()};
  view.setPlane(start);
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  const Pixel tip = view.camera().toPixel(view.handles()->arrowTip);
  mouse(QEvent::MouseButtonPress, tip, Qt::LeftButton);
  mouse(QEvent::MouseMove, tip + Pixel(50, 0), Qt::NoButton);
  EXPECT_GT(view.plane()->origin.x(), 10);
  QTest::keyClick(&view, Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, tip + Pixel(50, 0), Qt::LeftButton);
  EXPECT_EQ(finished.count(), 1);
  EXPECT_TRUE(view.plane()->origin.isApprox(start.origin, 1e-12));
}

TEST_F(ModelViewTest, AwayFromTheHandlesTheLeftButtonTurnsTheCameraAndLeavesThePlane) {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  view.setPlane(plane);
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  const Vec3 before = view.viewDirection();
  drag(Pixel(500, 400), Pixel(560, 380));
  EXPECT_EQ(started.count(), 0);
  EXPECT_TRUE(view.plane()->origin.isApprox(plane.origin) || view.plane()->origin.norm() < 1e-12);
  EXPECT_LT(view.viewDirection().dot(before), 0.999);
}

TEST_F(ModelViewTest, KeysMoveThePlaneByMillimetresAndTiltItByDegreesOneStepEach) {
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_NEAR(view.plane()->origin.x(), 1.0, 1e-12);
  QTest::keyClick(&view, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_NEAR(view.plane()->origin.x(), 0.9, 1e-12);
  QTest::keyClick(&view, Qt::Key_Minus);
  EXPECT_NEAR(view.plane()->origin.x(), -0.1, 1e-12);
  QTest::keyClick(&view, Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(view.plane()->normal.dot(Vec3::UnitX()), std::cos(std::numbers::pi / 180), 1e-9);
  QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(view.plane()->normal.dot(Vec3::UnitX()), 1.0, 1e-9);
  QTest::keyClick(&view, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_NEAR(std::abs(view.plane()->normal.z()), std::sin(std::numbers::pi / 180), 1e-9);
  EXPECT_EQ(started.count(), 6);
  EXPECT_EQ(finished.count(), 6);
}

TEST_F(ModelViewTest, TheFirstPlaneFromTheCameraIsSeenEdgeOnWithTheResectedSideOnTheRight) {
  const HalfSpace plane = planeFromCamera(Vec3::Zero(), view.viewDirection(), view.viewUp());
  EXPECT_NEAR(plane.normal.dot(view.viewDirection()), 0.0, 1e-12);
  EXPECT_GT(view.camera().toPixel(plane.origin + 10 * plane.normal).x(), view.camera().toPixel(plane.origin).x());
}

TEST_F(ModelViewTest, AClickOnTheMapOfTheCutReachesNoHandleUnderItAndTheMapFoldsAway) {
  view.setPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()});
  (void)shown("map_of_the_cut");
  auto* map = view.findChild<Resectogram*>("resectogram");
  ASSERT_TRUE(map->isVisible());
  EXPECT_TRUE(view.mapShown());
  const Pose pose = view.pose();
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  const QPoint middle = map->rect().center();
  QTest::mousePress(map, Qt::LeftButton, {}, middle);
  QTest::mouseMove(map, middle + QPoint(20, 10));
  QTest::mouseRelease(map, Qt::LeftButton, {}, middle + QPoint(20, 10));
  EXPECT_TRUE(pose == view.pose()) << "nor does it turn the camera";
  EXPECT_EQ(started.count(), 0);

  QSignalSpy changed(&view, &ModelView::mapShownChanged);
  const QSize unfolded = map->size();
  QTest::mouseClick(map->findChild<QToolButton*>("foldMap"), Qt::LeftButton);
  EXPECT_FALSE(view.mapShown());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_LT(map->height(), unfolded.height() / 5);
  EXPECT_LT(map->width(), unfolded.width() / 2);
  EXPECT_EQ(map->geometry().bottomRight(), QPoint(view.width() - 7, view.height() - 7)) << "in its corner";
  QTest::mouseClick(map, Qt::LeftButton, {}, QPoint(3, 3));
  EXPECT_TRUE(view.mapShown());
  EXPECT_EQ(map->size(), unfolded);
  view.setMapShown(true);
  EXPECT_EQ(changed.count(), 2);
}

TEST_F(ModelViewTest, DoubleClickAsksForTheMaximisedView) {
  QSignalSpy asked(&view, &ModelView::maximiseRequested);
  QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, QPoint(600, 30));
  EXPECT_EQ(asked.count(), 1);
}

TEST_F(ModelViewTest, TheWheelComesNearer) {
  const double before = view.camera().mmPerPixel(Vec3::Zero());
  const QPointF at(320, 240);
  QWheelEvent event(at, view.mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &event);
  EXPECT_LT(view.camera().mmPerPixel(Vec3::Zero()), 0.95 * before);
}

TEST_F(ModelViewTest, FramesOfAHundredThousandTrianglesWhileThePlaneMovesAreDrawn) {
  view.resize(800, 600);
  const auto processorMs = [](std::clock_t since) { return 1000.0 * static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC; };
  std::clock_t start = std::clock();
  view.setModel(asymmetricModel(0.35, 160));
  const double uploadMs = processorMs(start);
  static_cast<void>(view.nextFrame());
  std::vector<double> frames;
  for (int n = 0; n < 15; ++n) {
    start = std::clock();
    view.setPlane(HalfSpace{Vec3(2.0 * n - 15, 0, 0), Vec3(1, 0.2, 0.1).normalized()});
    ASSERT_FALSE(view.nextFrame().isNull());
    frames.push_back(processorMs(start));
  }
  std::nth_element(frames.begin(), frames.begin() + 7, frames.end());
  RecordProperty("setModelMs", std::to_string(uploadMs));
  RecordProperty("movingFrameMs", std::to_string(frames[7]));
}

TEST(ModelViewPictureTest, AReportsPictureOfTilesIsThatOfTheWholeView) {
  const HalfSpace plane{Vec3(5, 0, 0), Vec3(1, 0.2, 0.1).normalized()};
  const auto prepare = [&](ModelView& view, const QSize& size) {
    view.resize(size);
    view.setModel(asymmetricModel());
    view.setPlane(plane);
    view.setHandlesShown(false);
  };
  ModelView tiled;
  prepare(tiled, QSize(160, 120));
  ModelView whole;
  prepare(whole, VtkWidget::kReportTiles * QSize(160, 120));
  for (const auto side : {ModelView::StandardView::Anterior, ModelView::StandardView::Left}) {
    tiled.setStandardView(side);
    whole.setStandardView(side);
    std::optional<QImage> picture;
    for (int turn = 0; turn < 30 && !picture; ++turn) {
      picture = tiled.reportPicture();
    }
    ASSERT_TRUE(picture);
    const QImage expected = whole.picture();
    ASSERT_EQ(picture->size(), expected.size());
    int different = 0;
    for (int y = 0; y < expected.height(); ++y) {
      for (int x = 0; x < expected.width(); ++x) {
        const QColor a = picture->pixelColor(x, y);
        const QColor b = expected.pixelColor(x, y);
        different += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) > 90 ? 1 : 0;
      }
    }
    EXPECT_LT(different, expected.width() * expected.height() / 200);
  }
}

TEST(ModelViewPictureTest, AViewThatWasNeverShownGivesItsPictureToo) {
  ModelView view;
  view.resize(640, 480);
  view.setModel(asymmetricModel());
  const QImage image = view.picture();
  ASSERT_FALSE(image.isNull());
  EXPECT_EQ(image.size(), QSize(640, 480));
  EXPECT_GT(spotOf(image, isGreen).pixels, 100);
  EXPECT_FALSE(view.isVisible());
}

TEST_F(ModelViewTest, APoseThatWasSetIsThePoseAndToldToNobody) {
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  const QSignalSpy moved(&view, &ModelView::cameraMoved);
  for (int n = 0; n < 100; ++n) {
    const Pose pose{.position = 300 * vector(), .focus = 30 * vector(), .up = vector().normalized()};
    view.setPose(pose);
    EXPECT_EQ(view.pose(), pose) << n;
  }
  EXPECT_EQ(moved.count(), 0);
  view.setStandardView(ModelView::StandardView::Left);
  EXPECT_EQ(moved.count(), 1);
}

TEST_F(ModelViewTest, AMovedWindowStillDraws) {
  QWidget other;
  other.resize(640, 480);
  view.setParent(&other);
  view.setGeometry(0, 0, 640, 480);
  view.show();
  other.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
  EXPECT_GT(spotOf(shown("moved"), isGreen).pixels, 100);
  view.setParent(nullptr);
}

}  // namespace
}  // namespace glisson
