#include "viewer/redraw_queue.h"

#include <QCoreApplication>

namespace glisson {

RedrawQueue& RedrawQueue::instance() {
  static QPointer<RedrawQueue> queue;  // a test may run one application after another
  if (queue == nullptr) {
    queue = new RedrawQueue(QCoreApplication::instance());
  }
  return *queue;
}

RedrawQueue::RedrawQueue(QObject* parent) : QObject(parent) {
  turn_.setSingleShot(true);
  turn_.setInterval(0);
  connect(&turn_, &QTimer::timeout, this, &RedrawQueue::drawNext);
}

void RedrawQueue::add(VtkWidget* view) {
  if (!waiting_.contains(view)) {
    waiting_.append(view);
  }
  if (!turn_.isActive()) {
    turn_.start();
  }
}

void RedrawQueue::drawNext() {
  const QPointer<VtkWidget> view = waiting_.takeFirst();
  if (view != nullptr) {
    view->drawSoon();
  }
  if (!waiting_.isEmpty()) {
    turn_.start();
  }
}

}  // namespace glisson
