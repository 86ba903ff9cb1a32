#pragma once
// Purpose: how a slice view looks: colours of the views, crosshair, the plane's line, letters and texts. Drawn over the slice.

#include <QColor>
#include <QPainter>
#include <QTransform>
#include <array>
#include <optional>
#include <vector>

#include "planning/resection/bend.h"
#include "viewer/slice_geometry.h"

namespace glisson {

/// The colour of a view (clinical.md): its frame, and its line in the other views.
QColor viewColour(SliceAxis axis);

/// Where the plane crosses the slice, inside the picture, as two slice points with the resected side on the right of first ->
/// second as seen on the screen (y down); nothing where it does not.
std::optional<std::pair<SlicePoint, SlicePoint>> planeLine(const SliceGeometry& geometry, int slice, const HalfSpace& plane);

/// `toWidget` maps slice points to widget pixels. `strong`: the plane that is worked on; the others are thinner and dotted.
/// A bent plane's curve is drawn likewise.
void drawPlaneLine(QPainter& painter, const SliceGeometry& geometry, int slice, const ResectionPlane& plane,
                   const QTransform& toWidget, bool strong = true);
/// Vertical line in the colour of `vertical`, horizontal line in that of `horizontal`, with a gap at the crossing.
void drawCrosshair(QPainter& painter, const QPointF& at, const QSize& size, SliceAxis vertical, SliceAxis horizontal);
/// Boxes of letters of this size in the middle of the left, right, top and bottom edge of a view; one that would lie on a box that
/// is taken stands above it (at the top: below it).
std::array<QRectF, 4> letterBoxes(const QSize& view, const QSizeF& letter, const std::vector<QRectF>& taken);
void drawLetters(QPainter& painter, const SliceGeometry& geometry, const QSize& size, const std::vector<QRectF>& taken);
/// White text with a dark edge, readable on any grey. Returns where it is.
QRectF drawEdgedText(QPainter& painter, const QRectF& box, int flags, const QString& text);

}  // namespace glisson
