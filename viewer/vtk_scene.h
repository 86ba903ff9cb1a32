#pragma once
// Purpose: the VTK half of VtkWidget: render window, two renderers, interactor, and how good the next frame has to be. Private to
// viewer/: only .cpp files include it.

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QTimer>
#include <functional>

#include "viewer/vtk_widget.h"

namespace glisson {

/// Moving: as fast as possible (simplified meshes, no peeling). Resting: full meshes, peeling where it fits into kFrameBudgetMs.
/// Picture: full meshes, exact peeling, whatever it costs.
enum class FrameQuality { Moving, Resting, Picture };

/// The window answers within this time, also where OpenGL runs in software (reliability.md).
inline constexpr double kFrameBudgetMs = 100.0;
/// How long nothing may move before the view counts as resting.
inline constexpr int kRestMs = 150;

struct VtkWidget::Scene {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;  ///< the model: layer 0
  vtkNew<vtkRenderer> overlay;   ///< what nothing may hide (handles, outline): layer 1, same camera
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  /// Called before every frame with its quality: the place to update actors and clipping range.
  std::function<void(FrameQuality)> beforeFrame;
  QTimer rest;                ///< single shot: the end of a movement
  bool moving = false;        ///< something moved within the last kRestMs
  bool cameraByHand = false;  ///< the user moved the camera since it was last placed
  bool picture = false;       ///< the frame being drawn is for picture()
  double plainMs = 0;         ///< time of the last full frame without peeling; 0 unknown
  double peeledMs = 0;        ///< time of the last peeled frame; 0 unknown
  double movingMs = 0;        ///< time of the last moving frame at full resolution; 0 unknown
  double area = 0;            ///< logical pixels of the last resize
  int movingFrames = 0;
  int plainFrames = 0;      ///< full frames drawn since the times were forgotten; the first of each kind also
  int peeledFrames = 0;     ///< uploads and compiles, so its time is not kept
  bool framePeels = false;  ///< set by chooseTransparency() for the frame being drawn

  /// Something moves: simplified frames until kRestMs have passed without another call.
  void touch();
  /// Depth peeling for this frame or not: by quality and by what frames have cost so far.
  void chooseTransparency(FrameQuality quality, bool anyTranslucent);
  /// Resolution of the next frame: moving frames that would miss the budget (software OpenGL) are drawn at half of it.
  [[nodiscard]] double frameScale(FrameQuality quality) const;
  /// After a full frame: keeps its time. True where another one is worth drawing soon (to measure it, or to peel).
  bool rememberFrameTime(FrameQuality quality, double scale, double ms);
  /// After the set of meshes has changed: old frame times say nothing.
  void forgetFrameTimes();
  /// After the size has changed by this factor of its area: the old times tell about the new ones.
  void scaleFrameTimes(double factor);
};

}  // namespace glisson
