#pragma once
// Purpose: outlines of surfaces that are compared in a slice, told apart without colour vision: each has a line style of its own
// and a badge with its letter at the line and in a legend. Drawn over the slice, logical pixels.

#include <QColor>
#include <QPainter>
#include <QTransform>
#include <utility>
#include <vector>

#include "viewer/slice_geometry.h"

namespace glisson {

/// Solid for the first surface, dashed for the second, dotted for all others.
QPen comparedPen(std::size_t number, const QColor& colour);

/// Segments that share ends as lines, so that a pattern runs on along them: a closed line ends where it begins.
std::vector<std::vector<SlicePoint>> chained(const std::vector<std::pair<SlicePoint, SlicePoint>>& segments);

/// The lines with a pen; in `badge`, where it is not empty, at the uppermost point of surfaces with an even number, at the
/// lowermost of the others.
void drawComparedOutline(QPainter& painter, const QTransform& toWidget,
                         const std::vector<std::pair<SlicePoint, SlicePoint>>& segments, std::size_t number, const QColor& colour,
                         const QString& badge);

struct OutlineLegendRow {
  QPen pen;
  QString text;
  bool badge = false;  ///< the text stands on a ground of the pen's colour
};
/// In the upper right corner, from top to bottom.
void drawOutlineLegend(QPainter& painter, const QSize& view, const std::vector<OutlineLegendRow>& rows);

}  // namespace glisson
