#include "app/gui/screenshot.h"

#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/gui/main_window.h"
#include "app/gui/plane_placer.h"
#include "app/gui/sentences.h"
#include "app/gui/territory_estimator.h"
#include "app/gui/view_area.h"
#include "reconstruction/errors.h"

namespace glisson {

QImage pictureOf(MainWindow& window) {
  QImage picture = window.grab().toImage();
  QPainter painter(&picture);
  for (VtkWidget* view : window.findChildren<VtkWidget*>()) {
    if (view->isVisible()) {
      painter.drawImage(QRect(view->mapTo(&window, QPoint(0, 0)), view->size()), view->picture());
      for (QWidget* over : view->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        if (over->isVisible()) {
          over->render(&painter, over->mapTo(&window, QPoint(0, 0)), {}, QWidget::DrawChildren);
        }
      }
    }
  }
  return picture;
}

ScreenshotTaker::ScreenshotTaker(MainWindow& window, JobRunner& jobs, What what)
    : QObject(&window), window_(window), jobs_(jobs), what_(std::move(what)) {
  connect(&jobs_, &JobRunner::becameIdle, this, &ScreenshotTaker::proceed, Qt::QueuedConnection);
  connect(&window_, &MainWindow::failed, this,
          [this](const QString& message) { finish(window_.document().isOpen() && !reporting_ ? 4 : 3, message); });
  connect(&window_, &MainWindow::reportWritten, this, [this] { finish(0, {}); });
}

void ScreenshotTaker::proceed() {
  Document& document = window_.document();
  if (finished_ || reporting_ || !jobs_.idle() || !document.isOpen()) {
    return;
  }
  if (window_.builder().missing() > 0) {
    finish(4, tr("%1 structures could not be reconstructed.").arg(window_.builder().missing()));
    return;
  }
  choosePlan();
  if (finished_) {
    return;
  }
  if (std::exchange(what_.placePlane, false) && !document.plane()) {
    window_.placer().placeAsSeen();
  }
  if (!document.content().territories.marks.empty() && window_.territories().state() == TerritoryEstimator::State::None &&
      !std::exchange(estimated_, true)) {
    window_.territories().estimate();
  }
  if (finished_ || !jobs_.idle()) {
    return;  // computed in jobs, whose end comes back here
  }
  window_.workspaces().setCurrent(Workspace::Plan);
  // two turns of the event loop: layouts settle, then the views draw what they were told
  QTimer::singleShot(0, this, [this] { QTimer::singleShot(200, this, &ScreenshotTaker::write); });
}

void ScreenshotTaker::choosePlan() {
  const QString name = std::exchange(what_.plan, {});
  if (name.isEmpty()) {
    return;
  }
  const std::vector<ResectionPlan>& plans = window_.document().content().plans;
  const auto found = std::ranges::find(plans, name.toStdString(), &ResectionPlan::name);
  if (found != plans.end()) {
    window_.document().choose({static_cast<std::size_t>(found - plans.begin()), 0, 0});
    return;
  }
  QStringList names;
  for (const ResectionPlan& plan : plans) {
    names << QString::fromStdString(plan.name);
  }
  finish(2, tr("The case has no plan \"%1\"; it has: %2.").arg(name, names.join(QStringLiteral(", "))));
}

void ScreenshotTaker::write() {
  if (!what_.picture.isEmpty() && !pictureOf(window_).save(what_.picture, "PNG")) {
    finish(3, tr("%1 cannot be written; check the folder.").arg(what_.picture));
    return;
  }
  if (what_.report.isEmpty()) {
    finish(0, {});
    return;
  }
  reporting_ = true;  // reportWritten() ends it
  try {
    window_.writeReport(what_.report, what_.withIdentity);
  } catch (const Error& error) {
    finish(3, shownSentence(messageOf(error)));
  }
}

void ScreenshotTaker::finish(int exitCode, const QString& message) {
  if (!std::exchange(finished_, true)) {
    emit done(exitCode, message);
  }
}

}  // namespace glisson
