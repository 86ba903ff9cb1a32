// Edits of a plan in the window: what comes in while a plane is dragged, and the plane around a tumour.

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QTreeWidget>

#include "app/gui/message_bar.h"
#include "app/gui/view_area.h"
#include "main_window_test.h"
#include "planning/resection/place_plane.h"
#include "viewer/plane_handles.h"

namespace glisson {
namespace {

using test::smallCentre;
using test::waitFor;

class PlanEdits : public test::MainWindowTest {
 protected:
  void mouse(QEvent::Type type, const Pixel& at) {
    ModelView& view = window->views().modelView();
    const QPointF pixel(at.x(), at.y());
    const Qt::MouseButtons held =
        type == QEvent::MouseButtonRelease ? Qt::MouseButtons(Qt::NoButton) : Qt::MouseButtons(Qt::LeftButton);
    QMouseEvent event(type, pixel, view.mapToGlobal(pixel), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held,
                      Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  }
  /// Takes the arrow's tip and moves it; where it is then.
  Pixel startDrag() {
    ModelView& view = window->views().modelView();
    const Pixel tip = view.camera().toPixel(view.handles()->arrowTip);
    mouse(QEvent::MouseButtonPress, tip);
    mouse(QEvent::MouseMove, tip + Pixel(6, 3));
    EXPECT_TRUE(document().isDragging());
    return tip + Pixel(6, 3);
  }
};

TEST_F(PlanEdits, UndoWhileAPlaneIsDraggedCancelsTheDrag) {
  openSmall();
  document().placePlane({smallCentre(), Vec3(1, 0.2, 0.1).normalized()});
  document().movePlane({smallCentre() + Vec3(4, 0, 0), Vec3(1, 0.2, 0.1).normalized()});
  ASSERT_TRUE(settle());
  const Pixel at = startDrag();
  document().undoStack().undo();  // the move
  EXPECT_FALSE(document().isDragging());
  ASSERT_TRUE(document().plane().has_value());
  EXPECT_EQ(document().plane()->origin, smallCentre());
  mouse(QEvent::MouseMove, at + Pixel(9, 9));
  mouse(QEvent::MouseButtonRelease, at + Pixel(9, 9));
  EXPECT_FALSE(document().isDragging());
  EXPECT_EQ(document().plane()->origin, smallCentre()) << "the view has let go";
  EXPECT_EQ(document().undoStack().index(), 1);
  ASSERT_TRUE(settle()) << "the numbers come as always";
}

TEST_F(PlanEdits, DeletingThePlaneThatIsDraggedIsOneStepFromWhereItWas) {
  openSmall();
  document().placePlane({smallCentre(), Vec3(1, 0.2, 0.1).normalized()});
  ASSERT_TRUE(settle());
  const std::optional<ResectionPlane> start = document().plane();
  const Pixel at = startDrag();
  EXPECT_NE(document().plane(), start);
  document().removePlane();
  EXPECT_FALSE(document().isDragging());
  EXPECT_FALSE(document().plane().has_value());
  mouse(QEvent::MouseMove, at + Pixel(9, 9));
  mouse(QEvent::MouseButtonRelease, at + Pixel(9, 9));
  EXPECT_FALSE(document().plane().has_value());
  ASSERT_TRUE(settle());
  document().undoStack().undo();
  EXPECT_EQ(document().plane(), start);
  EXPECT_EQ(document().undoStack().index(), 1);
}

TEST_F(PlanEdits, AnotherPlanChosenWhileAPlaneIsDraggedKeepsItsOwn) {
  openSmall();
  document().placePlane({smallCentre(), Vec3(1, 0.2, 0.1).normalized()});
  const ResectionPlane start = document().plane().value();
  document().duplicatePlan();
  document().choose({0, 0, 0});
  ASSERT_TRUE(settle());
  const Pixel at = startDrag();
  document().choose({1, 0, 0});
  EXPECT_FALSE(document().isDragging());
  mouse(QEvent::MouseMove, at + Pixel(9, 9));
  mouse(QEvent::MouseButtonRelease, at + Pixel(9, 9));
  for (const ResectionPlan& plan : document().content().plans) {
    EXPECT_EQ(plan.resections.at(0).planes.at(0), start);
  }
  ASSERT_TRUE(settle());
}

TEST_F(PlanEdits, ThePlaneAroundATumourIsNotPlacedInAPlanThatHasChanged) {
  openSmall();
  document().edit(SetSafetyMargin{3});
  find<QMenu>("placeAroundTumour")->actions().front()->trigger();
  document().edit(SetSafetyMargin{8});
  ASSERT_TRUE(waitFor([&] { return !window->messages().messages().isEmpty(); }));
  EXPECT_TRUE(window->messages().messages().last().contains("The plan has changed while the plane around tumour 1 was sought"));
  ASSERT_TRUE(settle());
  EXPECT_FALSE(document().plane().has_value());
}

TEST_F(PlanEdits, ThePlaneAroundATumourIsAResectionOfItsOwnBesideAWedgeAndItsVesselsAreNamed) {
  openSmall();
  document().edit(SetSafetyMargin{20});
  document().placePlane({smallCentre() - Vec3(20, 0, 0), -Vec3::UnitX()});
  document().edit(AddPlane{0, HalfSpace{smallCentre(), Vec3::UnitY()}});
  ASSERT_TRUE(settle());
  const std::vector<Resection> before = document().plan().resections;
  find<QMenu>("placeAroundTumour")->actions().front()->trigger();
  ASSERT_TRUE(waitFor([&] { return document().plan().resections.size() == 2; }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(document().plan().resections[0], before[0]);
  EXPECT_EQ(document().assessment().tumours.at(0).state, TumourState::Removed);
  EXPECT_GE(document().assessment().tumours.at(0).marginAtLeastMm.value(), 20);
  const QString text = window->messages().messages().last();
  EXPECT_TRUE(text.contains("crosses 1 vessels of 3 mm and more. It crosses portal vein, ")) << text.toStdString();
}

TEST_F(PlanEdits, MarginsSayWhatTheyDoNotKnow) {
  openSmall();
  auto* notice = find<QLabel>("marginNotice");
  auto* panel = find<QWidget>("planPanel");
  EXPECT_FALSE(notice->isVisibleTo(panel)) << "no plane, no margin";
  document().placePlane({smallCentre(), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  EXPECT_TRUE(notice->isVisibleTo(panel));
  EXPECT_TRUE(notice->text().contains("segmentation, breathing, registration and transection are not included"));
  EXPECT_TRUE(find<QTreeWidget>("tumourTable")->topLevelItem(0)->toolTip(2).contains("breathing"));
}

}  // namespace
}  // namespace glisson
