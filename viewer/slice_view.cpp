#include "viewer/slice_view.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "viewer/compared_outlines.h"
#include "viewer/mesh_slices.h"
#include "viewer/slice_outlines.h"
#include "viewer/slice_painter.h"

namespace glisson {

namespace {

constexpr double kMinZoom = 0.2;
constexpr double kMaxZoom = 40.0;
constexpr int kSliceMargin = 4;  ///< pixels between the picture and the widget's border
constexpr double kOutlineWidth = 1.4;
const QColor kSurfaceEdge(15, 16, 18);

QColor toColour(const Rgb& colour) { return {colour.r, colour.g, colour.b}; }

/// The axes whose slices are seen as the vertical and the horizontal line of the crosshair.
std::pair<SliceAxis, SliceAxis> otherAxes(SliceAxis axis) {
  switch (axis) {
    case SliceAxis::Axial:
      return {SliceAxis::Sagittal, SliceAxis::Coronal};
    case SliceAxis::Coronal:
      return {SliceAxis::Sagittal, SliceAxis::Axial};
    case SliceAxis::Sagittal:
      break;
  }
  return {SliceAxis::Coronal, SliceAxis::Axial};
}

void drawSegments(QPainter& painter, const QTransform& transform, const std::vector<std::pair<SlicePoint, SlicePoint>>& segments) {
  QVector<QLineF> lines;
  for (const auto& [a, b] : segments) {
    lines.append(QLineF(transform.map(QPointF(a.x(), a.y())), transform.map(QPointF(b.x(), b.y()))));
  }
  painter.drawLines(lines);
}

}  // namespace

struct SliceView::Impl {
  SliceView* view = nullptr;
  SliceAxis axis = SliceAxis::Axial;
  std::shared_ptr<const CtVolume> ct;
  std::shared_ptr<const Segmentation> segmentation;
  std::shared_ptr<const LiverVoxels> liver;
  std::shared_ptr<const LiverModel> model;
  QString noCt;
  std::optional<ResectionPlane> plane;
  std::vector<ResectionPlane> otherPlanes;
  std::optional<SliceGeometry> geometry;
  Vec3 crosshair = Vec3::Zero();
  int slice = 0;
  WindowLevel windowLevel;
  double zoom = 1;
  QPointF pan;  ///< logical pixels
  int wheelRest = 0;

  Qt::MouseButton button = Qt::NoButton;
  bool levelling = false;
  QPointF last;
  bool compared = false;             ///< surfaces' outlines are
  std::vector<MeshSlices> surfaces;  ///< of the visible structures, as far as they are made ready
  QPixmap cache;                     ///< everything but crosshair, plane and texts; null: draw again
  bool stale = false;                ///< it is of an earlier model: drawn again once all surfaces are ready

  [[nodiscard]] QTransform toWidget() const;
  [[nodiscard]] SlicePoint toSlice(const QPointF& pixel) const;
  void drawVoxels(QPainter& painter) const;
  void drawOutlines(QPainter& painter, const QTransform& transform) const;
  void drawSurfaces(QPainter& painter, const QTransform& transform) const;
  void drawLegend(QPainter& painter) const;
  /// Null where it is not ready yet.
  [[nodiscard]] const MeshSlices* surfaceOf(const Structure& structure) const;
  /// Makes a few more surfaces ready, so that the window answers in between; false where all are.
  bool readySome();
  /// Returns where the texts are.
  [[nodiscard]] std::vector<QRectF> drawTexts(QPainter& painter) const;
  void redraw() {
    cache = QPixmap();
    view->update();
  }
};

/// Slice points to logical pixels: mm per pixel is the same both ways, so spacing gives the right aspect.
QTransform SliceView::Impl::toWidget() const {
  const double widthMm = geometry->columns() * geometry->columnSpacing();
  const double heightMm = geometry->rows() * geometry->rowSpacing();
  const double fit = std::min((view->width() - 2 * kSliceMargin) / widthMm, (view->height() - 2 * kSliceMargin) / heightMm);
  const double scale = zoom * std::max(fit, 1e-3);
  QTransform transform;
  transform.translate(0.5 * view->width() + pan.x(), 0.5 * view->height() + pan.y());
  transform.scale(scale * geometry->columnSpacing(), scale * geometry->rowSpacing());
  transform.translate(-0.5 * (geometry->columns() - 1), -0.5 * (geometry->rows() - 1));
  return transform;
}

SlicePoint SliceView::Impl::toSlice(const QPointF& pixel) const {
  const QPointF at = toWidget().inverted().map(pixel);
  return {at.x(), at.y()};
}

void SliceView::Impl::drawVoxels(QPainter& painter) const {
  const QTransform transform = toWidget();
  if (ct) {
    const QImage image = sliceImage(*ct, *geometry, slice, windowLevel.width, windowLevel.level);
    painter.save();
    painter.setTransform(transform, true);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(-0.5, -0.5, geometry->columns(), geometry->rows()), image);
    painter.restore();
  }
  drawOutlines(painter, transform);
  drawSurfaces(painter, transform);
}

const MeshSlices* SliceView::Impl::surfaceOf(const Structure& structure) const {
  const auto found =
      std::ranges::find_if(surfaces, [&](const MeshSlices& s) { return s.source() == structure.reconstruction.get(); });
  return found == surfaces.end() ? nullptr : &*found;
}

bool SliceView::Impl::readySome() {
  constexpr qint64 kMostMs = 6;
  QElapsedTimer clock;
  clock.start();
  bool any = false;
  if (!model || !geometry) {
    return any;
  }
  for (const Structure& structure : model->structures) {
    if (structure.visible && structure.reconstruction && surfaceOf(structure) == nullptr && (!any || clock.elapsed() < kMostMs)) {
      surfaces.emplace_back(structure.reconstruction, *geometry);
      any = true;
    }
  }
  return any;
}

void SliceView::Impl::drawSurfaces(QPainter& painter, const QTransform& transform) const {
  if (!model) {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  std::size_t number = 0;
  for (const Structure& structure : model->structures) {
    const MeshSlices* surface = surfaceOf(structure);
    number += structure.reconstruction ? 1 : 0;
    if (!structure.visible || surface == nullptr) {
      continue;
    }
    const auto segments = surface->outline(slice);
    const QColor colour = toColour(structure.colour);
    if (compared) {
      drawComparedOutline(painter, transform, segments, number - 1, colour, QString::fromStdString(structure.id));
      continue;
    }
    // a paler tone would be nearer to that of another structure; a dark edge tells it from the label's outline
    painter.setPen(QPen(kSurfaceEdge, 2.6));
    drawSegments(painter, transform, segments);
    painter.setPen(QPen(colour, 1.0));
    drawSegments(painter, transform, segments);
  }
}

void SliceView::Impl::drawLegend(QPainter& painter) const {
  std::vector<OutlineLegendRow> rows;
  std::size_t number = 0;
  for (const Structure& structure : model->structures) {
    const QColor colour = toColour(structure.colour);
    if (structure.reconstruction) {
      rows.push_back({comparedPen(number++, colour), QString::fromStdString(structure.id), true});
    } else if (structure.visible && structure.sourceIndex >= 0) {
      rows.push_back({QPen(colour, kOutlineWidth), SliceView::tr("voxels")});
    }
  }
  drawOutlineLegend(painter, view->size(), rows);
}

void SliceView::Impl::drawOutlines(QPainter& painter, const QTransform& transform) const {
  if (!segmentation || !model) {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Structure& structure : model->structures) {
    const auto source = static_cast<std::size_t>(structure.sourceIndex);
    if (!structure.visible || structure.sourceIndex < 0 || source >= segmentation->structures.size() ||
        !segmentation->structures[source].mask) {
      continue;
    }
    const bool counted = structure.kind == StructureKind::Liver && liver != nullptr;
    const Mask& mask = counted ? liver->liver : *segmentation->structures[source].mask;
    const ImageGeometry& grid = counted ? liver->geometry : segmentation->geometry;
    painter.setPen(QPen(toColour(structure.colour), kOutlineWidth));
    drawSegments(painter, transform, outlineOf(mask, grid, *geometry, slice));
  }
}

std::vector<QRectF> SliceView::Impl::drawTexts(QPainter& painter) const {
  const QRectF box = QRectF(view->rect()).adjusted(8, 8, -8, -8);
  const Vec3 centre = geometry->toWorld({0.5 * (geometry->columns() - 1), 0.5 * (geometry->rows() - 1)}, slice);
  QString name;
  QString position;
  switch (axis) {
    case SliceAxis::Axial:
      name = SliceView::tr("Axial");
      position = (centre.z() >= 0 ? "S " : "I ") + QLocale().toString(std::abs(centre.z()), 'f', 1);
      break;
    case SliceAxis::Coronal:
      name = SliceView::tr("Coronal");
      position = (centre.y() >= 0 ? "P " : "A ") + QLocale().toString(std::abs(centre.y()), 'f', 1);
      break;
    case SliceAxis::Sagittal:
      name = SliceView::tr("Sagittal");
      position = (centre.x() >= 0 ? "L " : "R ") + QLocale().toString(std::abs(centre.x()), 'f', 1);
      break;
  }
  std::vector<QRectF> taken;
  taken.push_back(drawEdgedText(painter, box, Qt::AlignLeft | Qt::AlignTop, name));
  const int number = geometry->sliceFlipped ? geometry->slices() - slice : slice + 1;
  taken.push_back(drawEdgedText(painter, box, Qt::AlignLeft | Qt::AlignBottom,
                                SliceView::tr("%1 mm\nslice %2 of %3").arg(position).arg(number).arg(geometry->slices())));
  if (!ct && !noCt.isEmpty()) {
    const QRectF below = box.adjusted(0, taken.front().height() + kSliceMargin, 0, 0);
    taken.push_back(drawEdgedText(painter, below, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap | Qt::TextWrapAnywhere, noCt));
  }
  if (ct) {
    taken.push_back(drawEdgedText(painter, box, Qt::AlignRight | Qt::AlignBottom,
                                  SliceView::tr("W %1\nL %2").arg(qRound(windowLevel.width)).arg(qRound(windowLevel.level))));
  }
  return taken;
}

SliceView::SliceView(SliceAxis axis, QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>()) {
  impl_->view = this;
  impl_->axis = axis;
  setObjectName(axis == SliceAxis::Axial ? "axialView" : (axis == SliceAxis::Coronal ? "coronalView" : "sagittalView"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 90);
  setAttribute(Qt::WA_OpaquePaintEvent);
  retranslate();
}

SliceView::~SliceView() = default;

void SliceView::retranslate() {
  setAccessibleName(impl_->axis == SliceAxis::Axial     ? tr("Axial slices")
                    : impl_->axis == SliceAxis::Coronal ? tr("Coronal slices")
                                                        : tr("Sagittal slices"));
}

void SliceView::setVolumes(std::shared_ptr<const CtVolume> ct, std::shared_ptr<const Segmentation> segmentation,
                           std::shared_ptr<const LiverVoxels> liver) {
  Impl& d = *impl_;
  d.ct = std::move(ct);
  d.segmentation = std::move(segmentation);
  d.liver = std::move(liver);
  d.geometry.reset();
  d.surfaces.clear();
  if (d.ct || d.segmentation) {
    d.geometry = SliceGeometry(d.ct ? d.ct->geometry : d.segmentation->geometry, d.axis);
    const Index3& size = d.geometry->grid.size;
    setCrosshair(d.geometry->grid.toWorld(Vec3(0.5 * size[0] - 0.5, 0.5 * size[1] - 0.5, 0.5 * size[2] - 0.5)));
  }
  d.zoom = 1;
  d.pan = {};
  d.redraw();
}

void SliceView::setNoCt(const QString& reason) {
  impl_->noCt = reason;
  update();
}

void SliceView::setModel(std::shared_ptr<const LiverModel> model) {
  const bool redraw = !looksTheSame(impl_->model.get(), model.get());
  impl_->model = std::move(model);
  std::erase_if(impl_->surfaces, [this](const MeshSlices& surface) {
    return !impl_->model || std::ranges::none_of(impl_->model->structures, [&](const Structure& structure) {
      return structure.reconstruction.get() == surface.source();
    });
  });
  if (redraw) {
    impl_->stale = true;
    update();
  }
}

void SliceView::setSurfacesCompared(bool compared) {
  impl_->compared = compared;
  impl_->redraw();
}

void SliceView::setPlane(std::optional<ResectionPlane> plane, std::vector<ResectionPlane> others) {
  impl_->plane = std::move(plane);
  impl_->otherPlanes = std::move(others);
  update();
}

void SliceView::setCrosshair(const Vec3& worldMm) {
  Impl& d = *impl_;
  d.crosshair = worldMm;
  if (d.geometry) {
    const int slice = d.geometry->sliceOf(worldMm);
    if (slice != d.slice) {
      d.slice = slice;
      d.cache = QPixmap();
    }
  }
  update();
}

void SliceView::setWindowLevel(const WindowLevel& windowLevel) {
  if (!(windowLevel == impl_->windowLevel)) {
    impl_->windowLevel = windowLevel;
    impl_->redraw();
  }
}

Vec3 SliceView::crosshair() const { return impl_->crosshair; }

int SliceView::slice() const { return impl_->slice; }

std::optional<QPointF> SliceView::pixelOf(const Vec3& worldMm) const {
  if (!impl_->geometry) {
    return std::nullopt;
  }
  const SlicePoint at = impl_->geometry->toSlice(worldMm);
  return impl_->toWidget().map(QPointF(at.x(), at.y()));
}

void SliceView::paintEvent(QPaintEvent* /*event*/) {
  Impl& d = *impl_;
  QPainter painter(this);
  if (!d.geometry) {
    painter.fillRect(rect(), Qt::black);
  } else {
    const double ratio = devicePixelRatioF();
    const QSize pixels(qRound(width() * ratio), qRound(height() * ratio));
    if (d.readySome()) {
      d.stale = true;
      update();  // the next ones in a turn of their own
    } else if (d.stale) {
      d.cache = QPixmap();
    }
    if (d.cache.size() != pixels) {
      d.stale = false;
      d.cache = QPixmap(pixels);
      d.cache.setDevicePixelRatio(ratio);
      d.cache.fill(Qt::black);
      QPainter cached(&d.cache);
      d.drawVoxels(cached);
    }
    painter.drawPixmap(0, 0, d.cache);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto [vertical, horizontal] = otherAxes(d.axis);
    drawCrosshair(painter, *pixelOf(d.crosshair), size(), vertical, horizontal);
    for (const ResectionPlane& other : d.otherPlanes) {
      drawPlaneLine(painter, *d.geometry, d.slice, other, d.toWidget(), false);
    }
    if (d.plane) {
      drawPlaneLine(painter, *d.geometry, d.slice, *d.plane, d.toWidget());
    }
    drawLetters(painter, *d.geometry, size(), d.drawTexts(painter));
    if (d.compared && d.model) {
      d.drawLegend(painter);
    }
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRect(0, 0, width(), 3), viewColour(d.axis));
  if (hasFocus()) {
    painter.setPen(QPen(viewColour(d.axis), 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void SliceView::placeCrosshair(const QPointF& pixel) {
  Impl& d = *impl_;
  if (!d.geometry) {
    return;
  }
  SlicePoint at = d.toSlice(pixel);
  at = at.cwiseMax(SlicePoint(-0.5, -0.5)).cwiseMin(SlicePoint(d.geometry->columns() - 0.5, d.geometry->rows() - 0.5));
  d.crosshair = d.geometry->toWorld(at, d.slice);
  update();
  emit crosshairMoved(d.crosshair);
}

void SliceView::stepSlices(int steps) {
  Impl& d = *impl_;
  if (!d.geometry || steps == 0) {
    return;
  }
  const int wanted = d.slice + (d.geometry->sliceFlipped ? -steps : steps);
  const int slice = std::clamp(wanted, 0, d.geometry->slices() - 1);
  if (slice == d.slice) {
    return;
  }
  const Vec3 world = d.geometry->toWorld(d.geometry->toSlice(d.crosshair), slice);
  setCrosshair(world);
  emit crosshairMoved(world);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  // Touch pads send parts of a notch: a slice is stepped when they add up to one.
  impl_->wheelRest += event->angleDelta().y();
  const int notches = impl_->wheelRest / 120;
  impl_->wheelRest -= notches * 120;
  stepSlices(notches);
  event->accept();
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  d.button = event->button();
  d.levelling = event->button() == Qt::RightButton && event->modifiers().testFlag(Qt::ControlModifier);
  d.last = event->position();
  if (event->button() == Qt::LeftButton) {
    placeCrosshair(event->position());
  }
  event->accept();
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  const QPointF moved = event->position() - d.last;
  d.last = event->position();
  if (event->buttons().testFlag(Qt::LeftButton)) {
    placeCrosshair(event->position());
  } else if (event->buttons().testFlag(Qt::RightButton) && d.levelling) {
    const WindowLevel changed{std::clamp(d.windowLevel.width + 2 * moved.x(), 1.0, 8000.0),
                              std::clamp(d.windowLevel.level + moved.y(), -2000.0, 4000.0)};
    setWindowLevel(changed);
    emit windowLevelChanged(changed);
  } else if (event->buttons().testFlag(Qt::RightButton)) {
    const double zoom = std::clamp(d.zoom * std::exp(-0.01 * moved.y()), kMinZoom, kMaxZoom);
    d.pan *= zoom / d.zoom;  // the middle of the view stays where it is
    d.zoom = zoom;
    d.redraw();
  } else if (event->buttons().testFlag(Qt::MiddleButton)) {
    d.pan += moved;
    d.redraw();
  }
  event->accept();
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    emit maximiseRequested();
  }
  event->accept();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (event->modifiers().testFlag(Qt::ControlModifier) || event->modifiers().testFlag(Qt::AltModifier)) {
    QWidget::keyPressEvent(event);
    return;
  }
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
      return stepSlices(1);
    case Qt::Key_Down:
    case Qt::Key_Left:
      return stepSlices(-1);
    case Qt::Key_PageUp:
      return stepSlices(10);
    case Qt::Key_PageDown:
      return stepSlices(-10);
    case Qt::Key_R:
      impl_->zoom = 1;
      impl_->pan = {};
      return impl_->redraw();
    default:
      QWidget::keyPressEvent(event);
  }
}

void SliceView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && impl_) {
    retranslate();
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace glisson
