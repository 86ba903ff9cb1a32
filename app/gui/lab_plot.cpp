#include "app/gui/lab_plot.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/gui/lab_colours.h"
#include "app/gui/lab_columns.h"
#include "app/gui/number_text.h"

namespace glisson {

namespace {

constexpr double kReach = 10;  ///< pixels from a mark within which it is meant
const QColor kGround(0x20, 0x22, 0x26);
const QColor kGrid(0x3a, 0x3e, 0x45);
const QColor kInk(0xe6, 0xe6, 0xe6);
const QColor kFaint(0xa6, 0xab, 0xb3);

QPointF toPoint(const lab::Pixel& pixel) { return {pixel.x, pixel.y}; }

void drawMark(QPainter& painter, const QPointF& at, const lab::FamilyLook& look, double radius) {
  painter.setPen(QPen(kGround, 1));
  painter.setBrush(QColor(QLatin1String(look.onDark)));
  const double r = 1.25 * radius;
  switch (look.mark) {
    case lab::Mark::Circle:
      painter.drawEllipse(at, radius, radius);
      break;
    case lab::Mark::Diamond:
      painter.drawPolygon(QPolygonF({at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)}));
      break;
    case lab::Mark::Triangle:
      painter.drawPolygon(QPolygonF({at + QPointF(0, -r), at + QPointF(r, 0.8 * r), at + QPointF(-r, 0.8 * r)}));
      break;
    case lab::Mark::Square:
      painter.drawRect(QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)));
      break;
  }
}

void drawFront(QPainter& painter, const std::vector<lab::Pixel>& corners, const QPen& pen) {
  QPolygonF line;
  for (const lab::Pixel& corner : corners) {
    line << toPoint(corner);
  }
  painter.setPen(pen);
  painter.drawPolyline(line);
}

QPen frontPen(bool published) {
  return published ? QPen(kInk, 1.4)
                   : QPen(QColor(QLatin1String(lab::lookOf(ModelFamily::SimplifiedPsr).onDark)), 1.4, Qt::DashLine);
}

/// Of a model of the slider: a cross in an open circle.
void drawOpenMark(QPainter& painter, const QPointF& at) {
  constexpr double kRadius = 6;
  const double arm = kRadius / std::sqrt(2.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kInk, 1.6));
  painter.drawEllipse(at, kRadius, kRadius);
  painter.drawLine(at - QPointF(arm, arm), at + QPointF(arm, arm));
  painter.drawLine(at - QPointF(arm, -arm), at + QPointF(arm, -arm));
}

int decimalsOf(double step) { return step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)); }

}  // namespace

LabPlot::LabPlot(QWidget* parent) : Translated<QWidget>(parent) {
  setObjectName("labPlot");
  setMinimumSize(300, 150);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void LabPlot::setEvaluation(const Evaluation& evaluation) {
  evaluation_ = evaluation;
  chosen_ = {};  // places are those of the models before
  beside_ = {};
  layOut();
}

void LabPlot::setChosen(const std::array<std::optional<std::size_t>, 2>& chosen,
                        const std::array<std::optional<EvaluatedModel>, 2>& beside) {
  const bool same = std::ranges::equal(beside_, beside, [](const auto& one, const auto& other) {
    return one.has_value() == other.has_value() && (!one || one->recipe == other->recipe);
  });
  if (same && chosen_ == chosen) {
    return;
  }
  chosen_ = chosen;
  beside_ = beside;
  layOut();
}

void LabPlot::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void LabPlot::layOut() {
  const double row = fontMetrics().height();
  const double numbers = fontMetrics().horizontalAdvance(QStringLiteral("0,00"));
  std::vector<ModelMeasures> beside;
  for (const std::optional<EvaluatedModel>& model : beside_) {
    if (model) {
      beside.push_back(*model->measures);
    }
  }
  figure_ = lab::accuracyFigure(evaluation_, {numbers + 14, width() - 14.0, 2.0 * row + 8, height() - 2.0 * row - 8}, beside);
  update();
}

std::optional<QPointF> LabPlot::pixelOf(std::size_t place) const {
  const lab::FigureMark* mark = figure_.markOf(place);
  return mark != nullptr ? std::optional(toPoint(mark->at)) : std::nullopt;
}

std::optional<QPointF> LabPlot::pixelBeside(std::size_t side) const {
  const std::size_t number = side == 1 && beside_[0] ? 1 : 0;
  return beside_[side] && number < figure_.beside.size() ? std::optional(toPoint(figure_.beside[number])) : std::nullopt;
}

const lab::FigureMark* LabPlot::markAt(const QPointF& pixel) const { return figure_.markAt({pixel.x(), pixel.y()}, kReach); }

void LabPlot::drawAxes(QPainter& painter) const {
  const lab::PlotArea& area = figure_.area;
  const double row = painter.fontMetrics().height();
  const int decimals = figure_.errors.size() > 1 ? decimalsOf(figure_.errors[1].value - figure_.errors[0].value) : 1;
  for (const lab::AxisTick& tick : figure_.errors) {
    painter.setPen(kGrid);
    painter.drawLine(QPointF(area.left, tick.at), QPointF(area.right, tick.at));
    painter.setPen(kFaint);
    painter.drawText(QRectF(0, tick.at - row / 2, area.left - 6, row), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(tick.value, decimals));
  }
  double numbered = -1e9;
  for (const lab::AxisTick& tick : figure_.triangles) {
    painter.setPen(kGrid);
    painter.drawLine(QPointF(tick.at, area.top), QPointF(tick.at, area.bottom));
    const QString text = numberText(tick.value, 0);
    const double half = 0.5 * painter.fontMetrics().horizontalAdvance(text) + 2;
    if (tick.numbered && tick.at - half > numbered && tick.at + half < width()) {
      painter.setPen(kFaint);
      painter.drawText(QRectF(tick.at - half, area.bottom + 3, 2 * half, row), Qt::AlignCenter, text);
      numbered = tick.at + half + 6;
    }
  }
  painter.setPen(kFaint);
  painter.drawText(QRectF(area.left, area.bottom + 3 + row, area.right - area.left, row), Qt::AlignRight | Qt::AlignVCenter,
                   tr("triangles (logarithmic)"));
  painter.drawText(QRectF(6, 3 + row, area.right, row), Qt::AlignLeft | Qt::AlignVCenter, tr("mean paper error (mm)"));
}

void LabPlot::drawLegend(QPainter& painter) const {
  std::vector<ModelRecipe> shown;
  for (const lab::FigureMark& mark : figure_.marks) {
    shown.push_back(evaluation_.models[mark.place].recipe);
  }
  std::ranges::sort(shown, {}, &ModelRecipe::family);
  const double row = painter.fontMetrics().height();
  double x = figure_.area.left;
  const double y = 3 + row / 2;
  const auto write = [&](const QString& text) {
    painter.setPen(kInk);
    painter.drawText(QRectF(x, 3, width(), row), Qt::AlignLeft | Qt::AlignVCenter, text);
    x += painter.fontMetrics().horizontalAdvance(text) + 18;
  };
  for (const ModelFamily family : lab::familiesOf(shown)) {
    drawMark(painter, {x + 5, y}, lab::lookOf(family), 5);
    x += 15;
    write(labFamilyName(family));
  }
  if (!figure_.beside.empty()) {
    drawOpenMark(painter, {x + 6, y});
    x += 18;
    write(tr("slider's model, not scored"));
  }
  for (const bool published : {true, false}) {
    if (!(published ? figure_.publishedFront : figure_.simplifiedFront).empty()) {
      painter.setPen(frontPen(published));
      painter.drawLine(QPointF(x, y), QPointF(x + 22, y));
      x += 28;
      write(published ? frontName() : tr("front of simplified PSR"));
    }
  }
}

QString LabPlot::frontName() const { return evaluation_.publishedComplete ? tr("front") : tr("front so far"); }

void LabPlot::drawBeside(QPainter& painter) const {
  for (const lab::Pixel& at : figure_.beside) {
    drawOpenMark(painter, toPoint(at));
  }
}

void LabPlot::drawLetters(QPainter& painter) const {
  QFont bold = painter.font();
  bold.setBold(true);
  painter.setFont(bold);
  for (std::size_t side = 0; side < chosen_.size(); ++side) {
    const std::optional<QPointF> at = chosen_[side] ? pixelOf(*chosen_[side]) : pixelBeside(side);
    if (!at) {
      continue;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kLabColours[side], 2.2));
    painter.drawEllipse(*at, 10, 10);
    const QPointF letter = *at + QPointF(side == 0 ? -22 : 12, -8);
    painter.drawText(letter, QString(QChar(side == 0 ? 'A' : 'B')));
  }
}

void LabPlot::draw(QPainter& painter) const {
  painter.fillRect(rect(), kGround);
  painter.setRenderHint(QPainter::Antialiasing);
  if (figure_.marks.empty() && figure_.beside.empty()) {
    painter.setPen(kFaint);
    painter.drawText(rect().adjusted(20, 10, -20, -10), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  drawAxes(painter);
  drawLegend(painter);
  drawFront(painter, figure_.publishedFront, frontPen(true));
  drawFront(painter, figure_.simplifiedFront, frontPen(false));
  for (const lab::FigureMark& mark : figure_.marks) {
    drawMark(painter, toPoint(mark.at), mark.look, mark.radius);
  }
  drawBeside(painter);
  drawLetters(painter);
}

void LabPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  draw(painter);
}

QImage LabPlot::picture() const {
  constexpr int kFiner = 2;
  QImage image(size() * kFiner, QImage::Format_RGB32);
  image.setDevicePixelRatio(kFiner);
  QPainter painter(&image);
  painter.setFont(font());
  draw(painter);
  return image;
}

void LabPlot::resizeEvent(QResizeEvent* /*event*/) { layOut(); }

void LabPlot::mousePressEvent(QMouseEvent* event) {
  const lab::FigureMark* mark = markAt(event->position());
  if (mark != nullptr && (event->button() == Qt::LeftButton || event->button() == Qt::RightButton)) {
    const bool second = event->button() == Qt::RightButton || event->modifiers().testFlag(Qt::ShiftModifier);
    emit chosen(mark->place, second ? 1 : 0);
  }
  event->accept();
}

void LabPlot::mouseMoveEvent(QMouseEvent* event) {
  setCursor(markAt(event->position()) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

QString LabPlot::tooltipOf(const EvaluatedModel& model, const ModelScore* score) const {
  QStringList lines{QString::fromStdString(model.name()),
                    tr("%1 triangles").arg(numberText(static_cast<double>(model.measures->triangles), 0)),
                    tr("mean paper error %1 mm").arg(numberText(model.measures->paperErrorMm.mean, 3))};
  if (score != nullptr) {
    lines << tr("score %1").arg(numberText(score->score, 3));
    if (score->pareto) {
      lines << tr("on the front");
    }
  }
  return lines.join('\n');
}

bool LabPlot::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto near = [&](std::size_t side) {
      const std::optional<QPointF> at = pixelBeside(side);
      return at && std::hypot(at->x() - help->pos().x(), at->y() - help->pos().y()) <= kReach;
    };
    const std::optional<EvaluatedModel>& beside = near(0) ? beside_[0] : beside_[1];
    if (const lab::FigureMark* mark = markAt(help->pos())) {
      QToolTip::showText(help->globalPos(), tooltipOf(evaluation_.models[mark->place], evaluation_.finalScore(mark->place)), this);
    } else if (near(0) || near(1)) {
      QToolTip::showText(help->globalPos(), tooltipOf(*beside, nullptr) + '\n' + tr("of the slider: no part of scores and fronts"),
                         this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return Translated<QWidget>::event(event);
}

}  // namespace glisson
