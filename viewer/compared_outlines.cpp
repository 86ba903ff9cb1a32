#include "viewer/compared_outlines.h"

#include <QFontMetricsF>
#include <algorithm>
#include <map>
#include <optional>

#include "viewer/slice_painter.h"

namespace glisson {

namespace {

constexpr double kWidth = 1.8;
constexpr double kInset = 8;
constexpr double kSample = 26;  ///< length of a line in the legend
const QColor kInk(16, 16, 16);
const QColor kGround(15, 16, 18, 170);  ///< of the legend

QFont boldOf(const QFont& font) {
  QFont bold = font;
  bold.setBold(true);
  return bold;
}

QSizeF badgeSize(const QFontMetricsF& metrics, const QString& text) {
  return {metrics.horizontalAdvance(text) + 8, metrics.height()};
}

void drawBadge(QPainter& painter, const QRectF& box, const QColor& colour, const QString& text) {
  painter.setPen(QPen(kInk, 1));
  painter.setBrush(colour);
  painter.drawRoundedRect(box, 2, 2);
  painter.setBrush(Qt::NoBrush);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

QPen comparedPen(std::size_t number, const QColor& colour) {
  QPen pen(colour, kWidth);
  pen.setCapStyle(Qt::FlatCap);
  if (number == 1) {
    pen.setDashPattern({4, 2.5});
  } else if (number > 1) {
    pen.setDashPattern({1, 2});
  }
  return pen;
}

std::vector<std::vector<SlicePoint>> chained(const std::vector<std::pair<SlicePoint, SlicePoint>>& segments) {
  using Key = std::pair<double, double>;
  const auto keyOf = [](const SlicePoint& point) { return Key(point.x(), point.y()); };
  std::multimap<Key, std::size_t> at;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    at.emplace(keyOf(segments[n].first), n);
    at.emplace(keyOf(segments[n].second), n);
  }
  std::vector<bool> taken(segments.size(), false);
  // on from `end`, as long as there is a segment that nobody has taken
  const auto follow = [&](SlicePoint end, std::vector<SlicePoint>& line) {
    for (bool found = true; found;) {
      found = false;
      const auto [first, last] = at.equal_range(keyOf(end));
      for (auto next = first; next != last && !found; ++next) {
        if (!taken[next->second]) {
          taken[next->second] = found = true;
          const auto& [a, b] = segments[next->second];
          end = keyOf(a) == keyOf(end) ? b : a;
          line.push_back(end);
        }
      }
    }
  };
  std::vector<std::vector<SlicePoint>> lines;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    if (taken[n]) {
      continue;
    }
    taken[n] = true;
    std::vector<SlicePoint> back;
    follow(segments[n].first, back);
    std::vector<SlicePoint> line(back.rbegin(), back.rend());
    line.push_back(segments[n].first);
    line.push_back(segments[n].second);
    follow(segments[n].second, line);
    lines.push_back(std::move(line));
  }
  return lines;
}

void drawComparedOutline(QPainter& painter, const QTransform& toWidget,
                         const std::vector<std::pair<SlicePoint, SlicePoint>>& segments, std::size_t number, const QColor& colour,
                         const QString& badge) {
  const bool above = number % 2 == 0;
  std::optional<QPointF> place;
  painter.setPen(comparedPen(number, colour));
  for (const std::vector<SlicePoint>& line : chained(segments)) {
    QPolygonF points;
    for (const SlicePoint& point : line) {
      points << toWidget.map(QPointF(point.x(), point.y()));
      if (!place || (above ? points.back().y() < place->y() : points.back().y() > place->y())) {
        place = points.back();
      }
    }
    painter.drawPolyline(points);
  }
  if (!place || badge.isEmpty()) {
    return;
  }
  painter.save();
  painter.setFont(boldOf(painter.font()));
  const QSizeF size = badgeSize(QFontMetricsF(painter.font()), badge);
  const QPointF corner(place->x() - 0.5 * size.width(), above ? place->y() - size.height() - 3 : place->y() + 3);
  drawBadge(painter, {corner, size}, colour, badge);
  painter.restore();
}

void drawOutlineLegend(QPainter& painter, const QSize& view, const std::vector<OutlineLegendRow>& rows) {
  painter.save();
  const QFont plain = painter.font();
  double y = kInset;
  for (const OutlineLegendRow& row : rows) {
    painter.setFont(row.badge ? boldOf(plain) : plain);
    const QSizeF size = badgeSize(QFontMetricsF(painter.font()), row.text);
    const QRectF box(QPointF(view.width() - kInset - size.width(), y), size);
    painter.fillRect(box.adjusted(-kSample - 10, 0, 2, 0), kGround);
    if (row.badge) {
      drawBadge(painter, box, row.pen.color(), row.text);
    } else {
      drawEdgedText(painter, box, Qt::AlignCenter, row.text);
    }
    painter.setPen(row.pen);
    painter.drawLine(QPointF(box.left() - 6 - kSample, box.center().y()), QPointF(box.left() - 6, box.center().y()));
    y += size.height() + 3;
  }
  painter.restore();
}

}  // namespace glisson
