#include "app/gui/narrow_table.h"

#include <QHeaderView>
#include <QTreeWidget>

namespace glisson {

void makeNarrow(QTreeWidget& table, int columns) {
  table.setRootIsDecorated(false);
  table.setColumnCount(columns);
  table.header()->setStretchLastSection(false);
  for (int column = 0; column < columns; ++column) {
    table.header()->setSectionResizeMode(column, column == 0 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  }
}

}  // namespace glisson
