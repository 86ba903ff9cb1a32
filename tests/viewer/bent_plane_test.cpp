// Bent planes in the views: sides coloured right, control points dragged, curves in the slices, the fill of the section.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/viewer/bodies.h"
#include "tests/viewer/colour_difference.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/bend_handles.h"
#include "viewer/model_view.h"
#include "viewer/slice_curve.h"
#include "viewer/slice_view.h"

namespace glisson {
namespace {

using test::isWarm;

/// Through the origin, resected to the patient's left; towards the head bowed 40 mm to the right, towards the feet to the left.
ResectionPlane steep() {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  ResectionPlane bent(plane, flatBend(plane, 60));
  EXPECT_TRUE(bent.normal.cross(bent.bend->u).isApprox(Vec3::UnitZ(), 1e-12));
  for (std::size_t n = 0; n < 16; ++n) {
    bent.bend->heightsMm[n] = n < 8 ? 40 : -40;
  }
  return bent;
}

std::shared_ptr<LiverModel> liverOf(double opacity) {
  auto model = std::make_shared<LiverModel>();
  model->structures.push_back(test::structure("parenchyma", StructureKind::Liver, test::kLiverColour, opacity,
                                              test::sphere({0, 0, 0}, test::kLiverRadii, 40)));
  return model;
}

class BentViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view.resize(640, 480);
    view.setModel(liverOf(1.0));
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  }

  QImage shown(const char* name) { return test::kept(view.picture(), name); }

  /// The liver's front at this place, as seen from anterior.
  [[nodiscard]] QColor frontAt(const QImage& image, double x, double z) const {
    const Vec3& r = test::kLiverRadii;
    const double y = -r.y() * std::sqrt(1 - x * x / (r.x() * r.x()) - z * z / (r.z() * r.z()));
    const Pixel at = view.camera().toPixel(Vec3(x, y, z));
    return image.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
  }

  void mouse(QEvent::Type type, const Pixel& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF pixel(at.x(), at.y());
    const Qt::MouseButtons held =
        type == QEvent::MouseButtonRelease ? Qt::MouseButtons(Qt::NoButton) : Qt::MouseButtons(Qt::LeftButton);
    QMouseEvent event(type, pixel, view.mapToGlobal(pixel), button, held, modifiers);
    QApplication::sendEvent(&view, &event);
  }
  void drag(const Pixel& from, const Pixel& to, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, modifiers);
    for (int step = 1; step <= 4; ++step) {
      mouse(QEvent::MouseMove, from + step * (to - from) / 4, Qt::NoButton, modifiers);
    }
    mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton, modifiers);
  }

  ModelView view;
};

TEST_F(BentViewTest, SidesAreColouredRightOnBothSidesOfAStrongBend) {
  view.setHandlesShown(false);
  const ResectionPlane plane = steep();
  view.setPlane(plane);
  const BentSurface surface(plane);
  for (const double opacity : {1.0, 0.6}) {
    view.setModel(liverOf(opacity));
    const QImage image = shown(opacity < 1 ? "bent_translucent" : "bent_opaque");
    int wrong = 0;
    int looked = 0;
    for (double x = -60; x <= 60; x += 10) {
      for (double z = -25; z <= 25; z += 10) {
        const Vec3& r = test::kLiverRadii;
        const double y = -r.y() * std::sqrt(1 - x * x / (r.x() * r.x()) - z * z / (r.z() * r.z()));
        const double above = surface.above(Vec3(x, y, z));
        // Behind translucent parenchyma the other side shines through: only what is far from the surface is told.
        if (std::abs(above) < (opacity < 1 ? 30 : 6)) {
          continue;
        }
        ++looked;
        wrong += isWarm(frontAt(image, x, z)) == (above > 0) ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << opacity;
    EXPECT_GT(looked, 15);
  }
  EXPECT_TRUE(isWarm(frontAt(shown("bent_feet"), 15, -25))) << "flat it would be resected";
  EXPECT_FALSE(isWarm(frontAt(shown("bent_head"), -15, 25))) << "flat it would be remnant";
}

TEST_F(BentViewTest, FlatAgainTheSidesAreThePlanesAndBentAgainTheSurfaces) {
  view.setHandlesShown(false);
  for (int turn = 0; turn < 2; ++turn) {
    view.setPlane(steep());
    EXPECT_TRUE(isWarm(frontAt(shown("again_bent"), 15, -25)));
    view.setPlane(ResectionPlane(HalfSpace{Vec3::Zero(), Vec3::UnitX()}));
    const QImage flat = shown("again_flat");
    EXPECT_FALSE(isWarm(frontAt(flat, 15, -25)));
    EXPECT_TRUE(isWarm(frontAt(flat, -15, 25)));
  }
}

TEST_F(BentViewTest, MovingAPlaneTakesItsBendAlong) {
  view.setPlane(steep());
  const Pixel tip = view.camera().toPixel(view.handles()->arrowTip);
  drag(tip, tip + Pixel(30, 0));
  ASSERT_TRUE(view.plane()->bend);
  EXPECT_EQ(view.plane()->bend, steep().bend);
  EXPECT_GT(view.plane()->origin.x(), 5);
}

TEST_F(BentViewTest, ADraggedControlPointMovesAlongTheNormalInOneStep) {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  view.setPlane(ResectionPlane(plane, flatBend(plane, 45)));
  view.setBending(true, false);
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  QSignalSpy dragged(&view, &ModelView::planeDragged);
  QSignalSpy finished(&view, &ModelView::planeDragFinished);
  QSignalSpy chosen(&view, &ModelView::controlPointChosen);
  // Seen from anterior the plane is edge-on: of four points behind each other the nearest takes the mouse.
  const Pixel at = view.camera().toPixel(controlPoint(*view.plane(), 4));
  const double mm = 30 * view.camera().mmPerPixel(controlPoint(*view.plane(), 4));
  drag(at, at + Pixel(30, 0));
  EXPECT_EQ(started.count(), 1);
  EXPECT_EQ(dragged.count(), 4);
  EXPECT_EQ(finished.count(), 1);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 4);
  const auto heights = view.plane()->bend->heightsMm;
  EXPECT_NEAR(heights[4], mm, 0.15 * mm);
  EXPECT_EQ(std::count(heights.begin(), heights.end(), 0.0), 15);
  EXPECT_EQ(view.plane()->origin, plane.origin);
  EXPECT_EQ(view.plane()->normal, plane.normal);
  const double before = heights[4];
  QTest::keyClick(&view, Qt::Key_PageDown);
  EXPECT_NEAR(view.plane()->bend->heightsMm[4], before - 1, 1e-12) << "keys move the point dragged last";
  EXPECT_EQ(view.plane()->origin, plane.origin);
  view.chooseControlPoint(9);
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_EQ(view.plane()->bend->heightsMm[9], 1) << "or the one chosen";
}

TEST_F(BentViewTest, ControlPointsAreSeenWhileBendingAndTheSurfaceFollowsThem) {
  const auto isControl = [](const QColor& c) { return c.blue() > 150 && c.green() > 130 && c.red() < 110; };
  const auto count = [&](const QImage& image) {
    int pixels = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        pixels += isControl(image.pixelColor(x, y)) ? 1 : 0;
      }
    }
    return pixels;
  };
  view.setModel(liverOf(0.4));
  view.setPlane(steep());
  view.setPose({Vec3(330, -260, 160), Vec3::Zero(), Vec3::UnitZ()});
  EXPECT_EQ(count(shown("bent_without_points")), 0);
  view.setBending(true, false);
  EXPECT_GT(count(shown("bent_with_points")), 16 * 20);
}

TEST_F(BentViewTest, WithShiftOrByChoiceTheGroupMovesAndEscapeTakesItBack) {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  const ResectionPlane start(plane, flatBend(plane, 45));
  view.setPlane(start);
  view.setBending(true, false);
  const Pixel corner = view.camera().toPixel(controlPoint(start, 0));
  drag(corner, corner + Pixel(20, 0), Qt::ShiftModifier);
  const auto corners = view.plane()->bend->heightsMm;
  EXPECT_GT(corners[0], 1);
  for (std::size_t n = 0; n < 16; ++n) {
    EXPECT_EQ(corners[n], groupOf(0)[n] ? corners[0] : 0.0);
  }
  view.setBending(true, true);
  const Pixel edge = view.camera().toPixel(controlPoint(*view.plane(), 4));
  mouse(QEvent::MouseButtonPress, edge, Qt::LeftButton);
  mouse(QEvent::MouseMove, edge + Pixel(-25, 0), Qt::NoButton);
  EXPECT_LT(view.plane()->bend->heightsMm[14], -1);
  QTest::keyClick(&view, Qt::Key_Escape);
  mouse(QEvent::MouseButtonRelease, edge, Qt::LeftButton);
  EXPECT_EQ(view.plane()->bend->heightsMm, corners);
}

TEST_F(BentViewTest, WithoutBendingAControlPointIsNoHandle) {
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  view.setPlane(ResectionPlane(plane, flatBend(plane, 45)));
  QSignalSpy started(&view, &ModelView::planeDragStarted);
  const Pixel at = view.camera().toPixel(controlPoint(*view.plane(), 4));
  drag(at, at + Pixel(30, 0));
  EXPECT_EQ(started.count(), 0);
}

TEST(BentSection, LoopsLieOnTheSurfaceAndTheFillHasItsArea) {
  const SurfaceMesh ball = test::sphere({0, 0, 0}, {40, 40, 40}, 60);
  const HalfSpace plane{Vec3(0, 0, 5), Vec3::UnitZ()};
  ResectionPlane bent(plane, flatBend(plane, 50));
  for (std::size_t n = 0; n < 16; ++n) {
    bent.bend->heightsMm[n] = groupOf(5)[n] ? 15 : 0;
  }
  const BentSurface surface(bent);
  const std::vector<Loop> loops = sectionLoops(ball, bent);
  ASSERT_EQ(loops.size(), 1U);
  for (const Vec3& p : loops[0]) {
    EXPECT_NEAR(surface.above(p), 0, 0.05);
    EXPECT_NEAR(p.norm(), 40, 0.1);
  }
  const SurfaceMesh fill = filled(loops, surface, 3);
  double shadow = 0;
  for (const Triangle& t : fill.triangles) {
    const auto& v = fill.vertices;
    const double twice = (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).dot(plane.normal);
    EXPECT_GT(twice, 0) << "it faces the resected side";
    shadow += 0.5 * twice;
    EXPECT_NEAR(surface.above((v[t[0]] + v[t[1]] + v[t[2]]) / 3), 0, 0.1);
  }
  double expected = 0;  // of the loop's shadow
  for (std::size_t n = 0; n < loops[0].size(); ++n) {
    expected += 0.5 * loops[0][n].cross(loops[0][(n + 1) % loops[0].size()]).dot(plane.normal);
  }
  EXPECT_NEAR(shadow, std::abs(expected), 1e-6 * shadow);
  for (const auto& [from, to] : gridLines(loops, surface, 10)) {
    EXPECT_NEAR(surface.above(from), 0, 1e-9);
    EXPECT_LE((to - from).norm(), 6);
  }
}

TEST(BentSection, ThroughVerticesOfTheMeshItIsFilledOrEmptyAndNeverWrong) {
  // Flat bends through the poles, where many edges meet the surface in one place.
  const SurfaceMesh ball = test::sphere({0, 0, 0}, {90, 60, 50}, 24);
  for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitX())}) {
    const HalfSpace plane{Vec3::Zero(), normal};
    const ResectionPlane bent(plane, flatBend(plane, 45));
    const std::vector<Loop> loops = sectionLoops(ball, bent);
    const SurfaceMesh fill = filled(loops, BentSurface(bent), 3);
    const double whole = std::numbers::pi * 90 * 60 * 50 / normal.cwiseAbs().dot(Vec3(90, 60, 50));
    if (!fill.empty()) {
      EXPECT_NEAR(areaMm2(fill), whole, 0.02 * whole);
    }
  }
}

TEST(BentSection, HolesStayOpen) {
  SurfaceMesh ring = test::sphere({0, 0, 0}, {40, 40, 40}, 30);
  const SurfaceMesh inner = test::sphere({0, 0, 0}, {15, 15, 15}, 30);
  const auto first = static_cast<std::uint32_t>(ring.vertices.size());
  ring.vertices.insert(ring.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const Triangle& t : inner.triangles) {
    ring.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  }
  const HalfSpace plane{Vec3(0.1, 0.2, 0.3), Vec3(1, 2, 2) / 3};
  ResectionPlane bent(plane, flatBend(plane, 50));
  bent.bend->heightsMm[5] = 8;
  const SurfaceMesh fill = filled(sectionLoops(ring, bent), BentSurface(bent), 3);
  double shadow = 0;
  for (const Triangle& t : fill.triangles) {
    const auto& v = fill.vertices;
    shadow += 0.5 * (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).dot(plane.normal);
  }
  EXPECT_NEAR(shadow, std::numbers::pi * (40 * 40 - 15 * 15), 0.03 * shadow);
}

ImageGeometry gridAround(const Mat3& direction) {
  ImageGeometry g;
  g.size = {60, 50, 40};
  g.spacing = Vec3(1.5, 1.5, 2.5);
  g.direction = direction;
  g.origin = -(direction * (0.5 * g.spacing.cwiseProduct(Vec3(59, 49, 39))));
  return g;
}

TEST(SliceCurve, LiesOnTheSurfaceWithTheResectedSideOnItsRight) {
  const Mat3 oblique = Eigen::AngleAxisd(0.3, Vec3(1, 2, -1).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  for (const Mat3& direction : {Mat3(Mat3::Identity()), oblique}) {
    for (const SliceAxis axis : {SliceAxis::Axial, SliceAxis::Coronal, SliceAxis::Sagittal}) {
      const SliceGeometry geometry(gridAround(direction), axis);
      const HalfSpace plane{Vec3(2, 3, 1), Vec3(0.5, -0.7, 0.4).normalized()};
      ResectionPlane bent(plane, flatBend(plane, 50));
      bent.bend->heightsMm = {5, -9, 12, 3, 0, 20, -15, 4, 8, -20, 10, -3, 2, 9, -6, 7};
      const BentSurface surface(bent);
      const int slice = geometry.sliceOf(Vec3::Zero());
      const auto curves = slicesCurves(geometry, slice, bent);
      ASSERT_FALSE(curves.empty());
      for (const auto& curve : curves) {
        ASSERT_GE(curve.size(), 2U);
        for (std::size_t n = 0; n + 1 < curve.size(); ++n) {
          EXPECT_NEAR(surface.above(geometry.toWorld(curve[n], slice)), 0, 0.1);
          const SlicePoint along = curve[n + 1] - curve[n];
          if (along.norm() > 0.05) {
            const SlicePoint right = SlicePoint(-along.y(), along.x()).normalized();
            EXPECT_GT(surface.above(geometry.toWorld(0.5 * (curve[n] + curve[n + 1]) + 0.5 * right, slice)), 0);
          }
        }
      }
    }
  }
}

TEST(SliceCurve, OfABumpIsClosed) {
  const SliceGeometry geometry(gridAround(Mat3::Identity()), SliceAxis::Axial);
  const HalfSpace plane{Vec3(0, 0, -10), Vec3::UnitZ()};
  ResectionPlane bent(plane, flatBend(plane, 30));
  for (std::size_t n = 0; n < 16; ++n) {
    bent.bend->heightsMm[n] = groupOf(5)[n] ? 40 : 0;
  }
  const auto curves = slicesCurves(geometry, geometry.sliceOf(Vec3(0, 0, 0)), bent);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].front(), curves[0].back());
}

TEST(SliceCurve, OfATipOfTwoMillimetresIsDrawnWhereverItIs) {
  const SliceGeometry geometry(gridAround(Mat3::Identity()), SliceAxis::Axial);
  const int slice = geometry.sliceOf(Vec3(0, 0, 0));
  const double z = geometry.toWorld(SlicePoint(0, 0), slice).z();
  for (int n = 0; n < 25; ++n) {
    // A dome of height 22.5 - r^2 / 40 about its top: 0.02 mm below it a circle of radius 0.9.
    const int across = n % 5;
    const int along = n / 5;
    const HalfSpace plane{Vec3(0.4 * across, 0.4 * along, z - 22.48), Vec3::UnitZ()};
    ResectionPlane bent(plane, flatBend(plane, 30));
    for (const std::size_t inner : {5U, 6U, 9U, 10U}) {
      bent.bend->heightsMm[inner] = 40;
    }
    const auto curves = slicesCurves(geometry, slice, bent);
    ASSERT_EQ(curves.size(), 1U) << n;
    EXPECT_EQ(curves[0].front(), curves[0].back());
  }
}

}  // namespace
}  // namespace glisson
