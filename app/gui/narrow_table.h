#pragma once
// Purpose: how the flat tables of the narrow side panels look.

class QTreeWidget;

namespace glisson {

/// Flat; the first column takes the room that the others leave.
void makeNarrow(QTreeWidget& table, int columns);

}  // namespace glisson
