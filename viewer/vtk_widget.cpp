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
#include <QOpenGLFunctions>
#include <QPainter>
#include <QSurfaceFormat>
#include <QWindow>
#include <cmath>
#include <span>
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
  void look(double angle, double x, double y) {
    vtkCamera* camera = scene_.renderer->GetActiveCamera();  // the overlay's too
    camera->SetViewAngle(angle);
    camera->SetWindowCenter(x, y);
  }

  Scene& scene_;
  double angle_;
};

VtkWidget::VtkWidget(QWidget* parent) : QWidget(parent), scene_(std::make_unique<Scene>()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
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
  if (scene_->started) {
    makeCurrent();
    scene_->window->Finalize();
    scene_->window->SetReadyForRendering(false);
    doneCurrent();
  }
}

void VtkWidget::makeCurrent() { scene_->graphics.makeCurrent(); }

void VtkWidget::doneCurrent() { scene_->graphics.doneCurrent(); }

void VtkWidget::connectRenderWindow() {
  Scene& s = *scene_;
  s.window->SetMultiSamples(0);  // depth peeling needs single samples
  s.window->SetOwnContext(0);
  s.window->SetFrameBlitModeToNoBlit();
  s.window->SetSupportsOpenGL(1);
  s.window->SetIsDirect(1);
  observe(s.window, vtkCommand::WindowMakeCurrentEvent, this,
          [](vtkObject*, unsigned long, void* receiver, void*) { static_cast<VtkWidget*>(receiver)->makeCurrent(); });
  observe(s.window, vtkCommand::WindowIsCurrentEvent, this, [](vtkObject*, unsigned long, void* receiver, void* answer) {
    *static_cast<bool*>(answer) = static_cast<VtkWidget*>(receiver)->scene_->graphics.isCurrent();
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
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void VtkWidget::requestRender() {
  if (const Pose now = scene_->pose(); now != scene_->told) {
    scene_->told = now;
    emit cameraMoved();
  }
  if (QGuiApplication::mouseButtons() != Qt::NoButton) {
    drawSoon();
  } else {
    RedrawQueue::instance().add(this);
  }
}

void VtkWidget::drawSoon() {
  scene_->due = true;
  update();
}

bool VtkWidget::isSeen() const {
  const QWindow* shown = window()->windowHandle();
  return isVisible() && shown != nullptr && shown->isExposed();
}

void VtkWidget::drawInThisTurn() {
  Scene& s = *scene_;
  const bool seen = isSeen();
  if (!s.started && !s.graphics.failed() && (seen || s.warmsUp)) {
    // OpenGL, then VTK's half of it: each a long turn.
    if (!s.graphics.started()) {
      s.graphics.start();
      doneCurrent();
    } else {
      startGraphics();
    }
    RedrawQueue::instance().add(this);
  } else if (seen && s.started) {
    if (s.aheadOfFrame && s.aheadOfFrame(s.quality())) {
      RedrawQueue::instance().add(this);
    } else {
      draw();
      update();
    }
  } else {
    drawSoon();
  }
}

void VtkWidget::warmUp() {
  scene_->warmsUp = true;
  RedrawQueue::instance().add(this);
}

QImage VtkWidget::nextFrame() {
  if (startGraphics()) {
    draw();
  }
  return scene_->image;
}

QImage VtkWidget::picture() {
  if (!window()->isVisible()) {
    // Sizes and layouts need a window: make one that nobody sees.
    QWidget* top = window();
    top->setAttribute(Qt::WA_DontShowOnScreen);
    top->show();
    QImage image = frameOf(FrameQuality::Picture);
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
    return startGraphics() ? std::nullopt : std::optional(QImage());  // in a turn of its own
  }
  Scene& s = *scene_;
  if (!s.started) {
    return QImage();
  }
  if (s.image.isNull()) {
    static_cast<void>(frameOf(FrameQuality::Moving));  // the programs without depth peeling are compiled in a turn of their own
    return std::nullopt;
  }
  if (!s.tile) {
    s.tile = Tile();
    s.tiles = QImage(kReportTiles * pixels(), QImage::Format_RGB32);
  }
  QImage drawn = frameOf(FrameQuality::Report);
  if (s.frame.moreToUpload) {
    return std::nullopt;
  }
  drawn.setDevicePixelRatio(1);
  QPainter painter(&s.tiles);
  painter.drawImage(QPoint(s.tile->x * pixels().width(), (kReportTiles - 1 - s.tile->y) * pixels().height()), drawn);
  painter.end();
  s.tile = s.tile->next();
  return s.tile ? std::nullopt : std::optional(std::exchange(s.tiles, QImage()));
}

QImage VtkWidget::frameOf(FrameQuality quality) {
  scene_->asked = quality;
  QImage image = nextFrame();
  scene_->asked.reset();
  return image;
}

VtkWidget::Scene& VtkWidget::scene() { return *scene_; }

bool VtkWidget::startGraphics() {
  Scene& s = *scene_;
  if (s.started || !s.graphics.start()) {
    return s.started;
  }
  makeCurrent();
  s.started = true;
  s.window->SetReadyForRendering(true);
  s.window->OpenGLInitContext();
  doneCurrent();
  return true;
}

void VtkWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const double area = std::max(1.0, static_cast<double>(width()) * height());
  scene_->budget.areaChanged(scene_->area > 0 ? area / scene_->area : 1.0);
  scene_->area = area;
  const QSize size = pixels();
  scene_->interactor->UpdateSize(size.width(), size.height());  // the mouse may come before the first frame
  scene_->touch();                                              // quick frames until it rests
  requestRender();
}

QSize VtkWidget::pixels() const {
  const double ratio = devicePixelRatioF();
  return {qRound(width() * ratio), qRound(height() * ratio)};
}

void VtkWidget::draw() {
  Scene& s = *scene_;
  s.due = false;
  if (!s.graphics.makeCurrent()) {
    return;
  }
  const QSize pixels = this->pixels();
  s.interactor->UpdateSize(pixels.width(), pixels.height());
  if (s.beforeFrame) {
    s.beforeFrame(s.quality());
  }
  const double scale = s.frame.scale;
  const QSize drawn(std::max(1, qRound(pixels.width() * scale)), std::max(1, qRound(pixels.height() * scale)));
  s.window->SetDPI(qRound(72 * devicePixelRatioF() * scale));
  s.window->GetState()->Reset();
  QElapsedTimer clock;
  clock.start();
  s.window->SetSize(drawn.width(), drawn.height());
  const WholeView whole(s);
  s.holdNewProps();
  s.window->Render();
  s.first.release();
  s.image = readBack(drawn);  // waits for a software renderer, which works behind our back: what a frame costs is known only now
  const double ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  s.image.setDevicePixelRatio(devicePixelRatioF() * scale);
  s.window->SetSize(pixels.width(), pixels.height());  // the interactor measures the mouse against it
  doneCurrent();
  if (s.budget.remember(s.frame, ms)) {
    s.rest.start(s.frame.moreToUpload ? kUploadGapMs : kRestMs);
  } else if (s.moving && !s.asked && s.frame.moreToUpload) {
    RedrawQueue::instance().add(this);  // a hand that pauses in a drag sees all of it
  }
  emit frameDrawn();
}

QImage VtkWidget::readBack(const QSize& pixels) const {
  QImage image(pixels, QImage::Format_RGB32);
  vtkOpenGLFramebufferObject* display = scene_->window->GetDisplayFramebuffer();
  if (display == nullptr) {
    return {};
  }
  vtkOpenGLState* state = scene_->window->GetState();
  state->PushReadFramebufferBinding();
  display->Bind(GL_READ_FRAMEBUFFER);
  display->ActivateReadBuffer(0);
  QOpenGLFunctions* gl = scene_->graphics.context()->functions();
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, pixels.width(), pixels.height(), GL_BGRA, GL_UNSIGNED_BYTE, image.bits());
  state->PopReadFramebufferBinding();
  // Qt copies the pixels as they are: what VTK left in their alpha would let the desktop shine through the window.
  for (int y = 0; y < image.height(); ++y) {
    for (QRgb& pixel : std::span(reinterpret_cast<QRgb*>(image.scanLine(y)), static_cast<std::size_t>(image.width()))) {
      pixel |= 0xff000000U;
    }
  }
  image.mirror();  // OpenGL's rows begin at the bottom
  return image;
}

void VtkWidget::paintEvent(QPaintEvent* /*event*/) {
  Scene& s = *scene_;
  if (s.due && s.started) {
    if (QGuiApplication::mouseButtons() != Qt::NoButton || !isSeen()) {
      draw();  // in one turn with what a drag moves along
    } else {
      RedrawQueue::instance().add(this);
    }
  }
  QPainter painter(this);
  if (!s.image.isNull() && s.image.size() == pixels()) {
    painter.drawImage(rect(), s.image);
    return;
  }
  const double* colour = s.renderer->GetBackground();
  painter.fillRect(rect(),
                   QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2])));
  if (!s.image.isNull()) {
    // One drawn in haste has fewer pixels. One of a view of another size is not stretched: the middle stays in the middle.
    constexpr double kRounding = 2;
    QRectF place(QPointF(), s.image.deviceIndependentSize());
    place.moveCenter(QRectF(rect()).center());
    const bool fits = std::abs(place.width() - width()) < kRounding && std::abs(place.height() - height()) < kRounding;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(fits ? QRectF(rect()) : place, s.image);
  } else if (s.graphics.failed()) {
    painter.setPen(Qt::lightGray);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No 3D picture: OpenGL 3.2 does not work on this computer."));
  } else if (isSeen()) {
    RedrawQueue::instance().add(this);
  }
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
    case QEvent::ScreenChangeInternal:  // perhaps to one of another pixel ratio, which no resize tells of
      scene_->interactor->UpdateSize(pixels().width(), pixels().height());
      requestRender();
      break;
    default:
      break;
  }
  return QWidget::event(event);
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
  QWidget::keyPressEvent(event);
}

void VtkWidget::keyReleaseEvent(QKeyEvent* event) {
  scene_->interactor->KeyReleaseEvent();
  QWidget::keyReleaseEvent(event);
}

}  // namespace glisson
