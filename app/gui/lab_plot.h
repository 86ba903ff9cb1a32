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
  /// Places of A and B. A side that has none may have a model of the slider in `beside`: drawn open, no part of scores and fronts.
  void setChosen(const std::array<std::optional<std::size_t>, 2>& chosen,
                 const std::array<std::optional<EvaluatedModel>, 2>& beside = {});
  /// What to do, while there are no models.
  void setHint(const QString& hint);
  /// Where a model is drawn, logical pixels.
  [[nodiscard]] std::optional<QPointF> pixelOf(std::size_t place) const;
  /// Likewise of the slider's model on that side.
  [[nodiscard]] std::optional<QPointF> pixelBeside(std::size_t side) const;
  /// What the legend calls the published front: one so far until all published models are there or failed.
  [[nodiscard]] QString frontName() const;
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
  void drawBeside(QPainter& painter) const;
  void drawLetters(QPainter& painter) const;
  [[nodiscard]] QString tooltipOf(const EvaluatedModel& model, const ModelScore* score) const;

  Evaluation evaluation_;
  lab::AccuracyFigure figure_;
  std::array<std::optional<std::size_t>, 2> chosen_;
  std::array<std::optional<EvaluatedModel>, 2> beside_;
  QString hint_;
};

}  // namespace glisson
