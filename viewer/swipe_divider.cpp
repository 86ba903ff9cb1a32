#include "viewer/swipe_divider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace glisson {

namespace {
constexpr int kGrip = 18;  ///< pixels: wide enough to be caught
constexpr double kKeyStep = 0.01;
}  // namespace

SwipeDivider::SwipeDivider(QWidget* view) : QWidget(view) {
  setObjectName("swipeDivider");
  setAttribute(Qt::WA_NoSystemBackground);
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::StrongFocus);
  hide();
}

void SwipeDivider::setShare(double share) {
  share_ = std::clamp(share, 0.0, 1.0);
  place();
}

void SwipeDivider::place() {
  const QWidget* view = parentWidget();
  setGeometry(qRound(share_ * view->width()) - kGrip / 2, 0, kGrip, view->height());
}

void SwipeDivider::moveTo(double share) {
  setShare(share);
  emit moved(share_);
}

void SwipeDivider::mousePressEvent(QMouseEvent* event) {
  setFocus();
  event->accept();  // the view below must not turn
}

void SwipeDivider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    moveTo((pos().x() + event->position().x()) / std::max(1, parentWidget()->width()));
  }
  event->accept();
}

void SwipeDivider::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 * kKeyStep : kKeyStep;
  if (event->key() == Qt::Key_Left) {
    moveTo(share_ - step);
  } else if (event->key() == Qt::Key_Right) {
    moveTo(share_ + step);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void SwipeDivider::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double x = 0.5 * width();
  const double y = 0.5 * height();
  painter.setPen(QPen(QColor(15, 16, 18, 200), 4));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  painter.setPen(QPen(QColor(235, 235, 235), hasFocus() ? 2.5 : 1.5));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  painter.setBrush(QColor(60, 64, 70));
  painter.drawRoundedRect(QRectF(x - 7, y - 14, 14, 28), 5, 5);
  painter.drawLine(QPointF(x - 2, y - 6), QPointF(x - 2, y + 6));
  painter.drawLine(QPointF(x + 2, y - 6), QPointF(x + 2, y + 6));
}

}  // namespace glisson
