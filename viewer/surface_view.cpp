#include "viewer/surface_view.h"

#include <vtkPlane.h>

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <algorithm>
#include <array>

#include "viewer/error_colours.h"
#include "viewer/orientation_cube.h"
#include "viewer/surface_actor.h"
#include "viewer/swipe_divider.h"
#include "viewer/vtk_scene.h"

namespace glisson {

namespace {

constexpr int kColours = 256;
constexpr double kCubeShare = 0.12;  ///< small: its letters must not be taken for those of what is compared

void fillColours(vtkLookupTable* table) {
  table->SetNumberOfTableValues(kColours);
  for (int n = 0; n < kColours; ++n) {
    const Rgb colour = errorColour(n / (kColours - 1.0));
    table->SetTableValue(n, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0, 1.0);
  }
  table->SetRange(0, 1);
}

}  // namespace

struct SurfaceView::Impl {
  explicit Impl(SurfaceView* owner) : view(owner), scene(owner->scene()), cube(scene.interactor, scene.renderer, kCubeShare) {}

  SurfaceView* view;
  Scene& scene;
  OrientationCube cube;
  std::array<ShownSurface, 2> shown;                      ///< left, right
  std::array<std::unique_ptr<SurfaceActor>, 2> surfaces;  ///< of them
  vtkNew<vtkLookupTable> colours;
  std::array<vtkNew<vtkPlane>, 2> clips;  ///< each keeps its side of the line
  SwipeDivider* divider = nullptr;        ///< a child of the view
  bool wireframe = false;
  Vec3 placedDirection = Vec3::UnitY();
  Vec3 placedUp = Vec3::UnitZ();

  [[nodiscard]] bool empty() const { return surfaces[0] == nullptr && surfaces[1] == nullptr; }
  void show(std::size_t side);
  void placeClips();
  void prepareFrame(FrameQuality quality);
};

void SurfaceView::Impl::show(std::size_t side) {
  const ShownSurface& wanted = shown[side];
  std::unique_ptr<SurfaceActor>& actor = surfaces[side];
  if (wanted.mesh == nullptr) {
    actor.reset();
    return;
  }
  if (actor == nullptr || actor->mesh() != wanted.mesh) {
    actor = std::make_unique<SurfaceActor>(scene.renderer, wanted.mesh);
    scene.budget.forget();
  }
  if (actor->errors() != wanted.errors) {
    actor->setErrors(wanted.errors, colours);
  }
  actor->setWireframe(wireframe);
}

/// The planes stand through the camera, so that they are seen as a line.
void SurfaceView::Impl::placeClips() {
  const ViewCamera camera = view->camera();
  const double x = divider->share() * camera.width;
  const Vec3 down = camera.rayAt({x, camera.height}).direction;
  const Vec3 up = camera.rayAt({x, 0}).direction;
  Vec3 toTheRight = down.cross(up).normalized();
  toTheRight *= toTheRight.dot(camera.right()) < 0 ? -1.0 : 1.0;
  for (std::size_t side = 0; side < clips.size(); ++side) {
    const Vec3 normal = side == 0 ? Vec3(-toTheRight) : toTheRight;
    clips[side]->SetOrigin(camera.position.data());
    clips[side]->SetNormal(normal.data());
  }
}

void SurfaceView::Impl::prepareFrame(FrameQuality quality) {
  TriangleCounts triangles;
  for (const auto& surface : surfaces) {
    triangles.reduced += surface ? surface->triangles(Detail::Reduced) : 0;
    triangles.full += surface ? surface->triangles(Detail::Full) : 0;
  }
  FramePlan frame = scene.budget.plan(quality, triangles, false);
  frame.detail = quality == FrameQuality::Moving ? Detail::Coarse : Detail::Full;
  for (const auto& surface : surfaces) {
    if (surface) {
      frame.uploads = frame.uploads || !surface->uploaded(frame.detail);
      surface->setDetail(frame.detail);
    }
  }
  scene.use(frame);
  if (view->swipes()) {
    placeClips();
  }
  scene.fitClippingRange();
}

SurfaceView::SurfaceView(QWidget* parent) : VtkWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName("surfaceView");
  setAccessibleName(tr("3D view"));
  Impl& d = *impl_;
  d.scene.renderer->SetBackground(0.11, 0.12, 0.14);
  fillColours(d.colours);
  d.divider = new SwipeDivider(this);
  connect(d.divider, &SwipeDivider::moved, this, [this] {
    impl_->scene.touch();
    requestRender();
  });
  d.scene.beforeFrame = [this](FrameQuality quality) { impl_->prepareFrame(quality); };
  lookFrom(d.placedDirection, d.placedUp);
}

SurfaceView::~SurfaceView() {
  makeCurrent();
  impl_->scene.beforeFrame = nullptr;
  impl_.reset();
  doneCurrent();
}

void SurfaceView::setSurfaces(const ShownSurface& left, const ShownSurface& right) {
  Impl& d = *impl_;
  if (d.shown == std::array{left, right}) {
    return;  // a frame takes its time
  }
  d.shown = {left, right};
  const bool first = d.empty();
  d.show(0);
  d.show(1);
  const bool both = swipes();
  for (std::size_t side = 0; side < d.surfaces.size(); ++side) {
    if (d.surfaces[side]) {
      d.surfaces[side]->setClip(both ? d.clips[side].Get() : nullptr);
    }
  }
  d.divider->setVisible(both);
  d.divider->place();
  if (first && !d.empty()) {
    lookFrom(Vec3::UnitY(), Vec3::UnitZ());
  }
  d.scene.touch();
  requestRender();
}

void SurfaceView::setScale(double mm) {
  if (impl_->colours->GetRange()[1] != mm) {
    impl_->colours->SetRange(0, mm);
    requestRender();
  }
}

void SurfaceView::setWireframe(bool wireframe) {
  impl_->wireframe = wireframe;
  for (const auto& surface : impl_->surfaces) {
    if (surface) {
      surface->setWireframe(wireframe);
    }
  }
  requestRender();
}

void SurfaceView::setDivider(double share) {
  impl_->divider->setShare(share);
  requestRender();
}

double SurfaceView::divider() const { return impl_->divider->share(); }

bool SurfaceView::swipes() const { return impl_->surfaces[0] != nullptr && impl_->surfaces[1] != nullptr; }

Pose SurfaceView::pose() const { return impl_->scene.pose(); }

ViewCamera SurfaceView::camera() const { return impl_->scene.camera(width(), height()); }

void SurfaceView::link(SurfaceView& one, SurfaceView& other) {
  connect(&one, &SurfaceView::cameraMoved, &other, [&one, &other] { other.follow(one); });
  connect(&other, &SurfaceView::cameraMoved, &one, [&one, &other] { one.follow(other); });
}

void SurfaceView::follow(const SurfaceView& other) {
  Impl& d = *impl_;
  if (other.pose() == pose()) {
    return;
  }
  d.scene.setPose(other.pose());
  d.scene.cameraByHand = other.impl_->scene.cameraByHand;
  d.placedDirection = other.impl_->placedDirection;
  d.placedUp = other.impl_->placedUp;
  d.scene.touch();
  requestRender();
}

void SurfaceView::lookFrom(const Vec3& direction, const Vec3& up) {
  Impl& d = *impl_;
  d.placedDirection = direction;
  d.placedUp = up;
  Eigen::AlignedBox3d box;
  for (const auto& surface : d.surfaces) {
    if (surface) {
      const Bounds bounds = boundsOf(surface->mesh()->source->mesh);
      box.extend(bounds.low);
      box.extend(bounds.high);
    }
  }
  if (box.isEmpty()) {
    box = Eigen::AlignedBox3d(Vec3(-100, -100, -100), Vec3(100, 100, 100));
  }
  d.scene.lookAt(box, direction, up, static_cast<double>(width()) / std::max(1, height()));
  requestRender();
}

void SurfaceView::resizeEvent(QResizeEvent* event) {
  VtkWidget::resizeEvent(event);
  if (!impl_->scene.cameraByHand) {
    lookFrom(impl_->placedDirection, impl_->placedUp);
  }
  impl_->divider->place();
}

void SurfaceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_1:
      return lookFrom(Vec3::UnitY(), Vec3::UnitZ());
    case Qt::Key_3:
      return lookFrom(-Vec3::UnitX(), Vec3::UnitZ());
    case Qt::Key_7:
      return lookFrom(-Vec3::UnitZ(), -Vec3::UnitY());
    default:
      VtkWidget::keyPressEvent(event);
  }
}

void SurfaceView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    setAccessibleName(tr("3D view"));
  }
  VtkWidget::changeEvent(event);
}

}  // namespace glisson
