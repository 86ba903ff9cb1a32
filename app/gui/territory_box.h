#pragma once
// Purpose: the estimates of territories and of the remnant's blood beside the plan's numbers: asked for with a button, looked at
// and confirmed, made of branches that are clicked in the 3D view, or read from a map of segments. The 3D view draws each
// territory's branches in the colour beside its row. Called estimates throughout.

#include <QGroupBox>

#include "app/gui/territory_estimator.h"
#include "app/gui/translated.h"
#include "viewer/model_view.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace glisson {

class TerritoryBox final : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  TerritoryBox(Document& document, TerritoryEstimator& estimator, QWidget* parent = nullptr);
  /// Where branches are drawn and clicked.
  void pointIn(ModelView& view);

 signals:
  /// What to do next while pointing; empty: done.
  void hint(const QString& text);
  void refused(const QString& sentence);  ///< a map of segments; in English

 protected:
  void retranslateUi() override;

 private:
  void chooseSegments();
  void refresh();
  void refreshButtons();
  void refreshBranches();
  void refreshNumbers(const TerritoryReport& report);

  Document& document_;
  TerritoryEstimator& estimator_;
  ModelView* view_ = nullptr;
  QPushButton* estimate_;
  QPushButton* confirm_;
  QPushButton* pick_;
  QPushButton* propose_;
  QPushButton* segments_;
  QCheckBox* shown_;
  QTreeWidget* parts_;
  QLabel* perfusion_;
  QLabel* notes_;
};

/// In the window's language. A name of its own: elsewhere "left" is a tumour that stays.
QString territoryName(const std::string& name);

/// "left 8.1 mL (80 %), right 2.0 mL (20 %)".
QString tumourTerritoriesText(const TumourTerritories& tumour);

/// "devascularised 12 mL, congested 30 mL, ...": the effect of a plan in a sentence, in the window's language.
QString perfusionText(const PerfusionEstimate& effect);

}  // namespace glisson
