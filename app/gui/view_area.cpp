#include "app/gui/view_area.h"

#include <QGridLayout>
#include <algorithm>
#include <iterator>

#include "app/gui/sentences.h"
#include "planning/report/decisive_tumour.h"

namespace glisson {

namespace {

bool needsMesh(const Structure& structure, const std::vector<std::shared_ptr<const DisplayMesh>>& ready) {
  return structure.reconstruction && !structure.reconstruction->mesh.empty() &&
         std::ranges::none_of(ready, [&](const auto& mesh) { return &sourceOf(*mesh) == structure.reconstruction.get(); });
}

}  // namespace

ViewArea::ViewArea(Document& document, JobRunner& jobs, QWidget* parent)
    : Translated<QWidget>(parent), document_(document), jobs_(jobs), grid_(new QGridLayout(this)), modelView_(new ModelView(this)) {
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
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId id, JobState state) {
    if (id == preparing_) {
      preparing_ = 0;
      if (state != JobState::Failed) {  // also after "Cancel all": what is built is shown
        showModel();
      }
    }
  });
  connect(modelView_, &ModelView::maximiseRequested, this, [this] { toggleMaximised(modelView_); });
  connect(modelView_, &ModelView::planeDragStarted, &document_, &Document::beginDrag);
  connect(modelView_, &ModelView::planeDragged, &document_, &Document::dragTo);
  connect(modelView_, &ModelView::planeDragFinished, &document_, &Document::endDrag);
  connect(&document_, &Document::dragCancelled, modelView_, &ModelView::cancelDrag);
  connect(&document_, &Document::caseChanged, this, &ViewArea::showVolumes);
  connect(&document_, &Document::ctChanged, this, &ViewArea::showVolumes);
  connect(&document_, &Document::modelChanged, this, &ViewArea::showModel);
  connect(&document_, &Document::planChanged, this, &ViewArea::showPlane);
  connect(&document_, &Document::assessmentChanged, this, &ViewArea::showMargin);
  connect(&document_, &Document::caseChanged, this, [this] { modelView_->setTumours(nullptr); });
  connect(&document_, &Document::tumourDistanceChanged, this, [this] { modelView_->setTumours(document_.tumourDistance()); });
}

void ViewArea::retranslateUi() {
  for (SliceView* slice : slices_) {
    slice->setNoCt(shownSentence(document_.noCt()));
  }
}

void ViewArea::setWindowLevel(const WindowLevel& windowLevel) {
  for (SliceView* slice : slices_) {
    slice->setWindowLevel(windowLevel);
  }
}

void ViewArea::setCrosshair(const Vec3& worldMm) {
  crosshair_ = worldMm;
  for (SliceView* slice : slices_) {
    slice->setCrosshair(worldMm);
  }
}

void ViewArea::showVolumes() {
  const Case& content = document_.content();
  for (SliceView* slice : slices_) {
    slice->setVolumes(content.ct, content.segmentation, content.liver);
    slice->setNoCt(shownSentence(document_.noCt()));
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
  for (SliceView* slice : slices_) {
    slice->setModel(model);
  }
  std::erase_if(ready_, [&](const auto& mesh) {
    return !model || std::ranges::none_of(model->structures, [&](const Structure& structure) {
      return structure.reconstruction.get() == &sourceOf(*mesh);
    });
  });
  if (!model) {
    modelView_->setModel(nullptr);
    return;
  }
  // surfaces that are not ready yet appear as soon as they are: making them ready is no work for the UI thread
  auto shown = std::make_shared<LiverModel>(*model);
  for (Structure& structure : shown->structures) {
    if (needsMesh(structure, ready_)) {
      structure.reconstruction.reset();
    }
  }
  modelView_->setModel(std::move(shown), ready_);
  prepareMeshes();
}

void ViewArea::prepareMeshes() {
  std::vector<std::shared_ptr<const Reconstruction>> wanted;
  for (const Structure& structure : document_.content().model->structures) {
    if (needsMesh(structure, ready_)) {
      wanted.push_back(structure.reconstruction);
    }
  }
  if (preparing_ != 0 || wanted.empty()) {
    return;
  }
  JobRequest request{.quiet = true};
  using Meshes = std::vector<std::shared_ptr<const DisplayMesh>>;
  preparing_ = submitFor<Meshes>(
      jobs_, std::move(request),
      [wanted](const ExecutionContext&) {
        Meshes made;
        std::ranges::transform(wanted, std::back_inserter(made), makeDisplayMesh);
        return made;
      },
      [this](const Meshes& made) { ready_.insert(ready_.end(), made.begin(), made.end()); });
}

void ViewArea::showPlane() {
  const ChosenPlane& chosen = document_.chosen();
  const std::vector<Resection>& resections = document_.plan().resections;
  modelView_->setPlan(document_.plan(), {chosen.resection, chosen.plane});
  std::vector<ResectionPlane> others;
  for (std::size_t r = 0; r < resections.size(); ++r) {
    for (std::size_t p = 0; p < resections[r].planes.size(); ++p) {
      if (r != chosen.resection || p != chosen.plane) {
        others.push_back(resections[r].planes[p]);
      }
    }
  }
  for (SliceView* slice : slices_) {
    slice->setPlane(document_.plane(), others);
  }
}

void ViewArea::showMargin() {
  const TumourAssessment* tumour =
      document_.freshness() == Freshness::All && document_.plane() ? decisiveTumour(document_.assessment()) : nullptr;
  if (tumour == nullptr || !tumour->way) {
    modelView_->setMarginLine(std::nullopt, false);
    return;
  }
  const bool tooShort = tumour->marginAtLeastMm && *tumour->marginAtLeastMm < document_.plan().safetyMarginMm;
  modelView_->setMarginLine(tumour->way, tooShort);
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
