#include "app/gui/plan_panel.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/big_number.h"
#include "app/gui/flr_card_box.h"
#include "app/gui/island_box.h"
#include "app/gui/measure_box.h"
#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/plan_bar.h"
#include "app/gui/plane_editor.h"
#include "app/gui/sentences.h"
#include "app/gui/territory_box.h"
#include "app/gui/tumour_box.h"
#include "planning/report/compare_plans.h"
#include "planning/report/decisive_tumour.h"

namespace glisson {

namespace {

constexpr int kVesselRows = 5;  ///< always: their number changes while the plane moves, and nothing below may jump
constexpr int kMostTumourRows = 6;
constexpr int kMostResectionRows = 4;

QTreeWidget* makeTable(const QString& name, int columns, QWidget* parent) {
  auto* table = new QTreeWidget(parent);
  table->setObjectName(name);
  makeNarrow(*table, columns);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setTextElideMode(Qt::ElideMiddle);  // livertumor01 and livertumor02 differ at the end
  return table;
}

/// A column of labels whose heights depend on its width: as high as they need, so that a scroll area cuts nothing off.
class Column : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  bool event(QEvent* event) override {
    const bool taken = QWidget::event(event);
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) {
      setMinimumHeight(layout()->minimumHeightForWidth(width()));
    }
    return taken;
  }
};

/// ">= 6.9"; empty where there is no lower bound.
QString atLeastText(const TumourAssessment& tumour) {
  return tumour.marginAtLeastMm ? QStringLiteral("\u2265\u00A0") + numberText(*tumour.marginAtLeastMm, 1) : QString();
}

/// "L -34.0, P 68.0, S 350.0 mm".
QString lpsText(const Vec3& at) {
  return QStringLiteral("L\u00A0%1, P\u00A0%2, S\u00A0%3").arg(numberText(at.x(), 1), numberText(at.y(), 1), mmText(at.z()));
}

QString marginText(const TumourAssessment& tumour) {
  if (tumour.marginMm) {
    // the unit stands in the header: the column is narrow
    const QString margin = numberText(*tumour.marginMm, 1);
    return tumour.marginAtLeastMm ? QStringLiteral("%1 (%2)").arg(margin, atLeastText(tumour)) : margin;
  }
  return QStringLiteral("-");
}

QString marginNotice() { return shownSentence(std::string(kMarginNotice)); }

QString marginTip(const TumourAssessment& tumour) {
  if (tumour.marginMm) {
    return tumour.marginAtLeastMm ? PlanPanel::tr("%1, at least %2").arg(mmText(*tumour.marginMm), mmText(*tumour.marginAtLeastMm))
                                  : mmText(*tumour.marginMm);
  }
  return tumour.distanceMm ? PlanPanel::tr("%1 from the cut; a tumour that is left has no margin").arg(mmText(*tumour.distanceMm))
                           : QString();
}

/// "7.8 mm, >= 6.9".
QString shortMargin(const TumourAssessment& tumour) {
  if (!tumour.marginMm) {
    return QStringLiteral("-");
  }
  const QString margin = mmText(*tumour.marginMm);
  return tumour.marginAtLeastMm ? QStringLiteral("%1, %2").arg(margin, atLeastText(tumour)) : margin;
}

}  // namespace

QString stateText(TumourState state) {
  switch (state) {
    case TumourState::Removed:
      return PlanPanel::tr("removed");
    case TumourState::Cut:
      return PlanPanel::tr("cut");
    case TumourState::Left:
      break;
  }
  return PlanPanel::tr("left");
}

QString crossedText(const VesselCrossing& vessel) {
  return vessel.runsAlong ? PlanPanel::tr("%1, along the cut").arg(shownName(vessel.name)) : shownName(vessel.name);
}

QStringList tumourNames(const PlanAssessment& assessment, TumourState state) {
  QStringList names;
  for (const TumourAssessment& tumour : assessment.tumours) {
    if (!tumour.isCyst && tumour.state == state) {
      names << shownName(tumour.name);
    }
  }
  return names;
}

PlanPanel::PlanPanel(JobRunner& jobs, Document& document, TerritoryEstimator& territories, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      bar_(new PlanBar(document, this)),
      flr_(new BigNumber("flr", 1.8, this)),
      resected_(new BigNumber("resected", 1.8, this)),
      remnant_(new BigNumber("remnant", 1.2, this)),
      margin_(new BigNumber("margin", 1.8, this)),
      warning_(new QLabel(this)),
      uncertainty_(new QLabel(this)),
      resections_(makeTable("resectionTable", 3, this)),
      editor_(new PlaneEditor(this)),
      tumoursLabel_(new QLabel(this)),
      tumours_(makeTable("tumourTable", 3, this)),
      marginNotice_(new QLabel(this)),
      vesselsLabel_(new QLabel(this)),
      vessels_(makeTable("vesselTable", 2, this)),
      islands_(new IslandBox(document, this)),
      measures_(new MeasureBox(document, this)),
      territories_(new TerritoryBox(document, territories, this)),
      sizes_(new TumourBox(jobs, document, territories, this)),
      card_(new FlrCardBox(document, this)) {
  setObjectName("planPanel");
  warning_->setObjectName("planWarning");
  warning_->setWordWrap(true);
  uncertainty_->setObjectName("volumeNote");
  uncertainty_->setWordWrap(true);
  marginNotice_->setObjectName("marginNotice");
  marginNotice_->setWordWrap(true);
  vesselsLabel_->setObjectName("vesselsTitle");
  vesselsLabel_->setWordWrap(true);

  auto* content = new Column(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(3);
  for (QWidget* part : std::initializer_list<QWidget*>{bar_, flr_, resected_, margin_, remnant_, uncertainty_, resections_,
                                                       warning_, editor_, tumoursLabel_, tumours_, marginNotice_, vesselsLabel_,
                                                       vessels_, islands_, card_, territories_, sizes_, measures_}) {
    column->addWidget(part);
  }
  column->addStretch(1);
  fitRows(*vessels_, kVesselRows);
  vessels_->setSelectionMode(QAbstractItemView::SingleSelection);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);

  // The wheel scrolls the panel; numbers change by it only where the user has clicked into them.
  const auto keepWheel = [this](const auto& fields) {
    for (QWidget* field : fields) {
      field->setFocusPolicy(Qt::StrongFocus);
      field->installEventFilter(this);
    }
  };
  keepWheel(content->findChildren<QAbstractSpinBox*>());
  keepWheel(content->findChildren<QComboBox*>());

  connect(vessels_, &QTreeWidget::itemClicked, this, &PlanPanel::chooseCrossing);
  connect(vessels_, &QTreeWidget::itemActivated, this, &PlanPanel::chooseCrossing);
  connect(&document_, &Document::assessmentChanged, this, &PlanPanel::refresh);
  connect(&document_, &Document::planChanged, this, &PlanPanel::refreshPlane);
  connect(&document_, &Document::caseChanged, this, &PlanPanel::refresh);
  retranslateUi();
}

bool PlanPanel::eventFilter(QObject* watched, QEvent* event) {
  const auto* field = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && field != nullptr && !field->hasFocus()) {
    event->ignore();  // goes on to the scroll area
    return true;
  }
  return Translated<QWidget>::eventFilter(watched, event);
}

void PlanPanel::retranslateUi() {
  flr_->setCaption(tr("FLR"));
  flr_->setToolTip(tr("Future liver remnant: functional liver left, and its share of the functional liver"));
  resected_->setCaption(tr("RESECTED"));
  resected_->setToolTip(tr("Volume on the resected side, and its share of the whole liver"));
  remnant_->setCaption(tr("REMNANT"));
  remnant_->setToolTip(tr("Volume left, tumours in it included, and its share of the whole liver"));
  tumoursLabel_->setText(tr("Tumours"));
  vesselsLabel_->setText(tr("Vessels crossed"));
  marginNotice_->setText(marginNotice());
  tumours_->setHeaderLabels({tr("Tumour"), tr("State"), tr("Margin, mm")});
  vessels_->setHeaderLabels({tr("Vessel"), tr("Diameter")});
  resections_->setHeaderLabels({tr("Resection"), tr("Volume"), tr("Cut")});
  resections_->headerItem()->setToolTip(1, tr("As the planes leave it, without separated pieces given to the other side"));
  resections_->headerItem()->setToolTip(2, tr("Area of the cut"));
  refresh();
  refreshPlane();
}

void PlanPanel::refresh() {
  refreshVolumes();
  refreshResections();
  refreshMargin();
  refreshTables();
  refreshPlacing();
}

void PlanPanel::refreshVolumes() {
  const bool known = document_.freshness() != Freshness::None;
  const PlanAssessment& now = document_.assessment();
  const QString missing = document_.isOpen() && !known ? tr("computing") : QString();
  const auto show = [&](BigNumber& number, double ml, double percent) {
    number.setNote(missing);
    const bool stands = known && now.divides;
    number.setValue(stands ? mlText(ml) : QStringLiteral("- mL"), stands ? percentText(percent) : QStringLiteral("- %"));
  };
  show(*flr_, now.functionalRemnantMl, now.flrPercent);
  show(*resected_, now.resectedMl, now.totalMl > 0 ? 100 * now.resectedMl / now.totalMl : 0);
  show(*remnant_, now.remnantMl, now.totalMl > 0 ? 100 * now.remnantMl / now.totalMl : 0);
  uncertainty_->setVisible(known);
  const QString liver = tr("Liver %1, functional %2").arg(mlText(now.totalMl), mlText(now.functionalMl));
  const bool cut = document_.plane() && now.divides;
  uncertainty_->setText(cut ? tr("%1, uncertainty of the cut \u00B1%2, area of the cut %3")
                                  .arg(liver, mlText(now.volumeUncertaintyMl, 1), areaText(cutAreaMm2(now)))
                            : liver);
  const QString warning = shownSentence(now.warning);
  warning_->setVisible(known && !warning.isEmpty());
  warning_->setText(warning);
}

/// Of a plan with several resections; one has the plan's own numbers.
void PlanPanel::refreshResections() {
  const PlanAssessment& now = document_.assessment();
  const bool shown = document_.freshness() != Freshness::None && document_.plane() && now.divides && now.resections.size() > 1;
  resections_->clear();
  resections_->setVisible(shown);
  if (!shown) {
    return;
  }
  for (const ResectionVolume& resection : now.resections) {
    auto* row =
        new QTreeWidgetItem(resections_, {shownName(resection.name), mlText(resection.volumeMl), areaText(resection.cutAreaMm2)});
    row->setToolTip(0, row->text(0));
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  }
  fitRows(*resections_, std::min(resections_->topLevelItemCount(), kMostResectionRows));
}

/// Why there is no margin and no vessel to speak of; empty where there are.
QString PlanPanel::missingNumbers() const {
  if (!document_.plane()) {
    return tr("no plane");
  }
  if (document_.freshness() == Freshness::None) {
    return tr("computing");
  }
  return document_.assessment().divides ? QString() : tr("the liver is not divided");
}

void PlanPanel::refreshMargin() {
  const PlanAssessment& now = document_.assessment();
  const TumourAssessment* tumour = decisiveTumour(now);
  const bool computed = document_.freshness() == Freshness::All;
  QString reason = missingNumbers();
  if (reason.isEmpty() && tumour == nullptr) {
    reason = computed ? tr("no tumour") : tr("computing");
  }
  margin_->setOutOfDate({});
  margin_->setWarning({});
  margin_->setNote({});
  margin_->setToolTip(marginNotice());
  if (!reason.isEmpty()) {
    margin_->setCaption(tr("MARGIN"));
    margin_->setValue(QStringLiteral("- mm"), {});
    margin_->setNote(document_.isOpen() ? reason : QString());
    return;
  }
  if (tumour->state != TumourState::Cut && tumourCounts(now).left > 0) {
    showTumoursLeft(*tumour);
  } else {
    showMarginOf(*tumour);
  }
  if (!computed) {
    margin_->setOutOfDate(tr("out of date"));
  }
}

/// A margin of what is removed would reassure while tumours stay: their number is the large one.
void PlanPanel::showTumoursLeft(const TumourAssessment& decisive) {
  const PlanAssessment& now = document_.assessment();
  const TumourCounts counts = tumourCounts(now);
  const QStringList names = tumourNames(now, TumourState::Left);
  margin_->setCaption(decisive.marginMm ? tr("TUMOURS, margin of the removed %1").arg(shortMargin(decisive))
                                        : tr("TUMOURS, none is removed"));
  margin_->setValue(tr("%1 of %2").arg(counts.left).arg(counts.all()), stateText(TumourState::Left));
  margin_->setWarning(QStringLiteral("\u26A0 ") + tr("in the remnant"));
  margin_->setToolTip(tr("Tumours in the remnant, which have no margin: %1").arg(names.join(QStringLiteral(", "))) +
                      QStringLiteral("\n") + marginNotice());
}

void PlanPanel::showMarginOf(const TumourAssessment& tumour) {
  const double safetyMm = document_.plan().safetyMarginMm;
  const TumourCounts counts = tumourCounts(document_.assessment());
  margin_->setCaption(tr("MARGIN %1, %2").arg(shownName(tumour.name), stateText(tumour.state)));
  margin_->setValue(tumour.marginMm ? mmText(*tumour.marginMm) : QStringLiteral("- mm"), atLeastText(tumour));
  if (tumour.state == TumourState::Cut) {
    margin_->setWarning(QStringLiteral("\u26A0 ") + (counts.left > 0  ? tr("is cut, %1 left").arg(counts.left)
                                                     : counts.cut > 1 ? tr("%1 tumours are cut").arg(counts.cut)
                                                                      : tr("tumour is cut")));
  } else if (tumour.marginAtLeastMm.value_or(tumour.marginMm.value_or(0.0)) < safetyMm) {
    margin_->setWarning(tr("below %1").arg(mmText(safetyMm, 0)));
  }
}

void PlanPanel::refreshTables() {
  const PlanAssessment& now = document_.assessment();
  const bool computed = document_.freshness() == Freshness::All;
  const QString missing = missingNumbers();
  tumours_->clear();
  vessels_->clear();
  if (document_.isOpen() && missing.isEmpty()) {
    for (const TumourAssessment& tumour : now.tumours) {
      auto* row = new QTreeWidgetItem(tumours_, {shownName(tumour.name), stateText(tumour.state), marginText(tumour)});
      row->setToolTip(0, row->text(0));
      row->setToolTip(2, marginTip(tumour) + QStringLiteral("\n") + marginNotice());
    }
    for (const VesselCrossing& vessel : now.vesselsCrossed) {
      auto* row = new QTreeWidgetItem(vessels_, {crossedText(vessel), mmText(vessel.diameterMm)});
      const QString where = tr("at %1; a click shows it in the slices").arg(lpsText(vessel.positionMm));
      row->setToolTip(0, row->text(0) + QStringLiteral("\n") + where);
      row->setToolTip(1, where);
      row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  const auto grey = [&](QTreeWidget* table) {
    table->setEnabled(computed);
    table->setToolTip(computed ? QString() : tr("Out of date until the plane rests"));
  };
  grey(tumours_);
  grey(vessels_);
  fitRows(*tumours_, std::min(tumours_->topLevelItemCount(), kMostTumourRows));
  marginNotice_->setVisible(tumours_->topLevelItemCount() > 0);
  const bool counted = computed && missing.isEmpty();
  vesselsLabel_->setText(counted                                    ? tr("Vessels crossed: %1").arg(now.vesselsCrossed.size())
                         : document_.isOpen() && !missing.isEmpty() ? tr("Vessels crossed: -, %1").arg(missing)
                                                                    : tr("Vessels crossed"));
}

void PlanPanel::chooseCrossing(QTreeWidgetItem* row) {
  const std::vector<VesselCrossing>& crossed = document_.assessment().vesselsCrossed;
  const int at = vessels_->indexOfTopLevelItem(row);
  if (at >= 0 && static_cast<std::size_t>(at) < crossed.size()) {
    emit crossingChosen(crossed[static_cast<std::size_t>(at)].positionMm);
  }
}

void PlanPanel::refreshPlane() { editor_->setPlane(document_.plane()); }

void PlanPanel::refreshPlacing() {
  QString refusal;
  if (!document_.isOpen()) {
    refusal = tr("Open a case first.");
  } else if (!document_.liverCentre() && document_.isPreparingVolumes()) {
    refusal = tr("The liver's volumes are being computed.");
  }
  editor_->setPlaceRefusal(refusal);
}

}  // namespace glisson
