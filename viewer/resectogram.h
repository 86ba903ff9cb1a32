#pragma once
// Purpose: the resection surface laid flat: the chosen plane as seen from the resected side, with the liver's outline, the crossed
// vessels and the margin colours of the 3D view, and their legend in mm. Its button folds it up to a line with a title. What is
// done on it with the mouse does not reach the view below.

#include <QWidget>
#include <optional>

#include "viewer/resection_map.h"

class QToolButton;

namespace glisson {

class Resectogram : public QWidget {
  Q_OBJECT
 public:
  explicit Resectogram(QWidget* parent = nullptr);
  /// Nothing: hidden. `margins`: marginPicture() of the map.
  void setMap(std::optional<ResectionMap> map, const QImage& margins);
  /// Unfolded is the default.
  void setUnfolded(bool unfolded);
  [[nodiscard]] bool unfolded() const { return unfolded_; }
  /// Of the title and the legend, in words that fit into this width or the shortest there are; the tooltip says them at length.
  [[nodiscard]] QStringList texts() const;
  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void unfoldedChanged(bool unfolded);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void retranslate();
  void drawMap(QPainter& painter, const QRectF& box) const;
  void drawLegend(QPainter& painter, const QRectF& box) const;

  QToolButton* fold_;
  bool unfolded_ = true;
  std::optional<ResectionMap> map_;
  QImage margins_;
};

}  // namespace glisson
