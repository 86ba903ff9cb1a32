#include "app/gui/job_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace glisson {

namespace {

constexpr int kNewsMilliseconds = 6000;

}  // namespace

JobBar::JobBar(JobRunner& jobs, QWidget* parent)
    : Translated<QWidget>(parent),
      jobs_(jobs),
      cellRow_(new QHBoxLayout),
      waiting_(new QLabel(this)),
      cancelAll_(new QPushButton(this)),
      news_(new QLabel(this)),
      mouse_(new QLabel(this)),
      notClinical_(new QLabel(this)) {
  setObjectName("jobBar");
  cancelAll_->setObjectName("cancelAll");
  news_->setObjectName("jobNews");
  notClinical_->setObjectName("notForClinicalUse");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addLayout(cellRow_);
  row->addWidget(waiting_);
  row->addWidget(cancelAll_);
  row->addWidget(news_, 1);
  row->addWidget(mouse_);
  row->addSpacing(12);
  row->addWidget(notClinical_);
  news_->setMinimumWidth(1);
  newsEnds_.setSingleShot(true);
  connect(&newsEnds_, &QTimer::timeout, news_, &QLabel::clear);
  connect(cancelAll_, &QPushButton::clicked, &jobs_, &JobRunner::cancelAll);
  connect(&jobs_, &JobRunner::jobAdded, this, [this](JobId id, const QString& title, bool quiet) {
    if (!quiet) {
      queued_.insert(id, title);
      refresh();
    }
  });
  connect(&jobs_, &JobRunner::jobStarted, this, &JobBar::addCell);
  connect(&jobs_, &JobRunner::jobProgressed, this, [this](JobId id, double fraction, const QString& phase) {
    const auto cell = cells_.constFind(id);
    if (cell != cells_.constEnd()) {
      cell->progress->setRange(0, 100);
      cell->progress->setValue(qRound(fraction * 100));
      cell->progress->setToolTip(phase);
    }
  });
  connect(&jobs_, &JobRunner::jobEnded, this, &JobBar::removeCell);
  retranslateUi();
  refresh();
}

void JobBar::retranslateUi() {
  cancelAll_->setText(tr("Cancel all"));
  mouse_->setText(tr("3D: left turns, middle pans, right zooms"));
  mouse_->setToolTip(
      tr("Slices: wheel steps, left click places the crosshair, right zooms, middle pans, Ctrl+right changes the window"));
  notClinical_->setText(tr("Not for clinical use"));
  for (const Cell& cell : cells_) {
    cell.cancel->setText(tr("Cancel"));
  }
  refresh();
}

void JobBar::addCell(JobId id) {
  if (!queued_.contains(id)) {
    return;
  }
  const QString title = queued_.take(id);
  Cell cell;
  cell.box = new QWidget(this);
  auto* row = new QHBoxLayout(cell.box);
  row->setContentsMargins(0, 0, 8, 0);
  auto* name = new QLabel(fontMetrics().elidedText(title, Qt::ElideRight, 150), cell.box);
  name->setToolTip(title);
  cell.progress = new QProgressBar(cell.box);
  cell.progress->setRange(0, 0);
  cell.progress->setFixedWidth(90);
  cell.cancel = new QPushButton(tr("Cancel"), cell.box);
  cell.cancel->setObjectName("cancelJob");
  connect(cell.cancel, &QPushButton::clicked, this, [this, id] { jobs_.cancel(id); });
  row->addWidget(name);
  row->addWidget(cell.progress);
  row->addWidget(cell.cancel);
  cellRow_->addWidget(cell.box);
  cells_.insert(id, cell);
  refresh();
}

void JobBar::removeCell(JobId id) {
  queued_.remove(id);
  const Cell cell = cells_.take(id);
  if (cell.box != nullptr) {
    cell.box->hide();
    cell.box->deleteLater();  // its own Cancel may be on the stack
  }
  refresh();
}

void JobBar::tell(const QString& text) {
  news_->setText(text);
  newsEnds_.start(kNewsMilliseconds);
}

void JobBar::refresh() {
  const bool several = queued_.size() + cells_.size() > 1;
  waiting_->setVisible(!queued_.isEmpty());
  waiting_->setText(tr("%1 waiting").arg(queued_.size()));
  waiting_->setToolTip(queued_.values().join('\n'));
  cancelAll_->setVisible(several);
  mouse_->setVisible(cells_.isEmpty());
}

}  // namespace glisson
