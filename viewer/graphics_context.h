#pragma once
// Purpose: an OpenGL context with nothing on the screen. The 3D views draw there and paint what they read back, so that the window
// itself is a plain raster one: with OpenGL in software, to compose a window through it takes 25 to 45 ms at every change of a
// label, and a view of 1000 x 800 pixels is read back in 2. UI thread.

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <memory>

namespace glisson {

class GraphicsContext {
 public:
  /// Makes the context of the default QSurfaceFormat and makes it current. False where OpenGL 3.2 does not work; asked only once.
  bool start();
  [[nodiscard]] bool started() const { return context_ != nullptr; }
  [[nodiscard]] bool failed() const { return failed_; }
  /// False before start(), and where the system has lost it.
  bool makeCurrent();
  void doneCurrent();
  [[nodiscard]] bool isCurrent() const { return context_ != nullptr && QOpenGLContext::currentContext() == context_.get(); }
  /// Null until started().
  [[nodiscard]] QOpenGLContext* context() const { return context_.get(); }

 private:
  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;  ///< goes before its surface
  bool failed_ = false;
};

}  // namespace glisson
