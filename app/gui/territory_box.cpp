#include "app/gui/territory_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"

namespace glisson {

namespace {

constexpr int kListHeight = 92;

QString mlOrUnknown(const std::optional<double>& ml) { return ml ? mlText(*ml, 1) : TerritoryBox::tr("not known"); }

}  // namespace

QString territoryName(const std::string& name) {
  if (name == "left") {
    return TerritoryBox::tr("left");
  }
  if (name == "right") {
    return TerritoryBox::tr("right");
  }
  return name == "unassigned" ? TerritoryBox::tr("unassigned") : shownName(name);
}

QString tumourTerritoriesText(const TumourTerritories& tumour) {
  QStringList parts;
  for (const TerritoryShare& share : tumour.shares) {
    parts << QStringLiteral("%1 %2 (%3)").arg(territoryName(share.name), mlText(share.volumeMl, 1), percentText(share.percent));
  }
  return parts.isEmpty() ? TerritoryBox::tr("none of them") : parts.join(QStringLiteral(", "));
}

QString perfusionText(const PerfusionEstimate& effect) {
  if (!effect.isKnown()) {
    return TerritoryBox::tr("Estimate: no vessel inside the liver is labelled, so nothing is known of the remnant's blood.");
  }
  return TerritoryBox::tr("Estimate of the remnant: devascularised %1, congested %2, either %3. FLR without them %4, %5.")
      .arg(mlOrUnknown(effect.devascularisedMl), mlOrUnknown(effect.congestedMl), mlText(effect.devascularisedOrCongestedMl, 1),
           mlText(effect.perfusedFlrMl, 1), percentText(effect.perfusedFlrPercent, 1));
}

TerritoryBox::TerritoryBox(Document& document, TerritoryEstimator& estimator, QWidget* parent)
    : Translated<QGroupBox>(parent),
      document_(document),
      estimator_(estimator),
      estimate_(new QPushButton(this)),
      confirm_(new QPushButton(this)),
      pick_(new QPushButton(this)),
      propose_(new QPushButton(this)),
      parts_(new QTreeWidget(this)),
      perfusion_(new QLabel(this)),
      notes_(new QLabel(this)) {
  setObjectName("territoryBox");
  estimate_->setObjectName("estimateTerritories");
  confirm_->setObjectName("confirmTerritories");
  pick_->setObjectName("pickTerritory");
  propose_->setObjectName("proposeTerritories");
  parts_->setObjectName("territoryTable");
  perfusion_->setObjectName("perfusionText");
  notes_->setObjectName("territoryNotes");
  makeNarrow(*parts_, 3);
  parts_->setSelectionMode(QAbstractItemView::NoSelection);
  parts_->setFixedHeight(kListHeight);
  perfusion_->setWordWrap(true);
  notes_->setWordWrap(true);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(4, 2, 4, 4);
  grid->addWidget(estimate_, 0, 0, 1, 2);
  grid->addWidget(parts_, 1, 0, 1, 2);
  grid->addWidget(confirm_, 2, 0, 1, 2);
  grid->addWidget(pick_, 3, 0);
  grid->addWidget(propose_, 3, 1);
  grid->addWidget(perfusion_, 4, 0, 1, 2);
  grid->addWidget(notes_, 5, 0, 1, 2);

  connect(estimate_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::estimate);
  connect(confirm_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::confirm);
  connect(propose_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::propose);
  connect(pick_, &QPushButton::clicked, this, [this] {
    view_->startPick(PickKind::Branch);
    view_->setFocus();
    emit hint(tr("Click a branch of the portal vein in the 3D view: it and all behind it become a territory. Escape ends."));
  });
  connect(&estimator_, &TerritoryEstimator::changed, this, &TerritoryBox::refresh);
  connect(&document_, &Document::caseChanged, this, &TerritoryBox::refresh);
  retranslateUi();
}

void TerritoryBox::pointIn(ModelView& view) {
  view_ = &view;
  connect(view_, &ModelView::picked, this, [this](const Pick& pick) {
    if (pick.kind == PickKind::Branch) {
      emit hint({});
      estimator_.pick(pick.points.front());
    }
  });
  refreshButtons();
}

void TerritoryBox::retranslateUi() {
  setTitle(tr("Territories (estimates)"));
  estimate_->setText(tr("Estimate territories"));
  confirm_->setText(tr("Left and right are right"));
  pick_->setText(tr("Pick a branch"));
  propose_->setText(tr("Left and right"));
  parts_->setHeaderLabels({tr("Territory"), tr("Volume"), tr("Resected")});
  refresh();
}

void TerritoryBox::refresh() {
  const bool known =
      estimator_.state() == TerritoryEstimator::State::Current || estimator_.state() == TerritoryEstimator::State::Following;
  estimate_->setVisible(!known);
  for (QWidget* part : std::initializer_list<QWidget*>{parts_, pick_, propose_, perfusion_, notes_}) {
    part->setVisible(known);
  }
  confirm_->setVisible(known && estimator_.isProposal());
  parts_->setEnabled(estimator_.report() != nullptr);
  perfusion_->setEnabled(estimator_.report() != nullptr);
  parts_->setToolTip(estimator_.report() != nullptr ? QString() : tr("Out of date until the plane rests"));
  if (estimator_.report() != nullptr) {
    refreshNumbers(*estimator_.report());
  }
  refreshButtons();
}

void TerritoryBox::refreshButtons() {
  QString reason;
  if (!document_.isOpen()) {
    reason = tr("Open a case first.");
  } else if (estimator_.state() == TerritoryEstimator::State::Computing) {
    reason = tr("The vessels' trees are being computed.");
  }
  estimate_->setEnabled(reason.isEmpty());
  estimate_->setToolTip(
      reason.isEmpty() ? tr("Which part of the liver hangs on which branch, and what the plan cuts off from blood") : reason);
  confirm_->setToolTip(tr("You have looked at the proposed left and right and found them right"));
  pick_->setEnabled(view_ != nullptr);
  propose_->setEnabled(estimator_.isPicked());
  propose_->setToolTip(estimator_.isPicked() ? tr("Back to left and right as proposed") : tr("Left and right are shown already."));
}

void TerritoryBox::refreshNumbers(const TerritoryReport& report) {
  parts_->clear();
  for (const TerritoryVolume& part : report.volumes) {
    auto* row = new QTreeWidgetItem(parts_, {territoryName(part.name), mlText(part.volumeMl), mlText(part.resectedMl)});
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    row->setToolTip(0, tr("%1 of it stays").arg(mlText(part.remnantMl, 1)));
  }
  perfusion_->setText(perfusionText(report.effect));
  QStringList notes;
  for (const std::string& note : report.notes) {
    notes << shownSentence(note);
  }
  notes_->setText(notes.join('\n'));
  notes_->setVisible(!notes.isEmpty());
}

}  // namespace glisson
