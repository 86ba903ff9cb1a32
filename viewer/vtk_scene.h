#pragma once
// Purpose: the VTK half of VtkWidget: render window, two renderers, interactor, and how good the next frame has to be. Private to
// viewer/: only .cpp files include it.

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <QSize>
#include <QTimer>
#include <functional>
#include <optional>

#include "viewer/first_frames.h"
#include "viewer/frame_budget.h"
#include "viewer/graphics_context.h"
#include "viewer/view_camera.h"
#include "viewer/vtk_widget.h"

namespace glisson {

/// How long nothing may move before the view counts as resting.
inline constexpr int kRestMs = 150;
/// Between two resting frames of which the first left meshes for the next.
inline constexpr int kUploadGapMs = 20;

/// Which part of a picture larger than the view is drawn: x from the left, y from below.
struct Tile {
  int x = 0;
  int y = 0;
  [[nodiscard]] std::optional<Tile> next() const {
    if (x + 1 < VtkWidget::kReportTiles) {
      return Tile{x + 1, y};
    }
    return y + 1 < VtkWidget::kReportTiles ? std::optional(Tile{0, y + 1}) : std::nullopt;
  }
};

struct VtkWidget::Scene {
  GraphicsContext graphics;  ///< the first: goes behind the window that draws in it
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;  ///< the model: layer 0
  vtkNew<vtkRenderer> overlay;   ///< what nothing may hide (handles, outline): layer 1, same camera
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  /// Called before every frame with its quality: the place to update actors and clipping range.
  std::function<void(FrameQuality)> beforeFrame;
  /// Called in a turn before the frame with its quality: does what takes long, and says whether there was such.
  std::function<bool(FrameQuality)> aheadOfFrame;
  QTimer rest;                        ///< single shot: the end of a movement
  bool moving = false;                ///< something moved within the last kRestMs
  bool cameraByHand = false;          ///< the user moved the camera since it was last placed
  Pose told;                          ///< what cameraMoved() was last about
  std::optional<FrameQuality> asked;  ///< of the frame that is drawn for picture() or reportPicture()
  std::optional<Tile> tile;           ///< of the report's picture that is being drawn
  QImage tiles;                       ///< those drawn so far
  bool started = false;               ///< VTK knows that context
  bool warmsUp = false;               ///< OpenGL starts though nobody sees the view
  bool due = false;                   ///< what is to be seen has changed since the last frame
  QImage image;                       ///< the last frame, with fewer pixels than the view where drawn in haste; null before
  double area = 0;                    ///< logical pixels of the last resize
  FirstFrames first;                  ///< what was drawn in this context
  FrameBudget budget;                 ///< what frames have taken so far
  FramePlan frame;                    ///< the frame being drawn

  /// Of the next frame.
  [[nodiscard]] FrameQuality quality() const { return asked.value_or(moving ? FrameQuality::Moving : FrameQuality::Resting); }
  /// Something moves: simplified frames until kRestMs have passed without another call.
  void touch();
  /// Takes this plan for the frame being drawn: depth peeling and smooth edges or not.
  void use(const FramePlan& plan);
  /// Hides what would make this frame a long one, until first.release(). A picture shows everything.
  void holdNewProps();
  [[nodiscard]] Pose pose() const;
  /// As if the user had moved the camera there, but cameraMoved() does not tell of it.
  void setPose(const Pose& pose);
  /// For a view of this size, logical pixels.
  [[nodiscard]] ViewCamera camera(int width, int height) const;
  /// Places the camera so that the box fills the view, `aspect` = width / height. Unit vectors, mm LPS.
  void lookAt(const Eigen::AlignedBox3d& box, const Vec3& direction, const Vec3& up, double aspect);
  /// So that nothing seen is cut off in depth.
  void fitClippingRange();
};

}  // namespace glisson
