#include "viewer/model_view.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QMouseEvent>
#include <numbers>

#include "planning/resection/resection_plan.h"
#include "viewer/model_view_impl.h"

namespace glisson {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Vec3 toVec3(const double* values) { return {values[0], values[1], values[2]}; }

}  // namespace

ModelView::ModelView(QWidget* parent) : VtkWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName("modelView");
  setAccessibleName(tr("3D view"));
  Impl& d = *impl_;
  d.scene.renderer->SetBackground(0.11, 0.12, 0.14);
  d.makeCube();
  d.planeActors.setVisible(false);
  d.planeActors.setLabel(tr("resected").toStdString());
  d.scene.beforeFrame = [this](FrameQuality quality) { impl_->prepareFrame(quality); };
  d.lookFrom(Vec3::UnitY(), Vec3::UnitZ());
}

ModelView::~ModelView() {
  makeCurrent();
  impl_->scene.beforeFrame = nullptr;
  impl_->marker->SetEnabled(0);
  impl_->marker->SetInteractor(nullptr);
  impl_.reset();
  doneCurrent();
}

void ModelView::setModel(std::shared_ptr<const LiverModel> model, const std::vector<std::shared_ptr<const DisplayMesh>>& ready) {
  Impl& d = *impl_;
  d.model = std::move(model);
  if (d.showStructures(ready)) {
    d.lookFrom(Vec3::UnitY(), Vec3::UnitZ());
  } else {
    d.fitAgain();
  }
  d.scene.touch();  // structures arrive one after the other: quick frames until they rest
  requestRender();
}

void ModelView::setPlane(std::optional<HalfSpace> plane) {
  Impl& d = *impl_;
  const bool same = plane.has_value() == d.plane.has_value() &&
                    (!plane || (plane->origin == d.plane->origin && plane->normal == d.plane->normal));
  if (same) {
    return;
  }
  d.plane = std::move(plane);
  if (!d.plane) {
    d.drag.reset();
    d.hovered.reset();
  }
  for (const auto& [id, actors] : d.structures) {
    actors->setPlane(d.plane);
  }
  d.sectionStale = true;
  d.scene.touch();
  requestRender();
}

std::optional<HalfSpace> ModelView::plane() const { return impl_->plane; }

void ModelView::resizeGL(int width, int height) {
  VtkWidget::resizeGL(width, height);
  impl_->fitAgain();
}

void ModelView::setStandardView(StandardView view) {
  switch (view) {
    case StandardView::Anterior:
      return impl_->lookFrom(Vec3::UnitY(), Vec3::UnitZ());
    case StandardView::Posterior:
      return impl_->lookFrom(-Vec3::UnitY(), Vec3::UnitZ());
    case StandardView::Left:
      return impl_->lookFrom(-Vec3::UnitX(), Vec3::UnitZ());
    case StandardView::Right:
      return impl_->lookFrom(Vec3::UnitX(), Vec3::UnitZ());
    case StandardView::Superior:
      return impl_->lookFrom(-Vec3::UnitZ(), -Vec3::UnitY());
    case StandardView::Inferior:
      return impl_->lookFrom(Vec3::UnitZ(), -Vec3::UnitY());
  }
}

Vec3 ModelView::viewDirection() const { return camera().forward; }

Vec3 ModelView::viewUp() const { return camera().up; }

ViewCamera ModelView::camera() const {
  vtkCamera* vtk = impl_->scene.renderer->GetActiveCamera();
  ViewCamera camera;
  camera.position = toVec3(vtk->GetPosition());
  camera.forward = toVec3(vtk->GetDirectionOfProjection()).normalized();
  const Vec3 up = toVec3(vtk->GetViewUp());
  camera.up = (up - up.dot(camera.forward) * camera.forward).normalized();
  camera.viewAngle = vtk->GetViewAngle() * kDegree;
  camera.width = std::max(1, width());
  camera.height = std::max(1, height());
  return camera;
}

std::optional<HandleLayout> ModelView::handles() const {
  if (!impl_->plane) {
    return std::nullopt;
  }
  impl_->updateSection(impl_->sectionIsCoarse);
  return impl_->layout();
}

QImage ModelView::picture() {
  if (!isValid() && !window()->isVisible()) {
    // OpenGL needs a window: make one that nobody sees.
    QWidget* top = window();
    top->setAttribute(Qt::WA_DontShowOnScreen);
    top->show();
    QImage image = picture();
    top->hide();
    top->setAttribute(Qt::WA_DontShowOnScreen, false);
    return image;
  }
  impl_->scene.picture = true;
  QImage image = grabFramebuffer();
  impl_->scene.picture = false;
  return image;
}

void ModelView::mousePressEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (event->button() == Qt::LeftButton && d.plane && event->modifiers() == Qt::NoModifier) {
    const Pixel mouse(event->position().x(), event->position().y());
    const HandleLayout layout = *handles();
    if (const auto handle = handleAt(layout, camera(), mouse)) {
      d.drag.emplace(*handle, *d.plane, layout, camera(), mouse);
      event->accept();
      emit planeDragStarted();
      return;
    }
  }
  if (!d.drag) {
    VtkWidget::mousePressEvent(event);
  }
}

void ModelView::mouseMoveEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  const Pixel mouse(event->position().x(), event->position().y());
  if (d.drag) {
    const HalfSpace moved = d.drag->planeAt(mouse);
    setPlane(moved);
    event->accept();
    emit planeDragged(moved);
    return;
  }
  if (d.plane && event->buttons() == Qt::NoButton) {
    const auto handle = handleAt(*handles(), camera(), mouse);
    if (handle != d.hovered) {
      d.hovered = handle;
      setCursor(handle ? Qt::PointingHandCursor : Qt::ArrowCursor);
      requestRender();
    }
  }
  VtkWidget::mouseMoveEvent(event);
}

void ModelView::mouseReleaseEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (!d.drag) {
    VtkWidget::mouseReleaseEvent(event);
    return;
  }
  event->accept();
  if (event->button() == Qt::LeftButton) {
    d.endDrag(*d.plane);
  }
}

void ModelView::mouseDoubleClickEvent(QMouseEvent* event) {
  const Pixel mouse(event->position().x(), event->position().y());
  if (event->button() == Qt::LeftButton && !(impl_->plane && handleAt(*handles(), camera(), mouse))) {
    event->accept();
    emit maximiseRequested();
  }
}

void ModelView::leaveEvent(QEvent* event) {
  if (impl_->hovered && !impl_->drag) {
    impl_->hovered.reset();
    requestRender();
  }
  VtkWidget::leaveEvent(event);
}

void ModelView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && impl_) {
    setAccessibleName(tr("3D view"));
    impl_->planeActors.setLabel(tr("resected").toStdString());
    requestRender();
  }
  VtkWidget::changeEvent(event);
}

void ModelView::stepPlane(const HalfSpace& to) {
  emit planeDragStarted();
  setPlane(to);
  emit planeDragged(to);
  emit planeDragFinished(to);
}

bool ModelView::movePlaneByKey(const QKeyEvent& event) {
  Impl& d = *impl_;
  if (!d.plane || d.drag) {
    return false;
  }
  const bool control = event.modifiers().testFlag(Qt::ControlModifier);
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  const double mm = control ? 5.0 : (shift && event.key() != Qt::Key_Plus ? 0.1 : 1.0);
  switch (event.key()) {
    case Qt::Key_PageUp:
    case Qt::Key_Plus:
      stepPlane(movedAlongNormal(*d.plane, mm));
      return true;
    case Qt::Key_PageDown:
    case Qt::Key_Minus:
      stepPlane(movedAlongNormal(*d.plane, -mm));
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
  const double angle = (shift ? 5.0 : 1.0) * kDegree;
  switch (event.key()) {
    case Qt::Key_Left:
      stepPlane(turned(about, upright, angle));
      return true;
    case Qt::Key_Right:
      stepPlane(turned(about, upright, -angle));
      return true;
    case Qt::Key_Up:
      stepPlane(turned(about, n.cross(upright), angle));
      return true;
    case Qt::Key_Down:
      stepPlane(turned(about, n.cross(upright), -angle));
      return true;
    default:
      return false;
  }
}

void ModelView::keyPressEvent(QKeyEvent* event) {
  Impl& d = *impl_;
  if (d.drag && event->key() == Qt::Key_Escape) {
    const HalfSpace start = d.drag->start();
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
