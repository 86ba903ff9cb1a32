#include "app/gui/measure_box.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
#include "app/jobs/job_runner.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr int kMeasureListHeight = 72;
}

MeasureBox::MeasureBox(Document& document, QWidget* parent)
    : Translated<QGroupBox>(parent),
      document_(document),
      list_(new QTreeWidget(this)),
      measure_(new QPushButton(this)),
      remove_(new QPushButton(this)) {
  setObjectName("measureBox");
  list_->setObjectName("measureList");
  makeNarrow(*list_, 2);
  list_->setFixedHeight(kMeasureListHeight);
  measure_->setObjectName("measureButton");
  remove_->setObjectName("removeMeasureButton");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 4);
  layout->addWidget(list_);
  auto* row = new QHBoxLayout;
  row->addWidget(measure_);
  row->addWidget(remove_);
  layout->addLayout(row);

  connect(measure_, &QPushButton::clicked, this, [this] {
    view_->startPick(PickKind::TwoPoints);
    view_->setFocus();
    emit hint(tr("Click two points of the model in the 3D view; it can be turned in between. Escape ends."));
  });
  connect(remove_, &QPushButton::clicked, this,
          [this] { document_.edit(RemoveMeasure{static_cast<std::size_t>(list_->indexOfTopLevelItem(list_->currentItem()))}); });
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &MeasureBox::refreshButtons);
  connect(&document_, &Document::planChanged, this, &MeasureBox::refresh);
  connect(&document_, &Document::caseChanged, this, &MeasureBox::refresh);
  retranslateUi();
}

void MeasureBox::pointIn(ModelView& view) {
  view_ = &view;
  connect(view_, &ModelView::picked, this, &MeasureBox::keep);
  refreshButtons();
}

void MeasureBox::keep(const Pick& pick) {
  if (pick.kind != PickKind::TwoPoints) {
    return;
  }
  emit hint({});
  try {
    document_.edit(AddMeasure{{.name = {}, .from = pick.points[0], .to = pick.points[1]}});
  } catch (const Error& error) {
    emit refused(messageOf(error));
  }
}

void MeasureBox::retranslateUi() {
  setTitle(tr("Measured distances"));
  list_->setHeaderLabels({tr("Distance"), tr("Length")});
  measure_->setText(tr("Measure"));
  remove_->setText(tr("Remove"));
  refresh();
}

void MeasureBox::refresh() {
  list_->clear();
  for (const Measure& measure : document_.plan().measures) {
    auto* row = new QTreeWidgetItem(list_, {shownName(measure.name), mmText(measure.mm())});
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  }
  refreshButtons();
}

void MeasureBox::refreshButtons() {
  const bool ready = document_.isOpen() && view_ != nullptr;
  measure_->setEnabled(ready);
  measure_->setToolTip(ready ? tr("Between two points clicked in the 3D view; kept in the plan and its report")
                             : tr("Open a case first."));
  const bool selected = list_->currentItem() != nullptr && list_->currentItem()->isSelected();
  remove_->setEnabled(selected);
  remove_->setToolTip(selected ? QString() : tr("Select a distance in the list first."));
}

}  // namespace glisson
