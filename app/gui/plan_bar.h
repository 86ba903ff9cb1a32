#pragma once
// Purpose: which plan and which of its planes are worked on, the edits of the two lists, and the safety margin. What a plan refuses
// is told through refused(), in English.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QToolButton;

namespace glisson {

class PlanBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PlanBar(Document& document, QWidget* parent = nullptr);

 signals:
  /// A plane to be placed as seen in the 3D view: in a resection of its own, or as one more of the resection worked on.
  void resectionRequested();
  void planeRequested();
  /// At least two plans side by side.
  void compareRequested();
  void refused(const QString& sentence);

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  void refreshPlanes();
  void askForName();
  void tryTo(const std::function<void()>& act);

  Document& document_;
  QLabel* planLabel_;
  QComboBox* plans_;
  QToolButton* planMenuButton_;
  QLabel* planeLabel_;
  QComboBox* planes_;
  QToolButton* planeMenuButton_;
  QLabel* marginLabel_;
  QDoubleSpinBox* margin_;
  QAction* newPlan_;
  QAction* duplicate_;
  QAction* rename_;
  QAction* delete_;
  QAction* compare_;
  QAction* addResection_;
  QAction* addPlane_;
};

}  // namespace glisson
