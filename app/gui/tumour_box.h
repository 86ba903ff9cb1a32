#pragma once
// Purpose: what can be said of each tumour without a plan: volume, longest diameter, the ways to the capsule and to the nearest
// vessel, and the territories it lies in, where they were estimated.

#include <QGroupBox>

#include "app/gui/territory_estimator.h"
#include "app/gui/translated.h"
#include "planning/volumetry/tumour_measures.h"

class QTreeWidget;

namespace glisson {

class TumourBox final : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  TumourBox(JobRunner& jobs, Document& document, TerritoryEstimator& estimator, QWidget* parent = nullptr);

 protected:
  void retranslateUi() override;

 private:
  void measure();
  void refresh();
  /// Of one tumour: where it lies, or why that is not known.
  [[nodiscard]] QString territoriesOf(const std::string& id) const;

  JobRunner& jobs_;
  Document& document_;
  TerritoryEstimator& estimator_;
  QTreeWidget* list_;
  std::vector<TumourMeasures> measured_;
  std::vector<TumourTerritories> territories_;  ///< the last known: a plane that moves changes nothing in them
  TerritoryMarks marks_;                        ///< what they are of
};

}  // namespace glisson
