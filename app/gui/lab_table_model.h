#pragma once
// Purpose: the models of the lab as a table: one row for each, its name, every number of labColumns(), its defects or why it
// failed.

#include <QAbstractTableModel>

#include "app/gui/lab_columns.h"

namespace glisson {

class LabTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// What a row is sorted by: the number itself, not its text.
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;
  void setEvaluation(const Evaluation& evaluation, double voxelVolumeMl);
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  [[nodiscard]] LabRow rowAt(int row) const;

  Evaluation evaluation_;
  double voxelVolumeMl_ = 0;
};

}  // namespace glisson
