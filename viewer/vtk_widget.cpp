#include "viewer/vtk_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRendererCollection.h>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>
#include <QSurfaceFormat>
#include <cmath>
#include <numbers>
#include <utility>

#include "viewer/redraw_queue.h"
#include "viewer/vtk_scene.h"

namespace glisson {

namespace {

/// Connects a VTK event of `object` to a function of a widget.
void observe(vtkObject* object, unsigned long event, void* receiver, void (*call)(vtkObject*, unsigned long, void*, void*)) {
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(receiver);
  command->SetCallback(call);
  object->AddObserver(event, command);
}

}  // namespace

/// The camera looks through the tile that is drawn, if there is one, and again through the whole view at the end.
class VtkWidget::WholeView {
 public:
  explicit WholeView(Scene& scene) : scene_(scene), angle_(scene.renderer->GetActiveCamera()->GetViewAngle()) {
    if (scene.tile) {
      const auto share = [](int at) { return 2.0 * at + 1 - kReportTiles; };  // VTK: of half a tile, from the middle
      look(2 * std::atan(std::tan(0.5 * angle_ * kDegree) / kReportTiles) / kDegree, share(scene.tile->x), share(scene.tile->y));
    }
  }
  ~WholeView() {
    if (scene_.tile) {
      look(angle_, 0, 0);
    }
  }
  WholeView(const WholeView&) = delete;
  WholeView& operator=(const WholeView&) = delete;

 private:
  static constexpr double kDegree = std::numbers::pi / 180.0;
  void look(double angle, double x, double y) {
    vtkCamera* camera = scene_.renderer->GetActiveCamera();  // the overlay's too
    camera->SetViewAngle(angle);
    camera->SetWindowCenter(x, y);
  }

  Scene& scene_;
  double angle_;
};

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent), scene_(std::make_unique<Scene>()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(120, 90);
  Scene& s = *scene_;
  s.renderer->SetLayer(0);
  s.overlay->SetLayer(1);
  s.overlay->InteractiveOff();
  s.overlay->SetActiveCamera(s.renderer->GetActiveCamera());
  s.window->SetNumberOfLayers(2);
  s.window->AddRenderer(s.renderer);
  s.window->AddRenderer(s.overlay);
  connectRenderWindow();

  s.rest.setSingleShot(true);
  connect(&s.rest, &QTimer::timeout, this, [this] {
    if (scene_->budget.restingIsSlow() && QGuiApplication::mouseButtons() != Qt::NoButton) {
      scene_->rest.start(kRestMs);  // a hand that pauses in a drag must not wait for a slow full frame
      return;
    }
    scene_->moving = false;
    RedrawQueue::instance().add(this);
  });
}

VtkWidget::~VtkWidget() {
  if (context() != nullptr) {
    disconnect(context(), nullptr, this, nullptr);
    releaseGraphics();
  }
}

void VtkWidget::connectRenderWindow() {
  Scene& s = *scene_;
  s.window->SetMultiSamples(0);  // depth peeling needs single samples
  s.window->SetOwnContext(0);
  s.window->SetFrameBlitModeToNoBlit();
  s.window->SetSupportsOpenGL(1);
  s.window->SetIsDirect(1);
  // Not QOpenGLWidget::makeCurrent(): it rebinds the widget's own framebuffer in the middle of VTK's frame.
  observe(s.window, vtkCommand::WindowMakeCurrentEvent, this, [](vtkObject*, unsigned long, void* receiver, void*) {
    QOpenGLContext* context = static_cast<VtkWidget*>(receiver)->context();
    if (context != nullptr) {
      context->makeCurrent(context->surface());
    }
  });
  observe(s.window, vtkCommand::WindowIsCurrentEvent, this, [](vtkObject*, unsigned long, void* receiver, void* answer) {
    *static_cast<bool*>(answer) = static_cast<VtkWidget*>(receiver)->context() == QOpenGLContext::currentContext();
  });

  // The interactor never draws by itself: it asks, and Qt makes one frame of many requests.
  s.interactor->EnableRenderOff();
  s.interactor->SetRenderWindow(s.window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  style->SetDefaultRenderer(s.renderer);
  s.interactor->SetInteractorStyle(style);
  observe(s.interactor, vtkCommand::RenderEvent, this, [](vtkObject*, unsigned long, void* receiver, void*) {
    auto* widget = static_cast<VtkWidget*>(receiver);
    widget->scene_->cameraByHand = true;
    widget->scene_->touch();
    widget->requestRender();
  });
  s.interactor->Initialize();
}

void VtkWidget::prepareSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void VtkWidget::requestRender() {
  if (QGuiApplication::mouseButtons() != Qt::NoButton) {
    drawSoon();  // in one turn with what a drag moves along
  } else {
    RedrawQueue::instance().add(this);
  }
}

void VtkWidget::drawSoon() {
  scene_->due = true;
  update();
}

QImage VtkWidget::picture() {
  if (!isValid() && !window()->isVisible()) {
    // OpenGL needs a window: make one that nobody sees.
    QWidget* top = window();
    top->setAttribute(Qt::WA_DontShowOnScreen);
    top->show();
    QImage image = picture();
    top->hide();
    top->setAttribute(Qt::WA_DontShowOnScreen, false);
    return image;
  }
  return frameOf(FrameQuality::Picture);
}

std::optional<QImage> VtkWidget::reportPicture() {
  if (!isVisible()) {
    setAttribute(Qt::WA_DontShowOnScreen);
    setUpdatesEnabled(false);  // drawn only when it is asked
    show();
    scene_->due = true;
    grabFramebuffer();  // OpenGL starts in a turn of its own
    return isValid() ? std::nullopt : std::optional(QImage());
  }
  if (!isValid()) {
    return QImage();
  }
  Scene& s = *scene_;
  if (s.drawn.isEmpty()) {
    static_cast<void>(frameOf(FrameQuality::Moving));  // the programs without depth peeling are compiled in a turn of their own
    return std::nullopt;
  }
  if (!s.tile) {
    s.tile = Tile();
    s.tiles = QImage(kReportTiles * pixels(), QImage::Format_RGB32);
  }
  const QImage drawn = frameOf(FrameQuality::Report);
  if (s.frame.moreToUpload) {
    return std::nullopt;
  }
  QPainter painter(&s.tiles);
  painter.drawImage(QRect(QPoint(s.tile->x * pixels().width(), (kReportTiles - 1 - s.tile->y) * pixels().height()), pixels()),
                    drawn);
  painter.end();
  s.tile = s.tile->next();
  return s.tile ? std::nullopt : std::optional(std::exchange(s.tiles, QImage()));
}

QImage VtkWidget::frameOf(FrameQuality quality) {
  scene_->asked = quality;
  QImage image = grabFramebuffer();
  scene_->asked.reset();
  return image;
}

VtkWidget::Scene& VtkWidget::scene() { return *scene_; }

void VtkWidget::initializeGL() {
  // A widget that moves to another window gets a new context: what VTK uploaded belongs to the old one.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::releaseGraphics, Qt::DirectConnection);
  scene_->started = false;
  scene_->budget.forget();
}

void VtkWidget::releaseGraphics() {
  makeCurrent();
  scene_->window->Finalize();
  scene_->window->SetReadyForRendering(false);
  scene_->started = false;
  scene_->hasStretched = false;
  scene_->first.forget();
  scene_->drawn = {};
  doneCurrent();
}

void VtkWidget::resizeGL(int width, int height) {
  const double area = std::max(1.0, static_cast<double>(width) * height);
  scene_->budget.areaChanged(scene_->area > 0 ? area / scene_->area : 1.0);
  scene_->area = area;
  scene_->touch();  // Qt draws at once after every step of a resize: quick frames until it rests
}

void VtkWidget::resizeEvent(QResizeEvent* event) {
  scene_->resizing = true;
  QOpenGLWidget::resizeEvent(event);  // draws at once what nobody sees
  scene_->resizing = false;
  const QSize size = pixels();
  scene_->interactor->UpdateSize(size.width(), size.height());  // the mouse may come before the first frame
  requestRender();
}

QSize VtkWidget::pixels() const {
  const double ratio = devicePixelRatioF();
  return {qRound(width() * ratio), qRound(height() * ratio)};
}

void VtkWidget::paintGL() {
  Scene& s = *scene_;
  const QSize pixels = this->pixels();
  if (s.resizing || (!std::exchange(s.due, false) && !s.asked)) {
    // Qt composes the window anew for a reason of its own, perhaps with many views in one turn: the last frame will do until
    // this view's own turn
    repeatFrame(pixels);
    return;
  }
  if (!std::exchange(s.started, true)) {
    s.window->SetReadyForRendering(true);
    s.window->OpenGLInitContext();
    if (!s.asked) {
      repeatFrame(pixels);  // that alone was a long turn
      return;
    }
  }
  s.interactor->UpdateSize(pixels.width(), pixels.height());
  const FrameQuality quality = s.asked.value_or(s.moving ? FrameQuality::Moving : FrameQuality::Resting);
  if (s.beforeFrame) {
    s.beforeFrame(quality);
  }
  const double scale = s.frame.scale;
  if (scale < 1 && !std::exchange(s.hasStretched, true)) {
    // A software renderer compiles a program for it: in a turn of its own.
    s.stretches = true;
    s.drawn -= QSize(1, 1);
    repeatFrame(pixels);
    drawSoon();
    return;
  }
  s.stretches = scale < 1;
  s.window->SetDPI(qRound(72 * devicePixelRatioF() * scale));
  vtkOpenGLState* state = s.window->GetState();
  state->Reset();
  state->Push();
  QElapsedTimer clock;
  clock.start();
  s.window->SetSize(qRound(pixels.width() * scale), qRound(pixels.height() * scale));
  const WholeView whole(s);
  s.holdNewProps();
  s.window->Render();
  s.first.release();
  context()->functions()->glFinish();  // a software renderer works behind our back: what a frame costs is known only now
  const double ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  s.drawn = QSize(qRound(pixels.width() * scale), qRound(pixels.height() * scale));
  copyToWidget(pixels);
  state->Pop();
  s.window->SetSize(pixels.width(), pixels.height());  // the interactor measures the mouse against it
  if (s.budget.remember(s.frame, ms)) {
    s.rest.start(s.frame.moreToUpload ? kUploadGapMs : kRestMs);
  } else if (s.moving && !s.asked && s.frame.moreToUpload) {
    RedrawQueue::instance().add(this);  // a hand that pauses in a drag sees all of it
  }
}

void VtkWidget::repeatFrame(const QSize& pixels) {
  Scene& s = *scene_;
  if (!s.drawn.isValid()) {
    clearToBackground();
    RedrawQueue::instance().add(this);
    return;
  }
  vtkOpenGLState* state = s.window->GetState();
  state->Reset();
  state->Push();
  copyToWidget(pixels);
  state->Pop();
}

void VtkWidget::clearToBackground() {
  const double* colour = scene_->renderer->GetBackground();
  QOpenGLFunctions* gl = context()->functions();
  gl->glClearColor(static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2]), 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
}

void VtkWidget::copyToWidget(const QSize& pixels) {
  vtkGenericOpenGLRenderWindow* window = scene_->window;
  vtkOpenGLFramebufferObject* display = window->GetDisplayFramebuffer();
  if (display == nullptr) {
    return;
  }
  const QSize size = scene_->drawn;
  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  display->Bind(GL_READ_FRAMEBUFFER);
  display->ActivateReadBuffer(0);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  if (scene_->stretches) {
    gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, pixels.width(), pixels.height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);
  } else {
    // The frame of another size is not stretched: the middle stays in the middle, and no program must be compiled for it.
    if (size != pixels) {
      clearToBackground();
    }
    const QRect from = QRect({}, size) & QRect((size.width() - pixels.width()) / 2, (size.height() - pixels.height()) / 2,
                                               pixels.width(), pixels.height());
    const QPoint to((pixels.width() - from.width()) / 2, (pixels.height() - from.height()) / 2);
    gl->glBlitFramebuffer(from.x(), from.y(), from.x() + from.width(), from.y() + from.height(), to.x(), to.y(),
                          to.x() + from.width(), to.y() + from.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  // Qt composes the widget with its alpha; what VTK left there would let the window shine through.
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->PopFramebufferBindings();
  state->Reset();
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

void VtkWidget::placePointer(const QPointF& position, Qt::KeyboardModifiers modifiers, int repeat) {
  const double ratio = devicePixelRatioF();
  scene_->interactor->SetEventInformationFlipY(qRound(position.x() * ratio), qRound(position.y() * ratio),
                                               modifiers.testFlag(Qt::ControlModifier) ? 1 : 0,
                                               modifiers.testFlag(Qt::ShiftModifier) ? 1 : 0, 0, repeat, nullptr);
}

bool VtkWidget::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
      scene_->interactor->InvokeEvent(vtkCommand::EnterEvent, nullptr);
      break;
    case QEvent::Leave:
      scene_->interactor->InvokeEvent(vtkCommand::LeaveEvent, nullptr);
      break;
    case QEvent::ShortcutOverride:
      // 1, 3, 7 and the plane's keys belong to the view that has the focus.
      if (static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_1 || key == Qt::Key_3 || key == Qt::Key_7 || key == Qt::Key_Plus || key == Qt::Key_Minus) {
          event->accept();
          return true;
        }
      }
      break;
    case QEvent::NativeGesture: {
      auto* gesture = static_cast<QNativeGestureEvent*>(event);
      if (gesture->gestureType() == Qt::ZoomNativeGesture) {
        scene_->renderer->GetActiveCamera()->Dolly(std::clamp(1.0 + gesture->value(), 0.5, 2.0));
        scene_->cameraByHand = true;
        scene_->touch();
        requestRender();
        return true;
      }
      break;
    }
    default:
      break;
  }
  return QOpenGLWidget::event(event);
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
  placePointer(event->position(), event->modifiers(), event->type() == QEvent::MouseButtonDblClick ? 1 : 0);
  switch (event->button()) {
    case Qt::LeftButton:
      scene_->interactor->LeftButtonPressEvent();
      break;
    case Qt::MiddleButton:
      scene_->interactor->MiddleButtonPressEvent();
      break;
    case Qt::RightButton:
      scene_->interactor->RightButtonPressEvent();
      break;
    default:
      break;
  }
  event->accept();
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
  placePointer(event->position(), event->modifiers(), 0);
  scene_->interactor->MouseMoveEvent();
  event->accept();
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
  placePointer(event->position(), event->modifiers(), 0);
  switch (event->button()) {
    case Qt::LeftButton:
      scene_->interactor->LeftButtonReleaseEvent();
      break;
    case Qt::MiddleButton:
      scene_->interactor->MiddleButtonReleaseEvent();
      break;
    case Qt::RightButton:
      scene_->interactor->RightButtonReleaseEvent();
      break;
    default:
      break;
  }
  event->accept();
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
  const int delta = event->angleDelta().y();
  if (delta != 0) {
    // One notch is 120; a touch pad sends many small parts of it, so the factor follows the angle (1.1 per notch).
    scene_->renderer->GetActiveCamera()->Dolly(std::pow(1.1, std::clamp(delta, -960, 960) / 120.0));
    scene_->cameraByHand = true;
    scene_->touch();
    requestRender();
  }
  event->accept();
}

void VtkWidget::keyPressEvent(QKeyEvent* event) {
  // No CharEvent: VTK's styles answer letters with wireframe, stereo or the end of the program.
  const QByteArray text = event->text().toLatin1();
  scene_->interactor->SetKeyEventInformation(event->modifiers().testFlag(Qt::ControlModifier) ? 1 : 0,
                                             event->modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0,
                                             text.isEmpty() ? '\0' : text[0], event->count(), nullptr);
  scene_->interactor->KeyPressEvent();
  QOpenGLWidget::keyPressEvent(event);
}

void VtkWidget::keyReleaseEvent(QKeyEvent* event) {
  scene_->interactor->KeyReleaseEvent();
  QOpenGLWidget::keyReleaseEvent(event);
}

}  // namespace glisson
