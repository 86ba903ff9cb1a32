#include "viewer/pick_overlay.h"

#include <QPainter>

namespace glisson {

PickOverlay::PickOverlay(QWidget* view) : QWidget(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  hide();
}

void PickOverlay::show(const std::vector<Pixel>& points, bool joined) {
  points_ = points;
  joined_ = joined;
  setGeometry(parentWidget()->rect());
  QWidget::show();
  update();
}

void PickOverlay::clear() {
  points_.clear();
  hide();
}

void PickOverlay::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double kRadius = 4;
  for (std::size_t n = 0; n < points_.size(); ++n) {
    const QPointF at(points_[n].x(), points_[n].y());
    if (joined_ && n > 0) {
      const QPointF before(points_[n - 1].x(), points_[n - 1].y());
      painter.setPen(QPen(QColor(15, 16, 18, 200), 4));
      painter.drawLine(before, at);
      painter.setPen(QPen(QColor(242, 191, 64), 2));
      painter.drawLine(before, at);
    }
    painter.setPen(QPen(QColor(15, 16, 18), 1));
    painter.setBrush(QColor(242, 191, 64));
    painter.drawEllipse(at, kRadius, kRadius);
  }
}

}  // namespace glisson
