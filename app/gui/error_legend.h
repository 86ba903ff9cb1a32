#pragma once
// Purpose: what the colours of the compared surfaces mean: one scale for both, mm.

#include <QWidget>

#include "app/gui/translated.h"

namespace glisson {

class ErrorLegend : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit ErrorLegend(QWidget* parent = nullptr);
  /// The error at the end of the scale, mm.
  void setScale(double mm);
  [[nodiscard]] double scaleMm() const { return scaleMm_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void retranslateUi() override;
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] static QString caption();

  double scaleMm_ = 1;
};

}  // namespace glisson
