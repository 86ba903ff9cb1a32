#include "viewer/resectogram.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <algorithm>

namespace glisson {

namespace {

constexpr int kMapWidth = 220;
constexpr int kHeight = 220;
constexpr int kMargin = 6;
constexpr int kSwatch = 12;
constexpr int kSwatchGap = 4;
constexpr int kLegendLines = 3;
const QColor kBack(20, 22, 26, 215);
const QColor kPaper(219, 227, 237);
const QColor kMapInk(230, 230, 230);

QPainterPath pathOf(const std::vector<Loop>& loops, const PlaneGrid& grid) {
  QPainterPath path;
  for (const Loop& loop : loops) {
    QPolygonF polygon;
    for (const Vec3& point : loop) {
      polygon << QPointF((point - grid.origin).dot(grid.u), (point - grid.origin).dot(grid.v));
    }
    path.addPolygon(polygon);
    path.closeSubpath();
  }
  path.setFillRule(Qt::OddEvenFill);
  return path;
}

/// The grid's rectangle on the inner side of the bound, in the grid's mm.
QPainterPath insideOf(const HalfSpace& bound, const PlaneGrid& grid) {
  const double width = grid.stepMm * (grid.columns - 1);
  const double height = grid.stepMm * (grid.rows - 1);
  std::vector<QPointF> kept;
  const std::array<QPointF, 4> corners{QPointF(0, 0), QPointF(width, 0), QPointF(width, height), QPointF(0, height)};
  const auto over = [&](const QPointF& p) {
    return bound.normal.dot(grid.origin + p.x() * grid.u + p.y() * grid.v - bound.origin);
  };
  for (std::size_t n = 0; n < 4; ++n) {
    const QPointF& a = corners[n];
    const QPointF& b = corners[(n + 1) % 4];
    if (over(a) >= 0) {
      kept.push_back(a);
    }
    if ((over(a) >= 0) != (over(b) >= 0)) {
      kept.push_back(a + over(a) / (over(a) - over(b)) * (b - a));
    }
  }
  QPainterPath path;
  path.addPolygon(QPolygonF(QList<QPointF>(kept.begin(), kept.end())));
  path.closeSubpath();
  return path;
}

/// The same where one of the two is bent: squares of a few mm whose surface points lie on the bound's inner side.
QPainterPath insideOf(const ResectionPlane& bound, const ResectionPlane& plane, const PlaneGrid& grid) {
  constexpr double kSquareMm = 1.5;
  const BentSurface within = BentSurface(bound.bend ? bound : ResectionPlane(bound, flatBend(bound, kMostBendMm)));
  const BentSurface surface = BentSurface(plane.bend ? plane : ResectionPlane(plane, flatBend(plane, kMostBendMm)));
  const double width = grid.stepMm * (grid.columns - 1);
  const double height = grid.stepMm * (grid.rows - 1);
  QPainterPath path;
  for (int row = 0; row * kSquareMm < height; ++row) {
    const double y = row * kSquareMm;
    double from = -1;
    const auto end = [&](double x) {
      if (from >= 0) {
        path.addRect(QRectF(from, y, x - from, kSquareMm));
      }
      from = -1;
    };
    for (int column = 0; column * kSquareMm < width; ++column) {
      const double x = column * kSquareMm;
      const Vec3 middle = grid.origin + (x + 0.5 * kSquareMm) * grid.u + (y + 0.5 * kSquareMm) * grid.v;
      if (within.above(surface.foot(middle)) < 0) {
        end(x);
      } else if (from < 0) {
        from = x;
      }
    }
    end(width);
  }
  return path.simplified();
}

/// The first of these, longest first, that fits.
QString fitting(const QFontMetrics& metrics, int width, const QStringList& texts) {
  for (const QString& text : texts) {
    if (metrics.horizontalAdvance(text) <= width) {
      return text;
    }
  }
  return texts.back();
}

}  // namespace

Resectogram::Resectogram(QWidget* parent) : QWidget(parent), fold_(new QToolButton(this)) {
  setObjectName("resectogram");
  setAttribute(Qt::WA_NoMousePropagation);
  fold_->setObjectName("foldMap");
  fold_->setFocusPolicy(Qt::NoFocus);  // keys stay with the view
  fold_->setFixedSize(fontMetrics().height() + 4, fontMetrics().height() + 4);
  connect(fold_, &QToolButton::clicked, this, [this] { setUnfolded(!unfolded_); });
  retranslate();
  hide();
}

QSize Resectogram::sizeHint() const {
  if (unfolded_) {
    return {kMapWidth, kHeight};
  }
  return {fontMetrics().horizontalAdvance(tr("Cut")) + fold_->width() + 3 * kMargin, fold_->height()};
}

void Resectogram::setUnfolded(bool unfolded) {
  if (unfolded != unfolded_) {
    unfolded_ = unfolded;
    retranslate();
    emit unfoldedChanged(unfolded);
  }
}

QStringList Resectogram::texts() const {
  const QFontMetrics metrics = fontMetrics();
  const int beside = fold_->x() - 2 * kMargin;
  if (!unfolded_) {
    return {tr("Cut")};
  }
  QStringList texts{fitting(metrics, beside, {tr("Cut, from the resected side"), tr("Cut, laid flat"), tr("Cut")})};
  if (map_ && map_->margins) {
    const double margin = map_->safetyMarginMm;
    const QString mm = QLocale().toString(margin, 'f', margin == std::round(margin) ? 0 : 1);
    const QString lines = QString::number(static_cast<int>(kIsoLineMm));
    const int line = width() - 2 * kMargin;
    const int entry = line - kSwatch - kSwatchGap;
    texts << fitting(metrics, entry, {tr("under %1 mm to a tumour").arg(mm), tr("< %1 mm").arg(mm)})
          << fitting(metrics, entry, {tr("perhaps under %1 mm").arg(mm), tr("perhaps < %1").arg(mm)})
          << fitting(metrics, line, {tr("Lines: every %1 mm").arg(lines), tr("Lines: %1 mm").arg(lines)});
  }
  return texts;
}

void Resectogram::retranslate() {
  setAccessibleName(tr("Resection surface, laid flat"));
  setToolTip(tr("The resection surface, laid flat, as seen from the resected side; red: nearer to a tumour than the safety margin; "
                "yellow: perhaps nearer, by the size of the voxels; a line every %1 mm of distance")
                 .arg(static_cast<int>(kIsoLineMm)));
  fold_->setArrowType(unfolded_ ? Qt::DownArrow : Qt::UpArrow);
  fold_->setToolTip(unfolded_ ? tr("Folds the map of the cut up") : tr("Shows the map of the cut"));
  update();
}

void Resectogram::resizeEvent(QResizeEvent* /*event*/) { fold_->move(width() - fold_->width(), 0); }

void Resectogram::mousePressEvent(QMouseEvent* event) {
  event->accept();
  setUnfolded(true);
}

void Resectogram::setMap(std::optional<ResectionMap> map, const QImage& margins) {
  map_ = std::move(map);
  margins_ = margins;
  const bool shown = map_ && !map_->outline.empty();
  if (shown != isVisible()) {
    setVisible(shown);
  }
  update();
}

void Resectogram::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

void Resectogram::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), kBack);
  if (!map_) {
    return;
  }
  const int line = fontMetrics().height();
  painter.setPen(kMapInk);
  painter.drawText(QRect(kMargin, 2, fold_->x() - kMargin, line), Qt::AlignLeft, texts().front());
  if (!unfolded_) {
    return;
  }
  const int legend = map_->margins ? kLegendLines * (line + 2) : 0;
  drawMap(painter, QRectF(kMargin, line + 6, width() - 2 * kMargin, height() - line - 10 - legend));
  if (map_->margins) {
    drawLegend(painter, QRectF(kMargin, height() - legend - 2, width() - 2 * kMargin, legend));
  }
}

void Resectogram::drawMap(QPainter& painter, const QRectF& box) const {
  const PlaneGrid grid = map_->margins ? map_->margins->grid : gridOver(map_->outline, map_->plane, 1.0);
  if (grid.columns < 2 || grid.rows < 2) {
    return;
  }
  const double mmWide = grid.stepMm * (grid.columns - 1);
  const double mmHigh = grid.stepMm * (grid.rows - 1);
  const double scale = std::min(box.width() / mmWide, box.height() / mmHigh);
  painter.save();
  // u to the right, v up: the plane's normal comes out of the picture.
  painter.translate(box.center().x() - 0.5 * scale * mmWide, box.center().y() + 0.5 * scale * mmHigh);
  painter.scale(scale, -scale);
  QPainterPath outline = pathOf(map_->outline, grid);
  const auto inside = [&](const ResectionPlane& bound, const PlaneGrid& at) {
    return bound.bend || map_->plane.bend ? insideOf(bound, map_->plane, at) : insideOf(bound, at);
  };
  for (const ResectionPlane& bound : map_->within) {
    outline = outline.intersected(inside(bound, grid));
  }
  PlaneGrid before = grid;
  before.origin -= kBeforeMm * map_->plane.normal;
  for (const std::vector<ResectionPlane>& other : map_->others) {
    QPainterPath taken = inside(other.front(), before);
    for (std::size_t n = 1; n < other.size(); ++n) {
      taken = taken.intersected(inside(other[n], before));
    }
    outline = outline.subtracted(taken);
  }
  painter.setClipPath(outline);
  painter.fillPath(outline, kPaper);
  if (!margins_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(0, 0, mmWide, mmHigh), margins_);
  }
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, loop] : map_->vessels) {
    const QPainterPath vessel = pathOf({loop}, grid);
    QPen pen(QColor(15, 16, 18), 3.5);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawPath(vessel);
    pen = QPen(QColor(colour.r, colour.g, colour.b), 2);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawPath(vessel);
  }
  painter.setClipping(false);
  QPen edge(Qt::white, 1.5);
  edge.setCosmetic(true);
  painter.setPen(edge);
  painter.drawPath(outline);
  painter.restore();
}

void Resectogram::drawLegend(QPainter& painter, const QRectF& box) const {
  const double line = box.height() / kLegendLines;
  const QStringList words = texts();
  const auto write = [&](double left, int row) {
    const QRectF place(left, box.y() + row * line, box.right() - left, line);
    painter.setPen(kMapInk);
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft, words[1 + row]);
  };
  const auto entry = [&](int row, const QColor& colour, bool hatched) {
    const QRectF swatch(box.x(), box.y() + row * line + 0.5 * (line - kSwatch), kSwatch, kSwatch);
    painter.fillRect(swatch, colour);
    if (hatched) {
      painter.fillRect(swatch, QBrush(QColor(110, 0, 0), Qt::FDiagPattern));
    }
    write(box.x() + kSwatch + kSwatchGap, row);
  };
  entry(0, kMarginRed, true);
  entry(1, kMarginYellow, false);
  write(box.x(), 2);
}

}  // namespace glisson
