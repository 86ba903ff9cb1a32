// The keyboard of the 3D view: steps of the resection plane, standard views, Escape.

#include <Eigen/Geometry>
#include <QKeyEvent>

#include "viewer/model_view_impl.h"

namespace glisson {

void ModelView::stepPlane(const ResectionPlane& to) {
  emit planeDragStarted();
  setPlane(to);
  emit planeDragged(to);
  emit planeDragFinished(to);
}

void ModelView::spinPlane(double radians) {
  Impl& d = *impl_;
  if (!d.plane || !d.handlesShown || d.drag || d.bendDrag) {
    return;
  }
  if (d.plane->bend) {
    stepPlane(spun(*d.plane, handles()->anchor, radians));
  } else {
    d.spun += radians;
    requestRender();
  }
}

bool ModelView::movePlaneByKey(const QKeyEvent& event) {
  Impl& d = *impl_;
  if (!d.plane || !d.handlesShown || d.drag || d.bendDrag) {
    return false;
  }
  const bool control = event.modifiers().testFlag(Qt::ControlModifier);
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  const double mm = control ? 5.0 : (shift && event.key() != Qt::Key_Plus ? 0.1 : 1.0);
  const auto along = [&](double by) {
    stepPlane(d.canBend() && d.keyedPoint ? lifted(*d.plane, *d.keyedPoint, d.bendGroup, by)
                                          : movedTo(*d.plane, movedAlongNormal(*d.plane, by)));
  };
  switch (event.key()) {
    case Qt::Key_PageUp:
    case Qt::Key_Plus:
      along(mm);
      return true;
    case Qt::Key_PageDown:
    case Qt::Key_Minus:
      along(-mm);
      return true;
    default:
      break;
  }
  const double angle = (shift ? 5.0 : 1.0) * kDegree;
  switch (event.key()) {
    case Qt::Key_Home:
      spinPlane(angle);
      return true;
    case Qt::Key_End:
      spinPlane(-angle);
      return true;
    default:
      break;
  }
  if (!control) {
    return false;
  }
  // Left and right turn about the plane's axis that is nearest to up on the screen, up and down about the other one.
  const HalfSpace about{handles()->anchor, d.plane->normal};
  const Vec3& n = about.normal;
  Vec3 upright = viewUp() - viewUp().dot(n) * n;
  if (upright.norm() < 0.1) {
    upright = viewDirection() - viewDirection().dot(n) * n;
  }
  const auto turn = [&](const Vec3& axis, double by) {
    HalfSpace to = turned(about, axis, by);
    if (d.plane->bend) {
      to.origin = turnedAbout(about.origin, d.plane->origin, n, to.normal);  // the bend's square is about the origin
    }
    stepPlane(movedTo(*d.plane, to));
  };
  switch (event.key()) {
    case Qt::Key_Left:
      turn(upright, angle);
      return true;
    case Qt::Key_Right:
      turn(upright, -angle);
      return true;
    case Qt::Key_Up:
      turn(n.cross(upright), angle);
      return true;
    case Qt::Key_Down:
      turn(n.cross(upright), -angle);
      return true;
    default:
      return false;
  }
}

void ModelView::keyPressEvent(QKeyEvent* event) {
  Impl& d = *impl_;
  if (d.pick && event->key() == Qt::Key_Escape) {
    return cancelPick();
  }
  if ((d.drag || d.bendDrag) && event->key() == Qt::Key_Escape) {
    const ResectionPlane start = d.drag ? d.drag->start() : d.bendDrag->start();
    if (d.drag) {
      d.spun = d.spunFrom;
    }
    setPlane(start);
    emit planeDragged(start);
    d.endDrag(start);
    return;
  }
  if (movePlaneByKey(*event)) {
    event->accept();
    return;
  }
  switch (event->key()) {
    case Qt::Key_1:
      return setStandardView(StandardView::Anterior);
    case Qt::Key_3:
      return setStandardView(StandardView::Left);
    case Qt::Key_7:
      return setStandardView(StandardView::Superior);
    default:
      VtkWidget::keyPressEvent(event);
  }
}

}  // namespace glisson
