#pragma once
// Purpose: a 3D view of one surface, or of two with a line between them that is dragged across: left of it the one is seen, right
// of it the other, from the same camera. Coloured by errors on a given scale; shaded or as wires. At rest the surface itself is
// drawn, however many triangles it has: it is what is compared. Frame: mm LPS. Mouse: left rotates, middle pans, right or wheel
// zooms; 1/3/7 anterior/left/superior.

#include <memory>

#include "viewer/display_mesh.h"
#include "viewer/surface_errors.h"
#include "viewer/view_camera.h"
#include "viewer/vtk_widget.h"

namespace glisson {

struct ShownSurface {
  std::shared_ptr<const DisplayMesh> mesh;      ///< null: nothing
  std::shared_ptr<const SurfaceErrors> errors;  ///< of this mesh; null: a plain colour
  bool operator==(const ShownSurface&) const = default;
};

class SurfaceView : public VtkWidget {
  Q_OBJECT
 public:
  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  /// With a mesh in both the line stands between them. The camera is placed (from anterior) where nothing was shown before.
  void setSurfaces(const ShownSurface& left, const ShownSurface& right = {});
  /// The error at the end of the colours, mm, above 0.
  void setScale(double mm);
  void setWireframe(bool wireframe);
  /// Where the line stands: 0 at the left edge, 1 at the right one.
  void setDivider(double share);
  [[nodiscard]] double divider() const;
  [[nodiscard]] bool swipes() const;

  [[nodiscard]] Pose pose() const;
  [[nodiscard]] ViewCamera camera() const;
  /// From now on both views have one camera.
  static void link(SurfaceView& one, SurfaceView& other);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void follow(const SurfaceView& other);
  void lookFrom(const Vec3& direction, const Vec3& up);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
