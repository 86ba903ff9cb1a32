#include "app/gui/rating_plot.h"

#include <QPainter>
#include <algorithm>

#include "app/gui/rating_page.h"

namespace glisson {

namespace {

constexpr double kBoxShare = 0.4;  ///< of a method's place
constexpr double kWidestBox = 90;
constexpr double kDot = 4;

/// Where things stand in the widget.
struct Axes {
  QRectF area;
  [[nodiscard]] double y(double rating) const {
    return area.bottom() - area.height() * (rating - kLowestRating + 0.5) / (kHighestRating - kLowestRating + 1);
  }
};

void drawScale(QPainter& painter, const Axes& axes, const QPalette& palette) {
  for (int value = kLowestRating; value <= kHighestRating; ++value) {
    const double y = axes.y(value);
    painter.setPen(QPen(palette.color(QPalette::Mid), 1, Qt::DotLine));
    painter.drawLine(QPointF(axes.area.left(), y), QPointF(axes.area.right(), y));
    painter.setPen(palette.color(QPalette::WindowText));
    const int line = painter.fontMetrics().height();
    painter.drawText(QRectF(0, y - 0.5 * line, axes.area.left() - 8, line), Qt::AlignRight | Qt::AlignVCenter,
                     QStringLiteral("%1 (%2)").arg(ratingTag(value)).arg(value));
  }
}

void drawBox(QPainter& painter, const Axes& axes, const MethodRatings& method, double middle, double width,
             const QPalette& palette) {
  const BoxPlot& box = method.box;
  const QColor ink = palette.color(QPalette::WindowText);
  const auto across = [&](double value, double share) {
    painter.drawLine(QPointF(middle - 0.5 * share * width, axes.y(value)), QPointF(middle + 0.5 * share * width, axes.y(value)));
  };
  painter.setPen(QPen(ink, 1.2));
  painter.drawLine(QPointF(middle, axes.y(box.lowWhisker)), QPointF(middle, axes.y(box.lowQuartile)));
  painter.drawLine(QPointF(middle, axes.y(box.highQuartile)), QPointF(middle, axes.y(box.highWhisker)));
  across(box.lowWhisker, 0.5);
  across(box.highWhisker, 0.5);
  painter.setBrush(palette.color(QPalette::Midlight));
  painter.drawRect(
      QRectF(QPointF(middle - 0.5 * width, axes.y(box.highQuartile)), QPointF(middle + 0.5 * width, axes.y(box.lowQuartile))));
  painter.setPen(QPen(ink, 3));
  across(box.median, 1);
  painter.setPen(QPen(ink, 1.2));
  painter.setBrush(Qt::NoBrush);
  for (int value = kLowestRating; value <= kHighestRating; ++value) {
    const bool beyond = value < box.lowWhisker || value > box.highWhisker;
    if (beyond && std::ranges::find(method.ratings, value) != method.ratings.end()) {
      painter.drawEllipse(QPointF(middle, axes.y(value)), kDot, kDot);
    }
  }
  painter.setBrush(palette.color(QPalette::Highlight));
  const QPointF mean(middle, axes.y(method.spread.mean));
  painter.drawPolygon(QPolygonF({mean + QPointF(0, -1.6 * kDot), mean + QPointF(1.6 * kDot, 0), mean + QPointF(0, 1.6 * kDot),
                                 mean + QPointF(-1.6 * kDot, 0)}));
}

}  // namespace

RatingPlot::RatingPlot(QWidget* parent) : Translated<QWidget>(parent) {
  setObjectName("ratingPlot");
  setMinimumSize(420, 260);
}

void RatingPlot::setMethods(std::vector<MethodRatings> methods) {
  methods_ = std::move(methods);
  update();
}

void RatingPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  int tags = 0;
  for (int value = kLowestRating; value <= kHighestRating; ++value) {
    tags = std::max(tags, fontMetrics().horizontalAdvance(QStringLiteral("%1 (%2)").arg(ratingTag(value)).arg(value)));
  }
  const int line = fontMetrics().height();
  const Axes axes{QRectF(rect()).adjusted(tags + 12, 4, -4, -2 * line - 6)};
  drawScale(painter, axes, palette());
  const double place = axes.area.width() / static_cast<double>(std::max<std::size_t>(methods_.size(), 1));
  for (std::size_t n = 0; n < methods_.size(); ++n) {
    const double left = axes.area.left() + place * static_cast<double>(n);
    drawBox(painter, axes, methods_[n], left + 0.5 * place, std::min(kBoxShare * place, kWidestBox), palette());
    const QString name =
        fontMetrics().elidedText(QString::fromStdString(methods_[n].method), Qt::ElideMiddle, static_cast<int>(place) - 6);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(left, axes.area.bottom() + 2, place, line), Qt::AlignHCenter, name);
    painter.drawText(QRectF(left, axes.area.bottom() + 2 + line, place, line), Qt::AlignHCenter,
                     tr("%1 ratings").arg(methods_[n].ratings.size()));
  }
}

}  // namespace glisson
