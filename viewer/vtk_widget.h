#pragma once
// Purpose: VTK 9.1 inside a Qt 6 widget (Debian's QVTK is Qt 5 only): drawn in a context of its own (graphics_context.h), read back
// and painted. Translates Qt's mouse, wheel, key and resize events to the VTK interactor, in device pixels. VTK types stay out of
// this header. While something moves, frames are drawn without depth peeling; the resting frame follows 150 ms later.

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "viewer/frame_budget.h"

namespace glisson {

class VtkWidget : public QWidget {
  Q_OBJECT
 public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  /// Sets the default QSurfaceFormat VTK needs (core 3.2, depth 24, stencil 8). Call before QApplication is made.
  static void prepareSurfaceFormat();
  /// Draws again soon; several calls make one frame.
  void requestRender();
  /// Starts OpenGL soon, before there is something to show.
  void warmUp();
  /// Draws now what the next update of the window shows, and asks for that: both take a turn of the event loop each. For
  /// RedrawQueue.
  void drawInThisTurn();
  /// Draws the view as the screen would show it now; in haste it may have half the pixels. A null image where OpenGL is not
  /// available.
  [[nodiscard]] QImage nextFrame();
  /// What is seen, after all pending changes, with depth peeling. A null image where OpenGL is not available.
  [[nodiscard]] QImage picture();
  /// The same of a view of its own that nobody sees, kReportTiles times as wide and as high as the view, in steps that take little
  /// each: OpenGL starts, reduced meshes are uploaded, a few at a time, and the picture is drawn tile by tile. Nothing while some
  /// are left: ask again in the next turn of the event loop.
  [[nodiscard]] std::optional<QImage> reportPicture();
  static constexpr int kReportTiles = 2;

 signals:
  /// The camera stands elsewhere. Told at once, before the frame: of views that follow each other the one moved last is followed.
  void cameraMoved();
  /// A frame is there, and is painted with the next update of the window.
  void frameDrawn();

 protected:
  class WholeView;
  struct Scene;  ///< render window, renderer, interactor (viewer/vtk_scene.h, VTK types)
  [[nodiscard]] Scene& scene();
  /// To free what VTK has uploaded. Nothing where OpenGL has not started.
  void makeCurrent();
  void doneCurrent();
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

 private:
  /// On a screen, at least in part.
  [[nodiscard]] bool isSeen() const;
  /// Draws with the next update of the window.
  void drawSoon();
  /// OpenGL and VTK's half of it. False where it does not work.
  bool startGraphics();
  /// The next frame, into scene().image.
  void draw();
  [[nodiscard]] QImage readBack(const QSize& pixels) const;
  void connectRenderWindow();
  [[nodiscard]] QSize pixels() const;
  [[nodiscard]] QImage frameOf(FrameQuality quality);
  void placePointer(const QPointF& position, Qt::KeyboardModifiers modifiers, int repeat);

  std::unique_ptr<Scene> scene_;
};

}  // namespace glisson
