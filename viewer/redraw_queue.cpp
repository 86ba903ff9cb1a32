#include "viewer/redraw_queue.h"

#include <QAbstractEventDispatcher>
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
  round_.start();
  const QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
  connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] { round_.start(); });
  connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] { round_.start(); });
}

void RedrawQueue::add(VtkWidget* view) {
  if (!waiting_.contains(view)) {
    waiting_.append(view);
  }
  if (!turn_.isActive()) {
    turn_.start();
  }
}

bool RedrawQueue::shouldWait() {
  constexpr qint64 kLongMs = 5;
  constexpr qint64 kMostMs = 500;
  if (round_.elapsed() <= kLongMs || (waited_.isValid() && waited_.elapsed() > kMostMs)) {
    waited_.invalidate();
    return false;
  }
  if (!waited_.isValid()) {
    waited_.start();
  }
  return true;
}

void RedrawQueue::drawNext() {
  if (shouldWait()) {
    turn_.start();
    return;
  }
  const QPointer<VtkWidget> view = waiting_.takeFirst();
  if (view != nullptr) {
    view->drawInThisTurn();
  }
  if (!waiting_.isEmpty()) {
    turn_.start();
  }
}

}  // namespace glisson
