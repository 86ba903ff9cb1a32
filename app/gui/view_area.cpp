#include "app/gui/view_area.h"

#include <QGridLayout>

namespace glisson {

ViewArea::ViewArea(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), grid_(new QGridLayout(this)), modelView_(new ModelView(this)) {
  setObjectName("viewArea");
  setStyleSheet("#viewArea { background: #202020; }");
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(2);
  for (int i = 0; i < 2; ++i) {
    grid_->setRowStretch(i, 1);
    grid_->setColumnStretch(i, 1);
  }
  modelView_->setObjectName("modelView");
  slices_ = {new SliceView(SliceAxis::Axial, this), new SliceView(SliceAxis::Coronal, this),
             new SliceView(SliceAxis::Sagittal, this)};
  slices_[0]->setObjectName("axialView");
  slices_[1]->setObjectName("coronalView");
  slices_[2]->setObjectName("sagittalView");
  grid_->addWidget(slices_[0], 0, 0);
  grid_->addWidget(modelView_, 0, 1);
  grid_->addWidget(slices_[1], 1, 0);
  grid_->addWidget(slices_[2], 1, 1);

  for (SliceView* slice : slices_) {
    connect(slice, &SliceView::crosshairMoved, this, &ViewArea::setCrosshair);
    connect(slice, &SliceView::windowLevelChanged, this, [this](const WindowLevel& windowLevel) {
      setWindowLevel(windowLevel);
      emit windowLevelChanged(windowLevel);
    });
    connect(slice, &SliceView::maximiseRequested, this, [this, slice] { toggleMaximised(slice); });
  }
  connect(modelView_, &ModelView::maximiseRequested, this, [this] { toggleMaximised(modelView_); });
  connect(modelView_, &ModelView::planeDragStarted, &document_, &Document::beginDrag);
  connect(modelView_, &ModelView::planeDragged, &document_, &Document::dragTo);
  connect(modelView_, &ModelView::planeDragFinished, &document_, &Document::endDrag);
  connect(&document_, &Document::caseChanged, this, &ViewArea::showVolumes);
  connect(&document_, &Document::ctChanged, this, &ViewArea::showVolumes);
  connect(&document_, &Document::modelChanged, this, &ViewArea::showModel);
  connect(&document_, &Document::planChanged, this, &ViewArea::showPlane);
}

void ViewArea::setWindowLevel(const WindowLevel& windowLevel) {
  for (SliceView* slice : slices_) {
    slice->setWindowLevel(windowLevel);
  }
}

void ViewArea::setCrosshair(const Vec3& worldMm) {
  for (SliceView* slice : slices_) {
    slice->setCrosshair(worldMm);
  }
}

void ViewArea::showVolumes() {
  const Case& content = document_.content();
  for (SliceView* slice : slices_) {
    slice->setVolumes(content.ct, content.segmentation);
  }
  showModel();
  if (content.liver && !content.liver->liver.empty()) {
    const IndexBox& box = content.liver->liver.box();
    const Vec3 middle(box.first[0] + 0.5 * box.size[0], box.first[1] + 0.5 * box.size[1], box.first[2] + 0.5 * box.size[2]);
    setCrosshair(content.liver->geometry.toWorld(middle));
  }
}

void ViewArea::showModel() {
  const std::shared_ptr<const LiverModel>& model = document_.content().model;
  modelView_->setModel(model);
  for (SliceView* slice : slices_) {
    slice->setModel(model);
  }
}

void ViewArea::showPlane() {
  const std::optional<HalfSpace> plane = document_.plane();
  modelView_->setPlane(plane);
  for (SliceView* slice : slices_) {
    slice->setPlane(plane);
  }
}

void ViewArea::toggleMaximised(QWidget* view) {
  maximised_ = maximised_ == nullptr ? view : nullptr;
  for (QWidget* each : {static_cast<QWidget*>(modelView_), static_cast<QWidget*>(slices_[0]), static_cast<QWidget*>(slices_[1]),
                        static_cast<QWidget*>(slices_[2])}) {
    each->setVisible(maximised_ == nullptr || each == maximised_);
  }
  // a hidden view must not keep its row or column open
  for (int i = 0; i < 2; ++i) {
    grid_->setRowStretch(i, maximised_ == nullptr ? 1 : 0);
    grid_->setColumnStretch(i, maximised_ == nullptr ? 1 : 0);
  }
  view->setFocus();
}

}  // namespace glisson
