#include "app/gui/error_legend.h"

#include <QPainter>

#include "app/gui/number_text.h"
#include "viewer/error_colours.h"

namespace glisson {

namespace {
constexpr int kBarWidth = 130;
constexpr int kGap = 5;
}  // namespace

ErrorLegend::ErrorLegend(QWidget* parent) : Translated<QWidget>(parent) {
  setObjectName("errorLegend");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  retranslateUi();
}

void ErrorLegend::retranslateUi() {
  setToolTip(
      tr("Distance from the surface's vertices to the mask's surface (its level set of 0.5). Larger ones have the last colour."));
  updateGeometry();
  update();
}

void ErrorLegend::setScale(double mm) {
  scaleMm_ = mm;
  updateGeometry();
  update();
}

namespace {
QString endText(double mm) { return QStringLiteral("\u2265\u00A0") + numberText(mm, mm < 1 ? 1 : 0) + QStringLiteral("\u00A0mm"); }
}  // namespace

QSize ErrorLegend::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  return {metrics.horizontalAdvance(caption()) + kBarWidth + metrics.horizontalAdvance(endText(scaleMm_)) + 2 * kGap,
          metrics.height() + 4};
}

QString ErrorLegend::caption() { return tr("distance to the voxels") + QStringLiteral("   0"); }

void ErrorLegend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const int left = fontMetrics().horizontalAdvance(caption()) + kGap;
  painter.drawText(QRect(0, 0, left, height()), Qt::AlignLeft | Qt::AlignVCenter, caption());
  for (int x = 0; x < kBarWidth; ++x) {
    const Rgb colour = errorColour(x / (kBarWidth - 1.0));
    painter.fillRect(left + x, 3, 1, height() - 6, QColor(colour.r, colour.g, colour.b));
  }
  painter.drawText(QRect(left + kBarWidth + kGap, 0, width(), height()), Qt::AlignLeft | Qt::AlignVCenter, endText(scaleMm_));
}

}  // namespace glisson
