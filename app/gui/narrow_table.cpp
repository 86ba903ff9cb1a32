#include "app/gui/narrow_table.h"

#include <QHeaderView>
#include <QTreeWidget>
#include <algorithm>

namespace glisson {

void makeNarrow(QTreeWidget& table, int columns) {
  table.setRootIsDecorated(false);
  table.setColumnCount(columns);
  table.setUniformRowHeights(true);
  table.header()->setStretchLastSection(false);
  for (int column = 0; column < columns; ++column) {
    table.header()->setSectionResizeMode(column, column == 0 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
  }
}

void fitRows(QTreeWidget& table, int rows) {
  table.ensurePolished();
  // an empty table has no row to ask: one with a text tells how high they are
  QTreeWidgetItem probe;
  const bool empty = table.topLevelItemCount() == 0;
  if (empty) {
    probe.setText(0, QStringLiteral("0"));
    table.addTopLevelItem(&probe);
  }
  const int row = table.sizeHintForRow(0);
  if (empty) {
    table.takeTopLevelItem(0);
  }
  table.setFixedHeight(table.header()->sizeHint().height() + std::max(1, rows) * row + 2 * table.frameWidth());
}

}  // namespace glisson
