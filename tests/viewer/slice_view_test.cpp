// The slice views: patient sides on flipped, permuted and oblique grids, clicks that give the world back, outlines, the plane's
// line, steps, zoom and window.

#include "viewer/slice_view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "tests/viewer/bodies.h"
#include "tests/viewer/colour_difference.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/slice_outlines.h"
#include "viewer/slice_painter.h"

namespace glisson {
namespace {

using test::sphere;
using test::structure;

struct Grid {
  const char* name;
  Mat3 direction;
};

Mat3 columns(const Vec3& i, const Vec3& j, const Vec3& k) {
  Mat3 matrix;
  matrix << i, j, k;
  return matrix;
}

std::vector<Grid> grids() {
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  const Mat3 oblique = (Eigen::AngleAxisd(0.35, z) * Eigen::AngleAxisd(-0.25, x) * Eigen::AngleAxisd(0.2, y)).toRotationMatrix();
  return {{"straight", Mat3::Identity()},
          {"RAS", columns(-x, -y, z)},
          {"upside down", columns(x, y, -z)},
          {"sagittal", columns(y, -z, x)},
          {"coronal", columns(-x, -z, -y)},
          {"oblique", oblique},
          {"oblique flipped", oblique * columns(-y, -z, x)}};
}

/// Unequal sizes and spacings, so that a mixed-up axis shows; centred on (12, -150, 340) mm.
ImageGeometry geometryOf(const Mat3& direction) {
  ImageGeometry grid;
  grid.size = {40, 50, 60};
  grid.spacing = Vec3(2.0, 1.5, 1.2);
  grid.direction = direction;
  grid.origin = Vec3::Zero();
  grid.origin = Vec3(12, -150, 340) - grid.toWorld(Vec3(19.5, 24.5, 29.5));
  return grid;
}

const Vec3 kCentre(12, -150, 340);

/// Bright within 8 mm of `spot`, dark elsewhere.
std::shared_ptr<const CtVolume> ctWithSpot(const ImageGeometry& grid, const Vec3& spot) {
  auto ct = std::make_shared<CtVolume>();
  ct->geometry = grid;
  ct->hounsfield.reserve(grid.voxelCount());
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        ct->hounsfield.push_back((grid.toWorld(Vec3(i, j, k)) - spot).norm() < 8 ? 1000 : -1000);
      }
    }
  }
  return ct;
}

/// A ball of 15 mm about kCentre as the one structure, in pure magenta.
struct Labelled {
  std::shared_ptr<Segmentation> segmentation = std::make_shared<Segmentation>();
  std::shared_ptr<LiverModel> model = std::make_shared<LiverModel>();
};

Labelled ballIn(const ImageGeometry& grid) {
  std::vector<std::uint8_t> values;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        values.push_back((grid.toWorld(Vec3(i, j, k)) - kCentre).norm() < 15 ? 1 : 0);
      }
    }
  }
  Labelled result;
  result.segmentation->geometry = grid;
  LabelledMask mask;
  mask.name = "ball";
  mask.mask = std::make_shared<const Mask>(Mask::fromGrid(grid.size, values));
  result.segmentation->structures.push_back(mask);
  Structure structure;
  structure.id = "tumour_01";
  structure.colour = {255, 0, 255};
  structure.sourceIndex = 0;
  result.model->structures.push_back(structure);
  return result;
}

QImage grabbed(SliceView& view, const QString& name) { return test::kept(view.grab().toImage(), name); }

/// Where the slice's own bright pixels lie in the middle of the picture, away from the letters and texts, which are bright too.
QPointF brightSpot(const QImage& image) {
  QPointF sum;
  double weight = 0;
  for (int y = image.height() / 8; y < image.height() * 7 / 8; ++y) {
    for (int x = image.width() / 8; x < image.width() * 7 / 8; ++x) {
      const QColor c = image.pixelColor(x, y);
      if (c.red() > 250 && c.green() > 250 && c.blue() > 250) {
        sum += QPointF(x + 0.5, y + 0.5);
        weight += 1;
      }
    }
  }
  return weight > 0 ? sum / weight : QPointF(-1, -1);
}

int countColour(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      if (std::abs(c.red() - colour.red()) < 40 && std::abs(c.green() - colour.green()) < 40 &&
          std::abs(c.blue() - colour.blue()) < 40) {
        ++count;
      }
    }
  }
  return count;
}

struct Expectation {
  SliceAxis axis;
  const char* letters;  ///< left, right, top, bottom
  Vec3 right;
  Vec3 down;
};

const std::array<Expectation, 3> kViews{{{SliceAxis::Axial, "RLAP", Vec3::UnitX(), Vec3::UnitY()},
                                         {SliceAxis::Coronal, "RLSI", Vec3::UnitX(), -Vec3::UnitZ()},
                                         {SliceAxis::Sagittal, "APSI", Vec3::UnitY(), -Vec3::UnitZ()}}};

TEST(SliceGeometryTest, LettersFollowTheRadiologicalConventionOnEveryGrid) {
  for (const Grid& grid : grids()) {
    for (const Expectation& view : kViews) {
      const SliceGeometry geometry(geometryOf(grid.direction), view.axis);
      const auto letters = geometry.letters();
      EXPECT_EQ(std::string(letters.begin(), letters.end()), view.letters) << grid.name;
    }
  }
}

TEST(SliceGeometryTest, SlicePointsAndWorldAreInverseOnEveryGrid) {
  for (const Grid& grid : grids()) {
    for (const Expectation& view : kViews) {
      const SliceGeometry geometry(geometryOf(grid.direction), view.axis);
      const SlicePoint point(7.25, 11.5);
      const Vec3 world = geometry.toWorld(point, 9);
      EXPECT_LT((geometry.toSlice(world) - point).norm(), 1e-9) << grid.name;
      EXPECT_EQ(geometry.sliceOf(world), 9) << grid.name;
    }
  }
}

TEST(SliceViewTest, AVoxelToThePatientsSideIsDrawnOnThatSideOfThePicture) {
  for (const Grid& grid : grids()) {
    for (const Expectation& expected : kViews) {
      const Vec3 spot = kCentre + 17 * expected.right + 12 * expected.down;
      SliceView view(expected.axis);
      view.resize(400, 400);
      view.setVolumes(ctWithSpot(geometryOf(grid.direction), spot), nullptr);
      view.setCrosshair(spot);
      const QImage image = grabbed(view, QString("slice_%1_%2").arg(grid.name).arg(static_cast<int>(expected.axis)));
      const QPointF bright = brightSpot(image);
      const QPointF centre = *view.pixelOf(kCentre);
      EXPECT_GT(bright.x(), centre.x() + 20) << grid.name << " " << expected.letters;
      EXPECT_GT(bright.y(), centre.y() + 15) << grid.name << " " << expected.letters;
      const QPointF drawn = *view.pixelOf(spot);
      EXPECT_LT(std::hypot(bright.x() - drawn.x(), bright.y() - drawn.y()), 6.0) << grid.name << " " << expected.letters;
    }
  }
}

TEST(SliceViewTest, AClickGivesTheWorldPointBackToHalfAPixel) {
  for (const Grid& grid : grids()) {
    for (const Expectation& expected : kViews) {
      SliceView view(expected.axis);
      view.resize(400, 300);
      view.setVolumes(ctWithSpot(geometryOf(grid.direction), kCentre), nullptr);
      view.setCrosshair(kCentre + Vec3(3, 4, 5));
      const int slice = view.slice();
      QSignalSpy moved(&view, &SliceView::crosshairMoved);
      QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, QPoint(180, 133));
      ASSERT_EQ(moved.count(), 1);
      const Vec3 world = moved[0][0].value<Vec3>();
      const QPointF pixel = *view.pixelOf(world);
      EXPECT_LT(std::hypot(pixel.x() - 180, pixel.y() - 133), 0.5) << grid.name;
      EXPECT_EQ(view.slice(), slice) << grid.name;
      SliceView other(expected.axis);
      other.setVolumes(ctWithSpot(geometryOf(grid.direction), kCentre), nullptr);
      other.setCrosshair(world);
      EXPECT_EQ(other.slice(), slice) << grid.name;
    }
  }
}

TEST(SliceViewTest, MillimetresAreEquallyLongBothWays) {
  for (const Expectation& expected : kViews) {
    SliceView view(expected.axis);
    view.resize(500, 300);
    view.setVolumes(ctWithSpot(geometryOf(Mat3::Identity()), kCentre), nullptr);
    const QPointF origin = *view.pixelOf(kCentre);
    const QPointF right = *view.pixelOf(kCentre + 10 * expected.right);
    const QPointF down = *view.pixelOf(kCentre + 10 * expected.down);
    EXPECT_NEAR(right.x() - origin.x(), down.y() - origin.y(), 1e-6);
    EXPECT_GT(right.x(), origin.x());
  }
}

TEST(SliceViewTest, OutlinesHaveTheStructuresColourAndFollowItsVisibility) {
  for (const Grid& grid : grids()) {
    for (const Expectation& expected : kViews) {
      const ImageGeometry geometry = geometryOf(grid.direction);
      const Labelled labelled = ballIn(geometry);
      SliceView view(expected.axis);
      view.resize(400, 400);
      view.setVolumes(nullptr, labelled.segmentation);
      view.setModel(labelled.model);
      view.setCrosshair(kCentre);
      const QColor magenta(255, 0, 255);
      EXPECT_GT(countColour(grabbed(view, QString("outline_%1_%2").arg(grid.name).arg(static_cast<int>(expected.axis))), magenta),
                50)
          << grid.name;
      view.setCrosshair(kCentre + 18 * expected.right.cross(expected.down));
      EXPECT_EQ(countColour(grabbed(view, "outline_off"), magenta), 0) << grid.name;
      view.setCrosshair(kCentre);
      auto hidden = std::make_shared<LiverModel>(*labelled.model);
      hidden->structures[0].visible = false;
      view.setModel(hidden);
      EXPECT_EQ(countColour(grabbed(view, "outline_hidden"), magenta), 0) << grid.name;
    }
  }
}

TEST(SliceViewTest, TheParenchymasOutlineIsThatOfTheVoxelsThatAreCounted) {
  const ImageGeometry geometry = geometryOf(Mat3::Identity());
  const Labelled labelled = ballIn(geometry);
  labelled.model->structures[0].kind = StructureKind::Liver;
  auto liver = std::make_shared<LiverVoxels>();
  liver->geometry = geometry;
  SliceView view(SliceAxis::Axial);
  view.resize(400, 400);
  view.setModel(labelled.model);
  const QColor magenta(255, 0, 255);
  const Vec3 outside = kCentre + 18 * Vec3::UnitZ();  // above the mask as it was read
  view.setVolumes(nullptr, labelled.segmentation);
  view.setCrosshair(outside);
  EXPECT_EQ(countColour(grabbed(view, "outline_mask"), magenta), 0);
  liver->liver = Mask::fromGrid(geometry.size, std::vector<std::uint8_t>(geometry.voxelCount(), 1));
  view.setVolumes(nullptr, labelled.segmentation, liver);
  view.setCrosshair(outside);
  EXPECT_GT(countColour(grabbed(view, "outline_counted"), magenta), 50);
}

TEST(SliceViewTest, ASurfaceThatWasMadeChangesNoSliceAndAColourDoes) {
  const Labelled labelled = ballIn(geometryOf(Mat3::Identity()));
  SliceView view(SliceAxis::Axial);
  view.resize(400, 400);
  view.setVolumes(nullptr, labelled.segmentation);
  view.setModel(labelled.model);
  view.setCrosshair(kCentre);
  const QImage before = grabbed(view, "looks_before");
  auto made = std::make_shared<LiverModel>(*labelled.model);
  made->structures[0].reconstruction = std::make_shared<const Reconstruction>();
  view.setModel(made);
  EXPECT_EQ(grabbed(view, "looks_made"), before);
  auto coloured = std::make_shared<LiverModel>(*made);
  coloured->structures[0].colour = {0, 255, 255};
  view.setModel(coloured);
  EXPECT_GT(countColour(grabbed(view, "looks_coloured"), QColor(0, 255, 255)), 50);
}

/// The brightest colour of the outlines of a ball of this kind, label and surface, on black.
QColor outlineSeen(StructureKind kind) {
  const Labelled labelled = ballIn(geometryOf(Mat3::Identity()));
  const Rgb colour = defaultColour(kind);
  labelled.model->structures[0] = structure("ball", kind, colour, 1.0, sphere(kCentre, Vec3(15, 15, 15)));
  labelled.model->structures[0].sourceIndex = 0;
  SliceView view(SliceAxis::Axial);
  view.resize(400, 400);
  view.setVolumes(nullptr, labelled.segmentation);
  view.setModel(labelled.model);
  view.setCrosshair(kCentre);
  (void)grabbed(view, "outline_label");  // the surface is made ready by the first frame
  const QImage image = grabbed(view, QString("outline_surface_%1").arg(static_cast<int>(kind)));
  const QPoint middle = view.pixelOf(kCentre)->toPoint();
  QColor brightest(0, 0, 0);
  for (int n = 20; n < 130; ++n) {  // along the diagonals, where neither crosshair nor letters are
    for (const QPoint& way : {QPoint(n, n), QPoint(n, -n), QPoint(-n, n), QPoint(-n, -n)}) {
      const QColor pixel = image.pixelColor(middle + way);
      if (pixel.red() + pixel.green() + pixel.blue() > brightest.red() + brightest.green() + brightest.blue()) {
        brightest = pixel;
      }
    }
  }
  return brightest;
}

TEST(SliceViewTest, OutlinesOfNeighboursStayApartWhenTheirSurfacesAreDrawnForDeuteranopesToo) {
  constexpr double kToldApart = 20;
  using K = StructureKind;
  const std::array vessels{K::PortalVein, K::HepaticVein, K::Artery};
  for (const K vessel : vessels) {
    for (const bool deuteranope : {false, true}) {
      EXPECT_GE(test::colourDifference(outlineSeen(K::Liver), outlineSeen(vessel), deuteranope), kToldApart)
          << kindId(vessel) << (deuteranope ? " deuteranope" : "");
    }
    EXPECT_GE(test::colourDifference(outlineSeen(K::Tumour), outlineSeen(vessel), true), kToldApart) << kindId(vessel);
  }
  for (const K other : {K::Liver, K::Cyst, K::BileDuct, K::Gallbladder}) {
    EXPECT_GE(test::colourDifference(outlineSeen(K::Tumour), outlineSeen(other), false), kToldApart) << kindId(other);
  }
}

TEST(SliceViewTest, WhereThereIsNoCtTheReasonStandsInTheViewUntilOneComes) {
  const ImageGeometry geometry = geometryOf(Mat3::Identity());
  const Labelled labelled = ballIn(geometry);
  SliceView view(SliceAxis::Axial);
  view.resize(250, 250);
  const auto grab = [&](const char* name) {
    view.setModel(labelled.model);
    view.setCrosshair(kCentre);
    return grabbed(view, name);
  };
  view.setVolumes(nullptr, labelled.segmentation);
  const QImage silent = grab("no_ct_silent");
  view.setNoCt("The CT of this case is no longer at /somewhere/with-a-long-name-that-has-no-blank/patient; put it back.");
  EXPECT_NE(grab("no_ct_reason"), silent);
  view.setVolumes(ctWithSpot(geometry, kCentre), labelled.segmentation);
  const QImage withCt = grab("no_ct_came");
  view.setNoCt({});
  EXPECT_EQ(grab("no_ct_none"), withCt);
}

TEST(SliceLettersTest, NoLetterLiesOnATextInTheSmallestView) {
  const QSizeF letter(14, 20);
  for (const QSize& view : {QSize(120, 90), QSize(200, 140), QSize(240, 300), QSize(900, 700)}) {
    const std::vector<QRectF> texts{QRectF(8, 8, 62, 16), QRectF(8, view.height() - 40, 104, 32),
                                    QRectF(view.width() - 50, view.height() - 40, 42, 32)};
    for (const QRectF& box : letterBoxes(view, letter, texts)) {
      EXPECT_TRUE(QRectF(QPointF(0, 0), QSizeF(view)).contains(box)) << view.width();
      for (const QRectF& text : texts) {
        EXPECT_FALSE(box.intersects(text)) << view.width() << ' ' << box.x() << ' ' << box.y();
      }
    }
  }
}

TEST(SliceOutlineTest, TheOutlineOfABlockEnclosesItsVoxelsAtHalfAVoxel) {
  ImageGeometry grid;
  grid.size = {10, 10, 3};
  const Mask mask(IndexBox{{3, 4, 1}, {4, 2, 1}}, std::vector<std::uint8_t>(8, 1));
  const SliceGeometry geometry(grid, SliceAxis::Axial);
  const auto lines = outlineOf(mask, grid, geometry, 1);
  EXPECT_EQ(lines.size(), 2 * (4 + 2) + 0U);  // 8 straight pieces and 4 cut corners
  SlicePoint low(1e9, 1e9);
  SlicePoint high(-1e9, -1e9);
  for (const auto& [a, b] : lines) {
    low = low.cwiseMin(a).cwiseMin(b);
    high = high.cwiseMax(a).cwiseMax(b);
  }
  EXPECT_TRUE(low.isApprox(SlicePoint(2.5, 3.5)));
  EXPECT_TRUE(high.isApprox(SlicePoint(6.5, 5.5)));
  EXPECT_TRUE(outlineOf(mask, grid, geometry, 0).empty());
}

TEST(SliceOutlineTest, AMaskOnAnotherGridIsDrawnWhereItLiesInTheWorld) {
  const ImageGeometry ctGrid = geometryOf(Mat3::Identity());
  const ImageGeometry labelGrid = geometryOf(grids().back().direction);
  const Labelled labelled = ballIn(labelGrid);
  const SliceGeometry geometry(ctGrid, SliceAxis::Axial);
  const auto lines = outlineOf(*labelled.segmentation->structures[0].mask, labelGrid, geometry, geometry.sliceOf(kCentre));
  ASSERT_FALSE(lines.empty());
  for (const auto& [a, b] : lines) {
    EXPECT_NEAR((geometry.toWorld(a, geometry.sliceOf(kCentre)) - kCentre).norm(), 15.0, 2.5);
  }
}

TEST(PlaneLineTest, TheLineLiesOnThePlaneWithTheResectedSideOnItsRight) {
  for (const Grid& grid : grids()) {
    for (const Expectation& expected : kViews) {
      const SliceGeometry geometry(geometryOf(grid.direction), expected.axis);
      const HalfSpace plane{kCentre + Vec3(2, 3, 1), Vec3(0.5, -0.7, 0.4).normalized()};
      const int slice = geometry.sliceOf(kCentre);
      const auto line = planeLine(geometry, slice, plane);
      ASSERT_TRUE(line) << grid.name;
      const SlicePoint along = line->second - line->first;
      const SlicePoint right(-along.y(), along.x());
      for (const double t : {0.0, 0.3, 1.0}) {
        const SlicePoint at = line->first + t * along;
        EXPECT_NEAR(plane.normal.dot(geometry.toWorld(at, slice) - plane.origin), 0.0, 1e-9) << grid.name;
        EXPECT_GT(plane.normal.dot(geometry.toWorld(at + 0.1 * right, slice) - plane.origin), 0.0) << grid.name;
      }
    }
  }
}

TEST(PlaneLineTest, APlaneParallelToTheSliceOrBesideItHasNoLine) {
  const SliceGeometry geometry(geometryOf(Mat3::Identity()), SliceAxis::Axial);
  EXPECT_FALSE(planeLine(geometry, 10, HalfSpace{kCentre, Vec3::UnitZ()}));
  EXPECT_FALSE(planeLine(geometry, 10, HalfSpace{kCentre + Vec3(500, 0, 0), Vec3::UnitX()}));
}

class SliceInteractionTest : public testing::Test {
 protected:
  void SetUp() override {
    view.resize(400, 400);
    view.setVolumes(ctWithSpot(geometryOf(grids()[1].direction), kCentre), nullptr);
    view.setCrosshair(kCentre);
  }

  void wheel(int angle) {
    const QPointF at(200, 200);
    QWheelEvent event(at, view.mapToGlobal(at), {}, QPoint(0, angle), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }

  void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPointF& by) {
    const QPointF from(200, 200);
    QMouseEvent press(QEvent::MouseButtonPress, from, view.mapToGlobal(from), button, button, modifiers);
    QApplication::sendEvent(&view, &press);
    QMouseEvent move(QEvent::MouseMove, from + by, view.mapToGlobal(from + by), Qt::NoButton, button, modifiers);
    QApplication::sendEvent(&view, &move);
    QMouseEvent release(QEvent::MouseButtonRelease, from + by, view.mapToGlobal(from + by), button, Qt::NoButton, modifiers);
    QApplication::sendEvent(&view, &release);
  }

  SliceView view{SliceAxis::Axial};
};

TEST_F(SliceInteractionTest, ANotchOfTheWheelStepsOneSliceTowardsTheHeadAndPartsOfANotchAddUp) {
  QSignalSpy moved(&view, &SliceView::crosshairMoved);
  const Vec3 before = view.crosshair();
  wheel(120);
  ASSERT_EQ(moved.count(), 1);
  EXPECT_NEAR(view.crosshair().z() - before.z(), 1.2, 0.7);  // to the next slice's centre
  const double z = view.crosshair().z();
  wheel(40);
  wheel(40);
  EXPECT_EQ(moved.count(), 1);
  wheel(40);
  EXPECT_EQ(moved.count(), 2);
  EXPECT_NEAR(view.crosshair().z() - z, 1.2, 1e-9);
}

TEST_F(SliceInteractionTest, ArrowKeysStepAndStopAtTheLastSlice) {
  const int slice = view.slice();
  QTest::keyClick(&view, Qt::Key_Up);
  EXPECT_EQ(view.slice(), slice + 1);
  QTest::keyClick(&view, Qt::Key_Down);
  EXPECT_EQ(view.slice(), slice);
  for (int n = 0; n < 100; ++n) {
    QTest::keyClick(&view, Qt::Key_Down);
  }
  EXPECT_EQ(view.slice(), 0);
}

TEST_F(SliceInteractionTest, RightDragZoomsMiddleDragPansAndRResets) {
  const QPointF centre = *view.pixelOf(kCentre);
  const QPointF beside = *view.pixelOf(kCentre + Vec3(10, 0, 0));
  drag(Qt::RightButton, Qt::NoModifier, QPointF(0, -60));
  EXPECT_GT(view.pixelOf(kCentre + Vec3(10, 0, 0))->x() - view.pixelOf(kCentre)->x(), 1.5 * (beside.x() - centre.x()));
  drag(Qt::MiddleButton, Qt::NoModifier, QPointF(33, 21));
  EXPECT_NEAR(view.pixelOf(kCentre)->x() - centre.x(), 33, 1.0);
  EXPECT_NEAR(view.pixelOf(kCentre)->y() - centre.y(), 21, 1.0);
  QTest::keyClick(&view, Qt::Key_R);
  EXPECT_NEAR(view.pixelOf(kCentre)->x(), centre.x(), 1e-9);
}

TEST_F(SliceInteractionTest, CtrlRightDragChangesTheWindowAndThePicture) {
  QSignalSpy changed(&view, &SliceView::windowLevelChanged);
  drag(Qt::RightButton, Qt::ControlModifier, QPointF(50, 20));
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed[0][0].value<WindowLevel>(), (WindowLevel{450, 60}));
  const QImage narrow = view.grab().toImage();
  view.setWindowLevel({4000, 0});
  EXPECT_NE(view.grab().toImage().pixelColor(300, 250), narrow.pixelColor(300, 250));  // -1000 HU: no longer black
}

TEST_F(SliceInteractionTest, DoubleClickAsksForTheMaximisedView) {
  QSignalSpy asked(&view, &SliceView::maximiseRequested);
  QTest::mouseDClick(&view, Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
}

TEST_F(SliceInteractionTest, APlaneIsDrawnAndRemoved) {
  const QImage before = view.grab().toImage();
  view.setPlane(HalfSpace{kCentre, Vec3(1, 1, 0).normalized()});
  EXPECT_NE(grabbed(view, "slice_plane"), before);
  view.setPlane(std::nullopt);
  EXPECT_EQ(view.grab().toImage(), before);
}

}  // namespace
}  // namespace glisson
