#pragma once
// Purpose: the list of structures: visibility, colour, name, volume from voxels, a warning mark, a mark where a person has accepted
// it; colour, opacity and acceptance of the selected one. The tooltip says how the surface was made and what is to be known about
// it.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;
class QTreeWidgetItem;

namespace glisson {

class AcceptanceBox;

class StructureList : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StructureList(Document& document, QWidget* parent = nullptr);
  [[nodiscard]] std::string selectedId() const;

 protected:
  void retranslateUi() override;

 private:
  void rebuild();
  void refresh();
  void refreshItem(QTreeWidgetItem& item, const Structure& structure);
  void refreshControls();
  void chooseColour();
  [[nodiscard]] const Structure* selected() const;

  Document& document_;
  QTreeWidget* tree_;
  QLabel* opacityLabel_;
  QSlider* opacity_;
  QPushButton* colour_;
  AcceptanceBox* acceptance_;
  bool refreshing_ = false;
};

/// How it was made, volumes, notes and deviations, for tooltips and the model panel.
QString structureReport(const Structure& structure);
/// Volume of its voxels, mL; from L for the parenchyma. NaN where unknown.
double voxelVolumeOf(const Case& content, const Structure& structure);

}  // namespace glisson
