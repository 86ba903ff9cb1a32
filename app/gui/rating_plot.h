#pragma once
// Purpose: a box plot of the ratings of each method [Palomar 2016, Fig. 8a]: quartiles, median, mean (diamond), whiskers at 1.5
// interquartile ranges, ratings beyond them as circles.

#include <QWidget>
#include <vector>

#include "app/gui/translated.h"
#include "reconstruction/evaluation/rating_results.h"

namespace glisson {

class RatingPlot : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit RatingPlot(QWidget* parent);
  void setMethods(std::vector<MethodRatings> methods);

 protected:
  void retranslateUi() override { update(); }
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<MethodRatings> methods_;
};

}  // namespace glisson
