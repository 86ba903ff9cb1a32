#include "app/gui/tumour_box.h"

#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
#include "app/gui/territory_box.h"

namespace glisson {

namespace {
constexpr int kListHeight = 110;
}

TumourBox::TumourBox(JobRunner& jobs, Document& document, TerritoryEstimator& estimator, QWidget* parent)
    : Translated<QGroupBox>(parent), jobs_(jobs), document_(document), estimator_(estimator), list_(new QTreeWidget(this)) {
  setObjectName("tumourBox");
  list_->setObjectName("tumourMeasures");
  makeNarrow(*list_, 3);
  list_->setRootIsDecorated(true);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setFixedHeight(kListHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 4);
  layout->addWidget(list_);
  connect(&document_, &Document::caseChanged, this, &TumourBox::measure);
  connect(&estimator_, &TerritoryEstimator::changed, this, &TumourBox::refresh);
  connect(&document_, &Document::territoriesChanged, this, &TumourBox::refresh);
  retranslateUi();
}

void TumourBox::retranslateUi() {
  setTitle(tr("Tumours: size and place"));
  list_->setHeaderLabels({tr("Tumour"), tr("Volume"), tr("Diameter")});
  list_->headerItem()->setToolTip(2, tr("The longest diameter, of the voxels' boxes"));
  refresh();
}

void TumourBox::measure() {
  measured_.clear();
  territories_.clear();
  refresh();
  if (!document_.isOpen()) {
    return;
  }
  using Measured = std::vector<TumourMeasures>;
  submitFor<Measured>(
      jobs_, {.key = "tumourMeasures", .title = tr("Sizes of tumours"), .quiet = true},
      [content = document_.content()](const ExecutionContext& context) { return tumourMeasures(content, context); },
      [this, code = document_.content().code](Measured measured) {
        if (document_.isOpen() && document_.content().code == code) {
          measured_ = std::move(measured);
          refresh();
        }
      });
}

QString TumourBox::territoriesOf(const std::string& id) const {
  const auto found = std::ranges::find(territories_, id, &TumourTerritories::id);
  if (found == territories_.end()) {
    return tr("Territory: not known; estimate territories first.");
  }
  const QString lies = tr("Lies in: %1").arg(tumourTerritoriesText(*found));
  return marks_ == document_.content().territories ? lies : lies + QStringLiteral(" ") + tr("(out of date)");
}

void TumourBox::refresh() {
  if (const TerritoryReport* report = estimator_.report()) {
    territories_ = report->tumours;
    marks_ = document_.content().territories;
  } else if (estimator_.state() == TerritoryEstimator::State::None) {
    territories_.clear();
  }
  QStringList open;
  for (int n = 0; n < list_->topLevelItemCount(); ++n) {
    if (list_->topLevelItem(n)->isExpanded()) {
      open << list_->topLevelItem(n)->data(0, Qt::UserRole).toString();
    }
  }
  list_->clear();
  for (const TumourMeasures& tumour : measured_) {
    auto* row = new QTreeWidgetItem(list_, {shownName(tumour.name), mlText(tumour.volumeMl, 1), mmText(tumour.longestDiameterMm)});
    row->setData(0, Qt::UserRole, QString::fromStdString(tumour.id));
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    const QString capsule = tumour.capsuleBeyondImage
                                ? tr("To the capsule: at least %1, for the liver goes on beyond the image there")
                                : tr("To the capsule: %1");
    const QStringList lines{capsule.arg(mmText(tumour.capsuleMm)),
                            tumour.vesselMm
                                ? tr("Nearest vessel: %1, %2").arg(shownName(tumour.nearestVessel), mmText(*tumour.vesselMm))
                                : tr("Nearest vessel: the case has no vessels."),
                            territoriesOf(tumour.id)};
    for (const QString& line : lines) {
      auto* below = new QTreeWidgetItem(row, {line});
      below->setFirstColumnSpanned(true);
      below->setToolTip(0, line);
    }
    row->setToolTip(0, (QStringList{row->text(0)} + lines).join('\n'));
    row->setExpanded(open.contains(row->data(0, Qt::UserRole).toString()));
  }
  setVisible(list_->topLevelItemCount() > 0);
}

}  // namespace glisson
