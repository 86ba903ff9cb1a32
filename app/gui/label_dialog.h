#pragma once
// Purpose: asks what each label of unknown kind is, one by one or by the published table its number is from. Nothing is
// preselected: a kind is never guessed.

#include <QComboBox>
#include <QDialog>
#include <map>
#include <string>
#include <vector>

#include "reconstruction/image/segmentation.h"

namespace glisson {

class LabelDialog : public QDialog {
  Q_OBJECT
 public:
  LabelDialog(const std::vector<LabelledMask>& unknown, const ImageGeometry& geometry, QWidget* parent = nullptr);
  /// The kinds chosen, one for each of `unknown` in its order: names may repeat.
  [[nodiscard]] std::vector<StructureKind> chosen() const;
  /// The table chosen instead, for ReadOptions::labelTable: the labels are to be read anew by it. Empty: none.
  [[nodiscard]] std::string table() const;

 private:
  QWidget* makeShortcuts();
  void showTable();
  void updateAccept();
  std::vector<int> labels_;  ///< numbers in the file
  std::vector<QComboBox*> choices_;
  QComboBox* table_ = nullptr;
  QPushButton* acceptButton_ = nullptr;
};

/// The kind's name in the user's language.
QString kindName(StructureKind kind);

}  // namespace glisson
