#include "viewer/vtk_scene.h"

#include <vtkCamera.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson {

namespace {

constexpr int kPicturePeels = 32;
constexpr double kFilled = 0.86;  ///< share of the view the model fills

Vec3 toVec3(const double* values) { return {values[0], values[1], values[2]}; }

void growBy(Eigen::AlignedBox3d& box, vtkRenderer* renderer) {
  std::array<double, 6> bounds{};
  renderer->ComputeVisiblePropBounds(bounds.data());
  if (bounds[0] <= bounds[1]) {
    box.extend(Vec3(bounds[0], bounds[2], bounds[4]));
    box.extend(Vec3(bounds[1], bounds[3], bounds[5]));
  }
}

}  // namespace

void VtkWidget::Scene::touch() {
  moving = true;
  rest.start(kRestMs);
}

void VtkWidget::Scene::use(const FramePlan& plan) {
  frame = plan;
  renderer->SetUseDepthPeeling(frame.peels);
  renderer->SetMaximumNumberOfPeels(frame.quality == FrameQuality::Picture ? kPicturePeels : FrameBudget::kRestingPeels);
  renderer->SetOcclusionRatio(0.0);
  renderer->SetUseFXAA(frame.smoothEdges);
}

void VtkWidget::Scene::holdNewProps() {
  if (frame.quality == FrameQuality::Picture) {
    return;
  }
  const FirstFrames::Held held = first.hold(std::array<vtkRenderer*, 2>{renderer, overlay}, frame.peels);
  frame.uploads = frame.uploads || held.anyNew;
  frame.moreToUpload = frame.moreToUpload || held.more;
}

Pose VtkWidget::Scene::pose() const {
  vtkCamera* vtk = renderer->GetActiveCamera();
  return {toVec3(vtk->GetPosition()), toVec3(vtk->GetFocalPoint()), toVec3(vtk->GetViewUp())};
}

void VtkWidget::Scene::setPose(const Pose& pose) {
  vtkCamera* vtk = renderer->GetActiveCamera();
  vtk->SetPosition(pose.position.data());
  vtk->SetFocalPoint(pose.focus.data());
  vtk->SetViewUp(pose.up.data());
  cameraByHand = true;
  told = pose;
}

ViewCamera VtkWidget::Scene::camera(int width, int height) const {
  vtkCamera* vtk = renderer->GetActiveCamera();
  ViewCamera camera;
  camera.position = toVec3(vtk->GetPosition());
  camera.forward = toVec3(vtk->GetDirectionOfProjection()).normalized();
  const Vec3 up = toVec3(vtk->GetViewUp());
  camera.up = (up - up.dot(camera.forward) * camera.forward).normalized();
  camera.viewAngle = vtk->GetViewAngle() * kDegree;
  camera.width = std::max(1, width);
  camera.height = std::max(1, height);
  return camera;
}

void VtkWidget::Scene::lookAt(const Eigen::AlignedBox3d& box, const Vec3& direction, const Vec3& up, double aspect) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const double tangentUp = kFilled * std::tan(0.5 * camera->GetViewAngle() * kDegree);
  const double tangentRight = tangentUp * aspect;
  const Vec3 right = direction.cross(up);
  double distance = 1;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - box.center();
    const double needed = std::max(std::abs(at.dot(up)) / tangentUp, std::abs(at.dot(right)) / tangentRight);
    distance = std::max(distance, needed - at.dot(direction));
  }
  const Vec3 centre = box.center();
  const Vec3 position = centre - distance * direction;
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  cameraByHand = false;
}

void VtkWidget::Scene::fitClippingRange() {
  Eigen::AlignedBox3d box;
  growBy(box, renderer);
  growBy(box, overlay);
  if (!box.isEmpty()) {
    const std::array<double, 6> bounds{box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z()};
    renderer->ResetCameraClippingRange(bounds.data());
  }
}

}  // namespace glisson
