#pragma once
// Purpose: the table of the lab: sorted by a click on a heading, filtered by a text that any column may hold. A click on a row (or
// Enter) chooses model A; with Shift or the right button, B.

#include <QWidget>

#include "app/gui/lab_table_model.h"
#include "app/gui/translated.h"

class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace glisson {

class LabTable : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit LabTable(QWidget* parent = nullptr);
  void setEvaluation(const Evaluation& evaluation, double voxelVolumeMl);

 signals:
  /// `side`: 0 for A, 1 for B.
  void chosen(std::size_t place, std::size_t side);

 protected:
  void retranslateUi() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(const QModelIndex& shown, bool second);
  void countRows();

  LabTableModel* model_;
  QSortFilterProxyModel* sorted_;
  QLineEdit* filter_;
  QLabel* count_;
  QTableView* view_;
};

}  // namespace glisson
