#pragma once
// Purpose: the plan's numbers and the plane's fields. The three that decide are the largest text of the window.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QGroupBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace glisson {

class BigNumber;
class FlrCardBox;
class IslandBox;
class MeasureBox;
class PlanBar;
class PlaneEditor;
class TerritoryBox;
class TerritoryEstimator;
class TumourBox;

class PlanPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  PlanPanel(JobRunner& jobs, Document& document, TerritoryEstimator& territories, QWidget* parent = nullptr);
  [[nodiscard]] PlaneEditor& planeEditor() { return *editor_; }
  [[nodiscard]] PlanBar& planBar() { return *bar_; }
  [[nodiscard]] MeasureBox& measureBox() { return *measures_; }
  [[nodiscard]] IslandBox& islandBox() { return *islands_; }
  [[nodiscard]] TerritoryBox& territoryBox() { return *territories_; }

 signals:
  /// A row of the vessels crossed was clicked or activated: mm LPS.
  void crossingChosen(const glisson::Vec3& at);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void retranslateUi() override;

 private:
  void refresh();
  void refreshVolumes();
  void refreshResections();
  void refreshMargin();
  void showTumoursLeft(const TumourAssessment& decisive);
  void showMarginOf(const TumourAssessment& tumour);
  [[nodiscard]] QString missingNumbers() const;
  void refreshTables();
  void chooseCrossing(QTreeWidgetItem* row);
  void refreshPlane();
  void refreshPlacing();

  Document& document_;
  PlanBar* bar_;
  BigNumber* flr_;
  BigNumber* resected_;
  BigNumber* remnant_;
  BigNumber* margin_;
  QLabel* warning_;
  QLabel* uncertainty_;
  QTreeWidget* resections_;
  PlaneEditor* editor_;
  QLabel* tumoursLabel_;
  QTreeWidget* tumours_;
  QLabel* marginNotice_;
  QLabel* vesselsLabel_;
  QTreeWidget* vessels_;
  IslandBox* islands_;
  MeasureBox* measures_;
  TerritoryBox* territories_;
  TumourBox* sizes_;
  FlrCardBox* card_;
};

/// "removed", "cut", "left", in the window's language.
QString stateText(TumourState state);
/// The vessel's name, with a word where it runs along the cut.
QString crossedText(const VesselCrossing& vessel);
/// The names, as they are shown, of the tumours in this state.
QStringList tumourNames(const PlanAssessment& assessment, TumourState state);

}  // namespace glisson
