#include "app/gui/lab_table_model.h"

#include <limits>

namespace glisson {

namespace {
int numberColumns() { return static_cast<int>(labColumns().size()); }
}  // namespace

void LabTableModel::setEvaluation(const Evaluation& evaluation, double voxelVolumeMl) {
  beginResetModel();
  evaluation_ = evaluation;
  voxelVolumeMl_ = voxelVolumeMl;
  endResetModel();
}

void LabTableModel::retranslate() {
  beginResetModel();
  endResetModel();
}

int LabTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(evaluation_.models.size());
}

int LabTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : numberColumns() + 2; }

LabRow LabTableModel::rowAt(int row) const {
  const auto place = static_cast<std::size_t>(row);
  return {&evaluation_.models[place], evaluation_.finalScore(place), voxelVolumeMl_};
}

QVariant LabTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const LabRow row = rowAt(index.row());
  const int number = index.column() - 1;
  if (number < 0 || number >= numberColumns()) {
    const QString text = number < 0 ? QString::fromStdString(row.model->name()) : labDefectsText(*row.model);
    if (role == kSortRole && number < 0) {
      return index.row();  // the order of the recipes, not of the letters
    }
    return role == Qt::DisplayRole || role == kSortRole || (role == Qt::ToolTipRole && number >= 0) ? QVariant(text) : QVariant();
  }
  const LabColumn& column = labColumns()[static_cast<std::size_t>(number)];
  switch (role) {
    case Qt::DisplayRole:
      return labValueText(column, row);
    case kSortRole:
      return column.value(row).value_or(std::numeric_limits<double>::infinity());  // what has no number stands last
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant LabTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  if (section == 0) {
    return tr("Model");
  }
  return section <= numberColumns() ? labColumnName(labColumns()[static_cast<std::size_t>(section - 1)]) : tr("Defects");
}

}  // namespace glisson
