#pragma once
// Purpose: what the lab is to do: which structure, which families, how PSR samples, start and cancel; the depth slider; exports.

#include <QWidget>
#include <memory>
#include <vector>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "reconstruction/evaluation/recipe.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSlider;

namespace glisson {

class LabExperiment;

class LabSetup : public Translated<QWidget> {
  Q_OBJECT
 public:
  LabSetup(Document& document, LabExperiment& experiment, QWidget* parent);

  /// The structure of the case that is chosen; nothing without a case.
  [[nodiscard]] const Structure* structure() const;
  [[nodiscard]] std::vector<ModelFamily> families() const;
  [[nodiscard]] ExperimentOptions options() const;
  /// The side that the depth slider is for: 0 for A, 1 for B.
  [[nodiscard]] std::size_t depthSide() const;

 signals:
  void subjectChanged();  ///< another structure, sampling or scale
  void compareRequested();
  void ratingRequested();
  void depthChosen(int depth);
  void csvRequested();
  void pngRequested();
  void svgRequested();

 protected:
  void retranslateUi() override;

 private:
  void build();
  void connectParts();
  void listStructures();
  void refresh();
  /// Why nothing can be started; empty where it can.
  [[nodiscard]] QString refusal() const;

  Document& document_;
  LabExperiment& experiment_;
  QLabel* structureTitle_;
  QComboBox* structures_;
  QLabel* familiesTitle_;
  std::vector<QCheckBox*> families_;
  QLabel* optionsTitle_;
  QComboBox* sampling_;
  QComboBox* scale_;
  QPushButton* compare_;
  QPushButton* cancel_;
  QPushButton* rate_;
  QLabel* progress_;
  QLabel* depthTitle_;
  QSlider* depth_;
  QRadioButton* depthA_;
  QRadioButton* depthB_;
  QLabel* exportTitle_;
  QPushButton* csv_;
  QPushButton* png_;
  QPushButton* svg_;
};

}  // namespace glisson
