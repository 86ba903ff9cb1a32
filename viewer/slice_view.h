#pragma once
// Purpose: one of three linked slice views: the CT with the labels' outlines, those of the surfaces that will be exported (thin,
// on a dark edge), the crosshair and the plane's line. Drawn with QPainter. Radiological convention: seen from the feet, patient
// right on the left of the picture; letters R L A P S I at the edges. Mouse: wheel steps, left click places the crosshair,
// right-drag zooms, middle-drag pans, Ctrl+right-drag window/level; arrow keys step, r resets. The plane's line carries ticks on
// the resected side.

#include <QWidget>
#include <memory>
#include <optional>

#include "planning/case/case.h"

namespace glisson {

enum class SliceAxis { Axial, Coronal, Sagittal };

struct WindowLevel {
  double width = 350;  ///< abdomen
  double level = 40;
  bool operator==(const WindowLevel&) const = default;
};

class SliceView : public QWidget {
  Q_OBJECT
 public:
  explicit SliceView(SliceAxis axis, QWidget* parent = nullptr);
  ~SliceView() override;

  /// The CT (may be null: outlines on black) and the masks. Slices run along the index axis nearest to the view's LPS axis. With
  /// `liver` the parenchyma's outline is that of L, the voxels every number counts; else that of its mask as it was read.
  void setVolumes(std::shared_ptr<const CtVolume> ct, std::shared_ptr<const Segmentation> segmentation,
                  std::shared_ptr<const LiverVoxels> liver = nullptr);
  /// Why there is no CT: stands in the view until one comes.
  void setNoCt(const QString& reason);
  /// Visibility and colours of outlines come from the model's structures (by sourceIndex).
  void setModel(std::shared_ptr<const LiverModel> model);
  /// For views that compare surfaces: their outlines in the structures' full colours, each with a line style of its own and its
  /// structure's id as its letter, and a legend. Thin on a dark edge is the default.
  void setSurfacesCompared(bool compared);
  /// The plane that is worked on, and the others of the plan.
  void setPlane(std::optional<ResectionPlane> plane, std::vector<ResectionPlane> others = {});
  /// mm LPS; steps to the slice that holds it. Emits no signal.
  void setCrosshair(const Vec3& worldMm);
  void setWindowLevel(const WindowLevel& windowLevel);

  /// mm LPS; where the crosshair is.
  [[nodiscard]] Vec3 crosshair() const;
  [[nodiscard]] int slice() const;
  /// Where a point of the shown slice (or the nearest point of it) is drawn, in this widget's logical pixels; nothing without a
  /// volume.
  [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3& worldMm) const;

 signals:
  void crosshairMoved(const glisson::Vec3& worldMm);
  void windowLevelChanged(const glisson::WindowLevel& windowLevel);
  void maximiseRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void placeCrosshair(const QPointF& pixel);
  void stepSlices(int steps);
  void retranslate();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
