#pragma once
// Purpose: the scatter plot of the lab: mean paper error over triangles of the models so far, fronts as stairs. A click chooses
// model A; with Shift or the right button, B. Both carry their letter, and families differ by shape as well as by colour.

#include <QImage>
#include <QWidget>
#include <array>
#include <optional>

#include "app/gui/translated.h"
#include "app/lab/accuracy_figure.h"

class QPainter;

namespace glisson {

class LabPlot : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit LabPlot(QWidget* parent = nullptr);

  /// Shown until the next call; no larger than a few kB for each model.
  void setEvaluation(const Evaluation& evaluation);
  /// Places of A and B.
  void setChosen(const std::array<std::optional<std::size_t>, 2>& chosen);
  /// What to do, while there are no models.
  void setHint(const QString& hint);
  /// Where a model is drawn, logical pixels.
  [[nodiscard]] std::optional<QPointF> pixelOf(std::size_t place) const;
  /// The plot alone, twice as fine as on the screen.
  [[nodiscard]] QImage picture() const;
  [[nodiscard]] QSize sizeHint() const override { return {640, 260}; }

 signals:
  /// `side`: 0 for A, 1 for B.
  void chosen(std::size_t place, std::size_t side);

 protected:
  void retranslateUi() override { update(); }
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void layOut();
  void draw(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;
  [[nodiscard]] const lab::FigureMark* markAt(const QPointF& pixel) const;
  [[nodiscard]] QString tooltipOf(std::size_t place) const;

  Evaluation evaluation_;
  lab::AccuracyFigure figure_;
  std::array<std::optional<std::size_t>, 2> chosen_;
  QString hint_;
};

}  // namespace glisson
