#pragma once
// Purpose: what is being pointed at over the 3D view: points clicked so far, the stroke being drawn. Lets the mouse through.

#include <QWidget>
#include <vector>

#include "viewer/view_camera.h"

namespace glisson {

class PickOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit PickOverlay(QWidget* view);
  void show(const std::vector<Pixel>& points, bool joined);
  void clear();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Pixel> points_;
  bool joined_ = false;
};

}  // namespace glisson
