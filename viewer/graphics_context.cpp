#include "viewer/graphics_context.h"

namespace glisson {

bool GraphicsContext::start() {
  if (started() || failed_) {
    return started();
  }
  auto surface = std::make_unique<QOffscreenSurface>();
  surface->setFormat(QSurfaceFormat::defaultFormat());
  surface->create();
  auto context = std::make_unique<QOpenGLContext>();
  context->setFormat(surface->requestedFormat());
  if (!surface->isValid() || !context->create() || context->isOpenGLES() || context->format().version() < qMakePair(3, 2) ||
      !context->makeCurrent(surface.get())) {
    failed_ = true;
    return false;
  }
  surface_ = std::move(surface);
  context_ = std::move(context);
  return true;
}

bool GraphicsContext::makeCurrent() { return context_ != nullptr && context_->makeCurrent(surface_.get()); }

void GraphicsContext::doneCurrent() {
  if (context_ != nullptr) {
    context_->doneCurrent();
  }
}

}  // namespace glisson
