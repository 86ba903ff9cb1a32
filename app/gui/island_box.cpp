#include "app/gui/island_box.h"

#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/jobs/job_runner.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

constexpr int kIslandListHeight = 72;

PlanSide otherSide(PlanSide side) { return side == PlanSide::Resected ? PlanSide::Remnant : PlanSide::Resected; }

}  // namespace

IslandBox::IslandBox(Document& document, QWidget* parent)
    : Translated<QGroupBox>(parent), document_(document), list_(new QTreeWidget(this)) {
  setObjectName("islandBox");
  list_->setObjectName("islandList");
  makeNarrow(*list_, 2);
  list_->setFixedHeight(kIslandListHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 4);
  layout->addWidget(list_);
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row, int column) {
    if (!refreshing_ && column == 0) {
      // not within the list's own signal: the new numbers fill the list anew
      QMetaObject::invokeMethod(
          this, [this, at = list_->indexOfTopLevelItem(row), away = row->checkState(0) == Qt::Checked] { give(at, away); },
          Qt::QueuedConnection);
    }
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
    if (!refreshing_ && row != nullptr) {
      emit chosen(document_.assessment().islands[static_cast<std::size_t>(list_->indexOfTopLevelItem(row))].point);
    }
  });
  connect(&document_, &Document::assessmentChanged, this, &IslandBox::refresh);
  connect(&document_, &Document::caseChanged, this, &IslandBox::refresh);
  retranslateUi();
}

void IslandBox::retranslateUi() {
  setTitle(tr("Separated pieces"));
  list_->setHeaderLabels({tr("Give to the other side"), tr("Volume")});
  refresh();
}

void IslandBox::refresh() {
  const bool current = document_.isOpen() && !document_.isDragging() && document_.freshness() == Freshness::All;
  const std::vector<IslandAssessment>& islands = document_.assessment().islands;
  list_->setEnabled(current);
  list_->setToolTip(current ? QString() : tr("Out of date until the plane rests"));
  if (document_.isOpen() && !current) {
    return;  // the old ones stay until the plane rests and the new ones are known: the panel does not jump under the mouse
  }
  refreshing_ = true;
  list_->clear();
  if (current) {
    for (const IslandAssessment& island : islands) {
      const QString side = island.side == PlanSide::Resected ? tr("of the resected side") : tr("of the remnant");
      auto* row = new QTreeWidgetItem(list_, {side, mlText(island.volumeMl, 1)});
      row->setCheckState(0, island.assigned ? Qt::Checked : Qt::Unchecked);
      row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
      row->setToolTip(0, tr("%1 of functional liver; a marked piece counts on the other side").arg(mlText(island.functionalMl, 1)));
    }
  }
  setVisible(list_->topLevelItemCount() > 0);
  refreshing_ = false;
}

void IslandBox::give(int index, bool away) {
  const std::vector<IslandAssessment>& islands = document_.assessment().islands;
  if (index < 0 || static_cast<std::size_t>(index) >= islands.size()) {
    return;  // the plan has changed since the click
  }
  const IslandAssessment island = islands[static_cast<std::size_t>(index)];
  try {
    if (away) {
      document_.edit(AssignIsland{{.point = island.point, .to = otherSide(island.side)}});
      return;
    }
    document_.edit(ReleaseIsland{island.assignments});
  } catch (const Error& error) {
    emit refused(messageOf(error));
  }
}

}  // namespace glisson
