#include "viewer/slice_painter.h"

#include <QFontMetricsF>
#include <QLineF>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "viewer/slice_curve.h"
#include "viewer/slice_view.h"

namespace glisson {

namespace {
constexpr double kGapPixels = 9.0;
constexpr double kTickPixels = 7.0;
constexpr double kTickDistance = 14.0;
const QColor kDark(15, 16, 18, 200);
}  // namespace

QColor viewColour(SliceAxis axis) {
  switch (axis) {
    case SliceAxis::Axial:
      return QColor(0xF3, 0x4A, 0x33);
    case SliceAxis::Coronal:
      return QColor(0x6E, 0xB0, 0x4B);
    case SliceAxis::Sagittal:
      break;
  }
  return QColor(0xED, 0xD5, 0x4C);
}

std::optional<std::pair<SlicePoint, SlicePoint>> planeLine(const SliceGeometry& g, int slice, const HalfSpace& plane) {
  const auto distance = [&](double column, double row) { return plane.normal.dot(g.toWorld({column, row}, slice) - plane.origin); };
  // The signed distance is linear in the slice: f + x * fx + y * fy.
  const double f = distance(0, 0);
  const double fx = distance(1, 0) - f;
  const double fy = distance(0, 1) - f;
  const double steepest = std::hypot(fx, fy);
  if (steepest < 1e-9) {
    return std::nullopt;
  }
  const SlicePoint onLine = SlicePoint(-f * fx, -f * fy) / (steepest * steepest);
  // The resected side (rising distance) lies at (fx, fy): with y down, that is on the right of the direction (fy, -fx).
  const SlicePoint along(fy / steepest, -fx / steepest);
  double from = -1e12;
  double to = 1e12;
  for (const auto& [start, step, size] :
       {std::tuple{onLine.x(), along.x(), g.columns()}, std::tuple{onLine.y(), along.y(), g.rows()}}) {
    if (std::abs(step) < 1e-12) {
      if (start < -0.5 || start > size - 0.5) {
        return std::nullopt;
      }
      continue;
    }
    const double a = (-0.5 - start) / step;
    const double b = (size - 0.5 - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from >= to) {
    return std::nullopt;
  }
  return std::pair{SlicePoint(onLine + from * along), SlicePoint(onLine + to * along)};
}

namespace {
/// The plane's line or curves in the widget, the resected side on the right.
std::vector<QPolygonF> linesOf(const SliceGeometry& geometry, int slice, const ResectionPlane& plane, const QTransform& toWidget) {
  std::vector<QPolygonF> lines;
  const auto add = [&](std::span<const SlicePoint> points) {
    QPolygonF& line = lines.emplace_back();
    for (const SlicePoint& point : points) {
      line << toWidget.map(QPointF(point.x(), point.y()));
    }
  };
  if (plane.bend) {
    for (const std::vector<SlicePoint>& curve : slicesCurves(geometry, slice, plane)) {
      add(curve);
    }
  } else if (const auto ends = planeLine(geometry, slice, plane)) {
    add(std::array{ends->first, ends->second});
  }
  return lines;
}

/// Ticks towards the resected side, evenly along the line.
QVector<QLineF> ticksOf(const QPolygonF& line) {
  double length = 0;
  for (qsizetype n = 0; n + 1 < line.size(); ++n) {
    length += QLineF(line[n], line[n + 1]).length();
  }
  QVector<QLineF> ticks;
  const int count = static_cast<int>(length / kTickDistance);
  double passed = 0;
  int next = 0;
  for (qsizetype n = 0; n + 1 < line.size(); ++n) {
    const QLineF piece(line[n], line[n + 1]);
    for (; next < count && (next + 0.5) * kTickDistance <= passed + piece.length(); ++next) {
      const QPointF along = (piece.p2() - piece.p1()) / piece.length();
      const QPointF foot = piece.p1() + ((next + 0.5) * kTickDistance - passed) * along;
      ticks.append(QLineF(foot, foot + kTickPixels * QPointF(-along.y(), along.x())));  // right of the direction, with y down
    }
    passed += piece.length();
  }
  return ticks;
}
}  // namespace

void drawPlaneLine(QPainter& painter, const SliceGeometry& geometry, int slice, const ResectionPlane& plane,
                   const QTransform& toWidget, bool strong) {
  for (const QPolygonF& line : linesOf(geometry, slice, plane, toWidget)) {
    if (line.size() < 2 || (line.size() == 2 && QLineF(line[0], line[1]).length() < 1)) {
      continue;
    }
    const QVector<QLineF> ticks = ticksOf(line);
    QPen edge(kDark, strong ? 4.0 : 2.5);
    edge.setCapStyle(Qt::FlatCap);
    painter.setPen(edge);
    painter.drawPolyline(line);
    painter.setPen(QPen(kDark, 3.0));
    painter.drawLines(ticks);
    QPen dashes(Qt::white, strong ? 1.8 : 1.0);
    dashes.setCapStyle(Qt::FlatCap);
    dashes.setDashPattern(strong ? QVector<qreal>{6, 3} : QVector<qreal>{2, 4});
    painter.setPen(dashes);
    painter.drawPolyline(line);
    painter.setPen(QPen(Qt::white, 1.2));
    painter.drawLines(ticks);
  }
}

void drawCrosshair(QPainter& painter, const QPointF& at, const QSize& size, SliceAxis vertical, SliceAxis horizontal) {
  const std::array<QLineF, 4> lines{
      QLineF(at.x(), 0, at.x(), at.y() - kGapPixels), QLineF(at.x(), at.y() + kGapPixels, at.x(), size.height()),
      QLineF(0, at.y(), at.x() - kGapPixels, at.y()), QLineF(at.x() + kGapPixels, at.y(), size.width(), at.y())};
  for (std::size_t n = 0; n < lines.size(); ++n) {
    QColor colour = viewColour(n < 2 ? vertical : horizontal);
    colour.setAlpha(200);
    painter.setPen(QPen(colour, 1.0));
    painter.drawLine(lines[n]);
  }
}

QRectF drawEdgedText(QPainter& painter, const QRectF& box, int flags, const QString& text) {
  painter.setPen(kDark);
  for (const QPointF& offset : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
    painter.drawText(box.translated(offset), flags, text);
  }
  painter.setPen(QColor(235, 235, 235));
  QRectF where;
  painter.drawText(box, flags, text, &where);
  return where;
}

std::array<QRectF, 4> letterBoxes(const QSize& view, const QSizeF& letter, const std::vector<QRectF>& taken) {
  constexpr double kInset = 6.0;
  const double right = view.width() - kInset - letter.width();
  const double bottom = view.height() - kInset - letter.height();
  const QPointF middle(0.5 * (view.width() - letter.width()), 0.5 * (view.height() - letter.height()));
  std::array<QRectF, 4> boxes{QRectF(QPointF(kInset, middle.y()), letter), QRectF(QPointF(right, middle.y()), letter),
                              QRectF(QPointF(middle.x(), kInset), letter), QRectF(QPointF(middle.x(), bottom), letter)};
  constexpr std::size_t kTop = 2;
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    for (const QRectF& text : taken) {
      if (boxes[n].intersects(text) && n == kTop) {
        boxes[n].moveTop(text.bottom());
      } else if (boxes[n].intersects(text)) {
        boxes[n].moveBottom(text.top());
      }
    }
  }
  return boxes;
}

void drawLetters(QPainter& painter, const SliceGeometry& geometry, const QSize& size, const std::vector<QRectF>& taken) {
  const std::array<char, 4> letters = geometry.letters();
  QFont font = painter.font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.3);
  painter.save();
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  const std::array<QRectF, 4> boxes =
      letterBoxes(size, QSizeF(metrics.horizontalAdvance(QLatin1Char('W')), metrics.height()), taken);
  constexpr std::array<int, 4> kPlaces{Qt::AlignLeft | Qt::AlignVCenter, Qt::AlignRight | Qt::AlignVCenter,
                                       Qt::AlignHCenter | Qt::AlignTop, Qt::AlignHCenter | Qt::AlignBottom};
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    drawEdgedText(painter, boxes[n], kPlaces[n], QString(QLatin1Char(letters[n])));
  }
  painter.restore();
}

}  // namespace glisson
