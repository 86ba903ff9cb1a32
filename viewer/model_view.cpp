#include "viewer/model_view.h"

#include <Eigen/Geometry>
#include <QMouseEvent>
#include <algorithm>
#include <iterator>

#include "viewer/model_view_impl.h"
#include "viewer/surface_pick.h"

namespace glisson {

ModelView::ModelView(QWidget* parent) : VtkWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName("modelView");
  setAccessibleName(tr("3D view"));
  Impl& d = *impl_;
  d.scene.renderer->SetBackground(0.11, 0.12, 0.14);
  d.pickOverlay = new PickOverlay(this);
  d.resectogram = new Resectogram(this);
  connect(d.resectogram, &Resectogram::unfoldedChanged, this, [this](bool unfolded) {
    impl_->placeResectogram();
    emit mapShownChanged(unfolded);
  });
  d.planeActors.setVisible(false);
  d.planeActors.setLabel(tr("resected").toStdString());
  d.scene.beforeFrame = [this](FrameQuality quality) { impl_->prepareFrame(quality); };
  d.scene.aheadOfFrame = [this](FrameQuality quality) { return quality != FrameQuality::Moving && impl_->updateSection(false); };
  d.lookFrom(Vec3::UnitY(), Vec3::UnitZ());
}

ModelView::~ModelView() {
  makeCurrent();
  impl_->scene.beforeFrame = nullptr;
  impl_->scene.aheadOfFrame = nullptr;
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

namespace {

std::vector<std::size_t> shapeOf(const ResectionPlan& plan) {
  std::vector<std::size_t> shape;
  std::ranges::transform(plan.resections, std::back_inserter(shape), [](const Resection& r) { return r.planes.size(); });
  return shape;
}

}  // namespace

void ModelView::setPlan(ResectionPlan plan, const PlaneChoice& choice) {
  Impl& d = *impl_;
  if (plan == d.plan && choice == d.choice) {
    return;
  }
  if (choice != d.choice || !d.plane) {
    d.spun = 0;
  }
  if (choice != d.choice) {
    d.hoveredPoint.reset();
    d.keyedPoint.reset();
  }
  const bool redraw = shapeOf(plan) != shapeOf(d.plan) || choice != d.choice;
  d.plan = std::move(plan);
  d.choice = choice;
  d.plane.reset();
  if (choice.resection < d.plan.resections.size() && choice.plane < d.plan.resections[choice.resection].planes.size()) {
    d.plane = d.plan.resections[choice.resection].planes[choice.plane];
    d.spun = d.plane->bend ? 0 : d.spun;
  }
  if (redraw) {
    d.showPlan();
  }
  d.measureActors.setMeasures(d.plan.measures);
  if (!d.plane) {
    d.drag.reset();
    d.bendDrag.reset();
    d.hovered.reset();
    d.resectogram->setMap(std::nullopt, {});
  }
  for (const auto& [id, actors] : d.structures) {
    actors->setPlan(d.plan);
  }
  d.sectionStale = true;
  d.scene.touch();
  requestRender();
}

void ModelView::cancelDrag() {
  if (impl_->drag) {
    impl_->spun = impl_->spunFrom;
  }
  impl_->drag.reset();
  impl_->bendDrag.reset();
  impl_->sectionStale = true;
  requestRender();
}

void ModelView::setHandlesShown(bool shown) {
  impl_->handlesShown = shown;
  requestRender();
}

void ModelView::setFullDetail(bool full) {
  impl_->fullDetail = full;
  requestRender();
}

void ModelView::setBending(bool shown, bool group) {
  if (shown != impl_->bending) {
    impl_->hoveredPoint.reset();
    impl_->keyedPoint.reset();
  }
  impl_->bending = shown;
  impl_->bendGroup = group;
  requestRender();
}

void ModelView::chooseControlPoint(int point) {
  impl_->keyedPoint = static_cast<std::size_t>(std::clamp(point, 0, 15));
  requestRender();
}

void ModelView::setMapShown(bool shown) { impl_->resectogram->setUnfolded(shown); }

bool ModelView::mapShown() const { return impl_->resectogram->unfolded(); }

void ModelView::setPlane(const std::optional<ResectionPlane>& plane) {
  ResectionPlan plan;
  if (plane && impl_->plane) {
    plan = impl_->plan;
    plan.resections[impl_->choice.resection].planes[impl_->choice.plane] = *plane;
  } else if (plane) {
    plan.resections.push_back({.name = {}, .planes = {*plane}});
  }
  setPlan(std::move(plan), plane && impl_->plane ? impl_->choice : PlaneChoice{});
}

std::optional<ResectionPlane> ModelView::plane() const { return impl_->plane; }

void ModelView::resizeEvent(QResizeEvent* event) {
  VtkWidget::resizeEvent(event);
  impl_->fitAgain();
  impl_->placeResectogram();
}

void ModelView::setMarginLine(const std::optional<std::pair<Vec3, Vec3>>& line, bool tooShort) {
  impl_->planeActors.setMarginLine(line, tooShort);
  requestRender();
}

void ModelView::setTumours(std::shared_ptr<const TumourDistance> tumours) {
  impl_->tumours = std::move(tumours);
  impl_->sectionStale = true;
  requestRender();
}

void ModelView::setTerritories(std::vector<DrawnTerritory> territories) {
  if (impl_->territoryActors.setTerritories(std::move(territories))) {
    requestRender();
  }
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

Pose ModelView::pose() const { return impl_->scene.pose(); }

void ModelView::setPose(const Pose& pose) {
  Impl& d = *impl_;
  if (pose == this->pose()) {
    return;
  }
  d.scene.setPose(pose);
  d.scene.touch();
  requestRender();
}

ViewCamera ModelView::camera() const { return impl_->scene.camera(width(), height()); }

std::optional<HandleLayout> ModelView::handles() const {
  if (!impl_->plane) {
    return std::nullopt;
  }
  impl_->updateSection(impl_->sectionIsCoarse);
  return impl_->layout();
}

void ModelView::startPick(PickKind kind) {
  if (picking()) {
    cancelPick();
  }
  impl_->pick.emplace(kind);
  impl_->hovered.reset();
  setCursor(Qt::CrossCursor);
  setFocus();
}

void ModelView::cancelPick() {
  if (picking()) {
    endPick();
    emit pickCancelled();
  }
}

bool ModelView::picking() const { return impl_->pick.has_value(); }

void ModelView::endPick() {
  impl_->pick.reset();
  impl_->pickOverlay->clear();
  setCursor(Qt::ArrowCursor);
}

void ModelView::showPick() {
  if (impl_->pick) {
    impl_->pickOverlay->show(impl_->pick->shown(camera()), impl_->pick->takesDrag());
  }
}

std::optional<Vec3> ModelView::surfaceAt(const Pixel& pixel) const {
  const Ray ray = camera().rayAt(pixel);
  std::optional<double> nearest;
  for (const auto& [id, actors] : impl_->structures) {
    const std::optional<double> hit = actors->visible() ? firstHit(actors->mesh(), ray) : std::nullopt;
    if (hit && (!nearest || *hit < *nearest)) {
      nearest = hit;
    }
  }
  return nearest ? std::optional<Vec3>(ray.origin + *nearest * ray.direction) : std::nullopt;
}

void ModelView::mousePressEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (d.pick && event->button() == Qt::LeftButton) {
    d.pick->press({event->position().x(), event->position().y()});
    if (d.pick->takesDrag()) {
      event->accept();
    } else {
      VtkWidget::mousePressEvent(event);
    }
    return;
  }
  const bool shift = event->modifiers() == Qt::ShiftModifier;
  if (event->button() == Qt::LeftButton && d.canBend() && (shift || event->modifiers() == Qt::NoModifier)) {
    const Pixel mouse(event->position().x(), event->position().y());
    if (const auto point = controlPointAt(*d.plane, camera(), mouse)) {
      d.bendDrag.emplace(*d.plane, *point, d.bendGroup || shift, camera(), mouse);
      d.keyedPoint = point;
      event->accept();
      emit controlPointChosen(static_cast<int>(*point));
      emit planeDragStarted();
      return;
    }
  }
  if (event->button() == Qt::LeftButton && d.plane && d.handlesShown && event->modifiers() == Qt::NoModifier) {
    const Pixel mouse(event->position().x(), event->position().y());
    const HandleLayout layout = *handles();
    if (const auto handle = d.planeHandleAt(mouse)) {
      d.drag.emplace(*handle, *d.plane, layout, camera(), mouse);
      d.spunFrom = d.spun;
      event->accept();
      emit planeDragStarted();
      return;
    }
  }
  if (!d.drag && !d.bendDrag) {
    VtkWidget::mousePressEvent(event);
  }
}

void ModelView::mouseMoveEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  const Pixel mouse(event->position().x(), event->position().y());
  if (d.pick) {
    d.pick->move(mouse);
    if (!d.pick->takesDrag()) {
      VtkWidget::mouseMoveEvent(event);
    }
    showPick();
    return;
  }
  if (d.drag || d.bendDrag) {
    const ResectionPlane moved = d.drag ? d.drag->planeAt(mouse) : d.bendDrag->planeAt(mouse);
    if (d.drag && !moved.bend) {
      d.spun = d.spunFrom + d.drag->spunAt(mouse);
      requestRender();
    }
    setPlane(moved);
    event->accept();
    emit planeDragged(moved);
    return;
  }
  if (d.plane && d.handlesShown && event->buttons() == Qt::NoButton) {
    const auto point = d.canBend() ? controlPointAt(*d.plane, camera(), mouse) : std::nullopt;
    const auto handle = point ? std::nullopt : d.planeHandleAt(mouse);
    if (handle != d.hovered || point != d.hoveredPoint) {
      d.hovered = handle;
      d.hoveredPoint = point;
      setCursor(handle || point ? Qt::PointingHandCursor : Qt::ArrowCursor);
      requestRender();
    }
  }
  VtkWidget::mouseMoveEvent(event);
}

void ModelView::mouseReleaseEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (d.pick && event->button() == Qt::LeftButton) {
    if (!d.pick->takesDrag()) {
      VtkWidget::mouseReleaseEvent(event);
    }
    const Pixel at(event->position().x(), event->position().y());
    const std::optional<Pick> pick = d.pick->release(at, camera(), [this](const Pixel& pixel) { return surfaceAt(pixel); });
    showPick();
    if (pick) {
      endPick();
      emit picked(*pick);
    }
    return;
  }
  if (!d.drag && !d.bendDrag) {
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
  if (event->button() == Qt::LeftButton && !picking() && !(impl_->plane && impl_->planeHandleAt(mouse))) {
    event->accept();
    emit maximiseRequested();
  }
}

void ModelView::leaveEvent(QEvent* event) {
  if ((impl_->hovered || impl_->hoveredPoint) && !impl_->drag && !impl_->bendDrag) {
    impl_->hovered.reset();
    impl_->hoveredPoint.reset();
    requestRender();
  }
  VtkWidget::leaveEvent(event);
}

void ModelView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && impl_) {
    setAccessibleName(tr("3D view"));
    impl_->planeActors.setLabel(tr("resected").toStdString());
    impl_->placeResectogram();
    requestRender();
  }
  VtkWidget::changeEvent(event);
}

}  // namespace glisson
