// The sample patient in the views: the model of the default methods, its sides, and how long frames and repaints take.

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <ctime>

#include "planning/case/case.h"
#include "planning/resection/place_plane.h"
#include "reconstruction/sample/sample_patient.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/model_view.h"
#include "viewer/slice_view.h"

namespace glisson {
namespace {

const Case& sampleCase() {
  static const Case sample = [] {
    SamplePatient patient = makeSamplePatient(false);
    return buildModel(newCase(std::make_shared<const CtVolume>(std::move(patient.ct)),
                              std::make_shared<const Segmentation>(std::move(patient.segmentation))));
  }();
  return sample;
}

const Structure& structureOf(StructureKind kind) {
  const auto& structures = sampleCase().model->structures;
  return *std::find_if(structures.begin(), structures.end(), [&](const Structure& s) { return s.kind == kind; });
}

/// Time of all threads of this process: what other programs do meanwhile does not count.
double processorMs(std::clock_t start) { return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class SampleViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view.resize(1000, 700);
    view.setModel(sampleCase().model);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    centre = centroidOf(structureOf(StructureKind::Liver).reconstruction->mesh);
  }

  ModelView view;
  Vec3 centre;
};

TEST_F(SampleViewTest, FromAnteriorTheGallbladderIsBelowTheLiversCentreOnThePatientsRight) {
  const Bounds gallbladder = boundsOf(structureOf(StructureKind::Gallbladder).reconstruction->mesh);
  const QImage image = view.picture();
  test::kept(image, "sample_anterior");
  const Pixel at = view.camera().toPixel(0.5 * (gallbladder.low + gallbladder.high));
  const Pixel middle = view.camera().toPixel(0.5 * (boundsOf(structureOf(StructureKind::Liver).reconstruction->mesh).low +
                                                    boundsOf(structureOf(StructureKind::Liver).reconstruction->mesh).high));
  EXPECT_LT(at.x(), middle.x());
  EXPECT_GT(at.y(), middle.y());
}

TEST_F(SampleViewTest, APlaneThroughTheLiverIsDrawnAndMovesWithin100MsOfProcessorTimeAFrame) {
  const HalfSpace plane = planeFromCamera(centre, view.viewDirection(), view.viewUp());
  view.setPlane(plane);
  test::kept(view.picture(), "sample_plane_edge_on");
  view.setPlane(turned(plane, Vec3::UnitZ(), -0.7));
  test::kept(view.picture(), "sample_plane_turned");
  view.setStandardView(ModelView::StandardView::Left);
  test::kept(view.picture(), "sample_plane_left");
  view.setStandardView(ModelView::StandardView::Superior);
  test::kept(view.picture(), "sample_plane_superior");
  view.setStandardView(ModelView::StandardView::Anterior);
  std::vector<double> frames;
  for (int n = 0; n < 15; ++n) {
    const std::clock_t start = std::clock();
    view.setPlane(movedAlongNormal(turned(plane, Vec3::UnitZ(), -0.7), n));
    ASSERT_FALSE(view.nextFrame().isNull());
    frames.push_back(processorMs(start));
  }
  test::kept(view.nextFrame(), "sample_plane_moving");
  RecordProperty("movingFrameMs", std::to_string(median(frames)));
  EXPECT_LT(median(frames), 100.0);
}

TEST(SampleSliceTest, SlicesShowTheLiverAndRepaintQuicklyWhileThePlaneMoves) {
  const Vec3 centre = centroidOf(structureOf(StructureKind::Liver).reconstruction->mesh);
  for (const auto& [axis, name] : {std::pair{SliceAxis::Axial, "sample_axial"}, std::pair{SliceAxis::Coronal, "sample_coronal"},
                                   std::pair{SliceAxis::Sagittal, "sample_sagittal"}}) {
    SliceView view(axis);
    view.resize(600, 500);
    view.setVolumes(sampleCase().ct, sampleCase().segmentation);
    view.setModel(sampleCase().model);
    view.setCrosshair(centre);
    view.setPlane(HalfSpace{centre, Vec3(1, -0.6, 0.2).normalized()});
    test::kept(view.grab().toImage(), name);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    std::vector<double> drawn;
    std::vector<double> step;
    for (int n = 0; n < 15; ++n) {
      std::clock_t start = std::clock();
      view.setPlane(HalfSpace{centre + Vec3(n, 0, 0), Vec3(1, -0.6, 0.2).normalized()});
      view.repaint();
      drawn.push_back(processorMs(start));
      start = std::clock();
      QTest::keyClick(&view, Qt::Key_Up);
      view.repaint();
      step.push_back(processorMs(start));
    }
    RecordProperty(std::string(name) + "PlaneMs", std::to_string(median(drawn)));
    RecordProperty(std::string(name) + "StepMs", std::to_string(median(step)));
    EXPECT_LT(median(drawn), 30.0) << name;
    EXPECT_LT(median(step), 100.0) << name;
  }
}

}  // namespace
}  // namespace glisson
