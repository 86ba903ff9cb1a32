#pragma once
// Purpose: the line that is dragged across a view to swipe between two pictures; lies over the view as its child. Arrow keys move
// it by a hundredth of the view (with Shift: a tenth).

#include <QWidget>

namespace glisson {

class SwipeDivider : public QWidget {
  Q_OBJECT
 public:
  explicit SwipeDivider(QWidget* view);
  /// 0 at the left edge, 1 at the right one; clamped.
  void setShare(double share);
  [[nodiscard]] double share() const { return share_; }
  /// Follows the view's size.
  void place();

 signals:
  void moved(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void moveTo(double share);

  double share_ = 0.5;
};

}  // namespace glisson
