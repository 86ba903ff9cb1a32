#pragma once
// Purpose: how the flat tables of the narrow side panels look.

class QTreeWidget;

namespace glisson {

/// Flat; the first column takes the room that the others leave.
void makeNarrow(QTreeWidget& table, int columns);

/// Exactly as high as this many rows, at least one, so that none is cut in half; what is more scrolls by rows.
void fitRows(QTreeWidget& table, int rows);

}  // namespace glisson
