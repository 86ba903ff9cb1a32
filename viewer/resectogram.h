#pragma once
// Purpose: the resection surface laid flat: the chosen plane as seen from the resected side, with the liver's outline, the crossed
// vessels and the margin colours of the 3D view, and their legend in mm. Lets the mouse through.

#include <QWidget>
#include <optional>

#include "viewer/resection_map.h"

namespace glisson {

class Resectogram : public QWidget {
  Q_OBJECT
 public:
  explicit Resectogram(QWidget* parent = nullptr);
  /// Nothing: hidden. `margins`: marginPicture() of the map.
  void setMap(std::optional<ResectionMap> map, const QImage& margins);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void drawMap(QPainter& painter, const QRectF& box) const;
  void drawLegend(QPainter& painter, const QRectF& box) const;

  std::optional<ResectionMap> map_;
  QImage margins_;
};

}  // namespace glisson
