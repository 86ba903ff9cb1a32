#pragma once
// Purpose: the FLR card: what the user says about the patient, and the future liver remnant beside what is published about it.
// Information, not advice: no value is coloured or judged.

#include <QGroupBox>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace glisson {

class FlrCardBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit FlrCardBox(Document& document, QWidget* parent = nullptr);

 protected:
  void retranslateUi() override;

 private:
  void commit();
  void refreshFacts();
  void refreshCard();

  Document& document_;
  QLabel* heightLabel_;
  QLabel* weightLabel_;
  QLabel* conditionLabel_;
  QLabel* typeLabel_;
  QDoubleSpinBox* height_;
  QDoubleSpinBox* weight_;
  QComboBox* condition_;
  QComboBox* type_;
  QLabel* card_;
};

}  // namespace glisson
