#include "app/gui/job_bar.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/sentences.h"

namespace glisson {

namespace {

constexpr int kNewsMilliseconds = 6000;
constexpr int kNameWidth = 150;      ///< of several names
constexpr int kOnlyNameWidth = 300;  ///< where one alone runs
constexpr int kProgressWidth = 90;
constexpr int kMostListHeight = 320;  ///< more rows scroll

/// QProgressBar::setValue() paints the whole window before it returns, 3D view included; this leaves it to the next turn of the
/// event loop, once for all that has changed until then.
void showPercent(QProgressBar& bar, int percent) {
  if (bar.maximum() != 100 || bar.value() != percent) {
    bar.setUpdatesEnabled(false);
    bar.setRange(0, 100);
    bar.setValue(percent);
    bar.setUpdatesEnabled(true);
  }
}

}  // namespace

JobBar::JobBar(JobRunner& jobs, QWidget* parent)
    : Translated<QWidget>(parent),
      jobs_(jobs),
      runningRows_(new QHBoxLayout),
      waiting_(new QToolButton(this)),
      waitingList_(new QFrame(this, Qt::Popup)),
      waitingContent_(new QWidget),
      waitingRows_(new QVBoxLayout(waitingContent_)),
      cancelAll_(new QPushButton(this)),
      news_(new QLabel(this)),
      mouse_(new QLabel(this)),
      notClinical_(new QLabel(this)) {
  setObjectName("jobBar");
  waiting_->setObjectName("waitingJobs");
  waiting_->setArrowType(Qt::UpArrow);
  waiting_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  cancelAll_->setObjectName("cancelAll");
  news_->setObjectName("jobNews");
  notClinical_->setObjectName("notForClinicalUse");
  buildWaitingList();
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(6, 2, 6, 2);
  line->addLayout(runningRows_);
  line->addWidget(waiting_);
  line->addWidget(cancelAll_);
  line->addWidget(news_, 1);
  line->addWidget(mouse_);
  line->addSpacing(12);
  line->addWidget(notClinical_);
  news_->setMinimumWidth(1);
  // as high as with a job's Cancel: the views must not change their size with every job that starts or ends
  setMinimumHeight(std::max(cancelAll_->sizeHint().height(), waiting_->sizeHint().height()) + line->contentsMargins().top() +
                   line->contentsMargins().bottom());
  newsEnds_.setSingleShot(true);
  connect(&newsEnds_, &QTimer::timeout, news_, &QLabel::clear);
  connect(waiting_, &QToolButton::clicked, this, &JobBar::openWaitingList);
  connect(cancelAll_, &QPushButton::clicked, &jobs_, &JobRunner::cancelAll);
  connect(&jobs_, &JobRunner::jobAdded, this, [this](JobId id, const QString& title, bool quiet) {
    if (!quiet) {
      addRow(id, title);
    }
  });
  connect(&jobs_, &JobRunner::jobStarted, this, &JobBar::showRunning);
  connect(&jobs_, &JobRunner::jobProgressed, this, [this](JobId id, double fraction, const QString& phase) {
    const auto row = rows_.constFind(id);
    if (row != rows_.constEnd()) {
      showPercent(*row->progress, qRound(fraction * 100));
      row->progress->setToolTip(shownSentence(phase));
    }
  });
  connect(&jobs_, &JobRunner::jobEnded, this, &JobBar::removeRow);
  JobBar::retranslateUi();
}

void JobBar::buildWaitingList() {
  waitingList_->setObjectName("waitingList");
  waitingList_->setFrameShape(QFrame::StyledPanel);
  waitingRows_->setContentsMargins(4, 4, 4, 4);
  waitingRows_->setSpacing(2);
  auto* scroll = new QScrollArea(waitingList_);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(waitingContent_);
  auto* column = new QVBoxLayout(waitingList_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll);
}

void JobBar::retranslateUi() {
  cancelAll_->setText(tr("Cancel all"));
  mouse_->setText(tr("3D: left turns, middle pans, right zooms"));
  mouse_->setToolTip(
      tr("Slices: wheel steps, left click places the crosshair, right zooms, middle pans, Ctrl+right changes the window"));
  notClinical_->setText(tr("Not for clinical use"));
  waiting_->setToolTip(tr("Shows what waits, each with its Cancel"));
  for (const Row& row : rows_) {
    row.cancel->setText(tr("Cancel"));
  }
  refresh();
}

void JobBar::addRow(JobId id, const QString& title) {
  Row row;
  row.box = new QWidget(waitingContent_);
  auto* line = new QHBoxLayout(row.box);
  line->setContentsMargins(0, 0, 8, 0);
  row.name = new QLabel(row.box);
  row.name->setObjectName("jobName");
  row.name->setToolTip(title);
  row.progress = new QProgressBar(row.box);
  row.progress->setRange(0, 100);
  row.progress->setValue(0);
  row.progress->setFixedWidth(kProgressWidth);
  row.cancel = new QPushButton(tr("Cancel"), row.box);
  row.cancel->setObjectName("cancelJob");
  connect(row.cancel, &QPushButton::clicked, this, [this, id] { jobs_.cancel(id); });
  line->addWidget(row.name, 1);
  line->addWidget(row.progress);
  line->addWidget(row.cancel);
  waitingRows_->addWidget(row.box);
  rows_.insert(id, row);
  refresh();
}

void JobBar::showRunning(JobId id) {
  const auto row = rows_.find(id);
  if (row == rows_.end()) {
    return;
  }
  row->running = true;
  row->progress->setRange(0, 0);  // busy until it tells how far it is
  waitingRows_->removeWidget(row->box);
  runningRows_->addWidget(row->box);
  row->box->show();
  refresh();
}

void JobBar::removeRow(JobId id) {
  const Row row = rows_.take(id);
  if (row.box != nullptr) {
    row.box->hide();
    row.box->deleteLater();  // its own Cancel may be on the stack
  }
  refresh();
}

void JobBar::openWaitingList() {
  fitWaitingList();
  waitingList_->show();
}

/// As high as its rows, up to a limit, standing on the button that opens it.
void JobBar::fitWaitingList() {
  waitingRows_->activate();
  const QSize rows = waitingContent_->sizeHint();
  const int frame = 2 * waitingList_->frameWidth();
  const int bar = waitingList_->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  waitingList_->setFixedSize(rows.width() + bar + frame, std::min(rows.height() + frame, kMostListHeight));
  const QPoint corner = waiting_->mapToGlobal(QPoint(0, -waitingList_->height()));
  waitingList_->move(std::max(0, corner.x()), std::max(0, corner.y()));
}

int JobBar::waitingCount() const {
  return static_cast<int>(std::ranges::count_if(rows_, [](const Row& row) { return !row.running; }));
}

void JobBar::tell(const QString& text) {
  news_->setText(text);
  newsEnds_.start(kNewsMilliseconds);
}

void JobBar::refresh() {
  const int waiting = waitingCount();
  const int width = rows_.size() > 1 ? kNameWidth : kOnlyNameWidth;
  for (const Row& row : rows_) {  // the whole title is the tooltip
    row.name->setText(fontMetrics().elidedText(row.name->toolTip(), Qt::ElideMiddle, width));
  }
  waiting_->setVisible(waiting > 0);
  waiting_->setText(tr("%1 waiting").arg(waiting));
  if (waiting == 0) {
    waitingList_->hide();
  } else if (waitingList_->isVisible()) {
    fitWaitingList();
  }
  cancelAll_->setVisible(rows_.size() > 1);
  mouse_->setVisible(waiting == rows_.size());
}

}  // namespace glisson
