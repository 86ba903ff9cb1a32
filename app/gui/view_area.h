#pragma once
// Purpose: the four linked views: axial, 3D / coronal, sagittal; a double click maximises one and restores. Shows a document.

#include <QWidget>
#include <array>

#include "app/gui/document.h"
#include "viewer/model_view.h"
#include "viewer/slice_view.h"

class QGridLayout;

namespace glisson {

class ViewArea : public QWidget {
  Q_OBJECT
 public:
  explicit ViewArea(Document& document, QWidget* parent = nullptr);

  [[nodiscard]] ModelView& modelView() { return *modelView_; }
  void setWindowLevel(const WindowLevel& windowLevel);
  /// The crosshair in all slice views, mm LPS.
  void setCrosshair(const Vec3& worldMm);

 signals:
  void windowLevelChanged(const glisson::WindowLevel& windowLevel);

 private:
  void showVolumes();
  void showModel();
  void showPlane();
  void toggleMaximised(QWidget* view);

  Document& document_;
  QGridLayout* grid_;
  ModelView* modelView_;
  std::array<SliceView*, 3> slices_{};
  QWidget* maximised_ = nullptr;
};

}  // namespace glisson
