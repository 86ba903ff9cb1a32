#include "app/gui/lab_table.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace glisson {

LabTable::LabTable(QWidget* parent)
    : Translated<QWidget>(parent),
      model_(new LabTableModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      filter_(new QLineEdit(this)),
      count_(new QLabel(this)),
      view_(new QTableView(this)) {
  setObjectName("labTable");
  filter_->setObjectName("labFilter");
  filter_->setClearButtonEnabled(true);
  view_->setObjectName("labTableView");
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(LabTableModel::kSortRole);
  sorted_->setFilterKeyColumn(-1);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  view_->setModel(sorted_);
  view_->setSortingEnabled(true);
  view_->sortByColumn(0, Qt::AscendingOrder);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setWordWrap(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 6);
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->installEventFilter(this);

  auto* top = new QHBoxLayout;
  top->setContentsMargins(4, 2, 4, 2);
  top->addWidget(filter_);
  top->addWidget(count_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(view_, 1);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->setFilterFixedString(text);
    countRows();
  });
  connect(view_, &QTableView::clicked, this,
          [this](const QModelIndex& index) { choose(index, QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)); });
  connect(view_, &QTableView::customContextMenuRequested, this, [this](const QPoint& at) { choose(view_->indexAt(at), true); });
  retranslateUi();
}

void LabTable::retranslateUi() {
  filter_->setPlaceholderText(tr("Filter: a text that any column holds"));
  model_->retranslate();
  view_->resizeColumnsToContents();
  countRows();
}

void LabTable::countRows() { count_->setText(tr("%1 of %2 models").arg(sorted_->rowCount()).arg(model_->rowCount())); }

void LabTable::setEvaluation(const Evaluation& evaluation, double voxelVolumeMl) {
  const bool first = model_->rowCount() == 0;
  const int at = view_->verticalScrollBar()->value();
  model_->setEvaluation(evaluation, voxelVolumeMl);
  view_->verticalScrollBar()->setValue(at);
  if (first) {
    view_->resizeColumnsToContents();
  }
  view_->resizeColumnToContents(0);  // names of later models are longer
  countRows();
}

void LabTable::choose(const QModelIndex& shown, bool second) {
  const QModelIndex index = sorted_->mapToSource(shown);
  if (index.isValid()) {
    emit chosen(static_cast<std::size_t>(index.row()), second ? 1 : 0);
  }
}

bool LabTable::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      choose(view_->currentIndex(), key->modifiers().testFlag(Qt::ShiftModifier));
      return true;
    }
  }
  return Translated<QWidget>::eventFilter(watched, event);
}

}  // namespace glisson
