#include "app/gui/screenshot.h"

#include <QPainter>
#include <QTimer>

#include "app/gui/main_window.h"
#include "app/gui/plane_placer.h"
#include "app/gui/sentences.h"
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

ScreenshotTaker::ScreenshotTaker(MainWindow& window, JobRunner& jobs, QString picture, QString report, bool placePlane,
                                 bool withIdentity)
    : QObject(&window),
      window_(window),
      jobs_(jobs),
      picture_(std::move(picture)),
      report_(std::move(report)),
      placePlane_(placePlane),
      withIdentity_(withIdentity) {
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
  if (placePlane_ && !document.plane()) {
    placePlane_ = false;
    window_.placer().placeAsSeen();
    if (document.freshness() != Freshness::All || !jobs_.idle()) {
      return;  // its numbers are computed in a job, whose end comes back here
    }
  }
  window_.workspaces().setCurrent(Workspace::Plan);
  // two turns of the event loop: layouts settle, then the views draw what they were told
  QTimer::singleShot(0, this, [this] { QTimer::singleShot(200, this, &ScreenshotTaker::write); });
}

void ScreenshotTaker::write() {
  if (!picture_.isEmpty() && !pictureOf(window_).save(picture_, "PNG")) {
    finish(3, tr("%1 cannot be written; check the folder.").arg(picture_));
    return;
  }
  if (report_.isEmpty()) {
    finish(0, {});
    return;
  }
  reporting_ = true;  // reportWritten() ends it
  try {
    window_.writeReport(report_, withIdentity_);
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
