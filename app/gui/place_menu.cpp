#include "app/gui/place_menu.h"

#include <algorithm>

#include "app/gui/sentences.h"

namespace glisson {

PlaceMenu::PlaceMenu(Document& document, QWidget* parent) : Translated<QMenu>(parent), document_(document), tumours_(nullptr) {
  setObjectName("placeMenu");
  setToolTipsVisible(true);
  constexpr std::array kPicks{"placeAtPoint", "placeThroughPoints", "placeAlongLine"};
  static constexpr std::array kKinds{PickKind::Point, PickKind::ThreePoints, PickKind::Line};
  constexpr std::array kSlices{"placeAxial", "placeCoronal", "placeSagittal"};
  for (std::size_t n = 0; n < 3; ++n) {
    picks_[n] = addAction(QString());
    picks_[n]->setObjectName(kPicks[n]);
    connect(picks_[n], &QAction::triggered, this, [this, n] { emit pickRequested(kKinds[n]); });
  }
  addSeparator();
  for (std::size_t n = 0; n < 3; ++n) {
    slices_[n] = addAction(QString());
    slices_[n]->setObjectName(kSlices[n]);
    connect(slices_[n], &QAction::triggered, this, [this, n] { emit sliceRequested(static_cast<SlicePlane>(n)); });
  }
  addSeparator();
  tumours_ = addMenu(QString());
  tumours_->setObjectName("placeAroundTumour");
  connect(&document_, &Document::caseChanged, this, &PlaceMenu::refresh);
  retranslateUi();
}

void PlaceMenu::retranslateUi() {
  picks_[0]->setText(tr("Through a clicked point, as seen"));
  picks_[1]->setText(tr("Through three clicked points"));
  picks_[2]->setText(tr("Along a line drawn across the view"));
  slices_[0]->setText(tr("Axial, through the crosshair"));
  slices_[1]->setText(tr("Coronal, through the crosshair"));
  slices_[2]->setText(tr("Sagittal, through the crosshair"));
  tumours_->setTitle(tr("Around a tumour, at the safety margin"));
  refresh();
}

void PlaceMenu::refresh() {
  const bool open = document_.isOpen();
  for (QAction* action : actions()) {
    action->setEnabled(open);
    action->setToolTip(open ? QString() : tr("Open a case first."));
  }
  tumours_->clear();
  if (open && document_.content().model) {
    for (const Structure& structure : document_.content().model->structures) {
      if (isLesion(structure.kind)) {
        const QString id = QString::fromStdString(structure.id);
        QAction* action = tumours_->addAction(shownName(structure.name));
        action->setObjectName(QStringLiteral("placeAround_") + id);
        connect(action, &QAction::triggered, this, [this, id] { emit tumourRequested(id); });
      }
    }
  }
  if (tumours_->isEmpty()) {
    tumours_->menuAction()->setEnabled(false);
    tumours_->menuAction()->setToolTip(open ? tr("The case has no tumour.") : tr("Open a case first."));
  }
}

}  // namespace glisson
