#pragma once
// Purpose: the four linked views: axial, 3D / coronal, sagittal; a double click maximises one and restores. Shows a document.

#include <QWidget>
#include <array>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "viewer/model_view.h"
#include "viewer/slice_view.h"

class QGridLayout;

namespace glisson {

class ViewArea : public Translated<QWidget> {
  Q_OBJECT
 public:
  ViewArea(Document& document, JobRunner& jobs, QWidget* parent = nullptr);

  [[nodiscard]] ModelView& modelView() { return *modelView_; }
  /// The surfaces of the 3D view, for other views of the same model.
  [[nodiscard]] const std::vector<std::shared_ptr<const DisplayMesh>>& displayMeshes() const { return ready_; }
  void setWindowLevel(const WindowLevel& windowLevel);
  /// The crosshair in all slice views, mm LPS.
  void setCrosshair(const Vec3& worldMm);
  [[nodiscard]] const Vec3& crosshair() const { return crosshair_; }

 signals:
  void windowLevelChanged(const glisson::WindowLevel& windowLevel);

 protected:
  void retranslateUi() override;

 private:
  void showVolumes();
  void showModel();
  void showPlane();
  void showMargin();
  void toggleMaximised(QWidget* view);

  void prepareMeshes();

  Document& document_;
  JobRunner& jobs_;
  /// What the 3D view needs of the surfaces of the model, as far as it is made.
  std::vector<std::shared_ptr<const DisplayMesh>> ready_;
  JobId preparing_ = 0;  ///< the job that makes more of it; 0: none
  QGridLayout* grid_;
  ModelView* modelView_;
  std::array<SliceView*, 3> slices_{};
  QWidget* maximised_ = nullptr;
  Vec3 crosshair_ = Vec3::Zero();
};

}  // namespace glisson
