#pragma once
// Purpose: what the ratings say: the box plot, a table, the tests in words with their numbers.

#include <QWidget>

#include "app/gui/translated.h"
#include "reconstruction/evaluation/rating_results.h"

class QLabel;
class QPushButton;

namespace glisson {

class RatingPlot;

class RatingResultsPage : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit RatingResultsPage(QWidget* parent);
  void setResults(RatingResults results);

 signals:
  void saveRequested();
  void backRequested();

 protected:
  void retranslateUi() override;

 private:
  RatingResults results_;
  QLabel* title_;
  RatingPlot* plot_;
  QLabel* text_;
  QPushButton* save_;
  QPushButton* back_;
};

}  // namespace glisson
