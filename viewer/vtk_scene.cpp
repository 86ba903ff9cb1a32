#include "viewer/vtk_scene.h"

namespace glisson {

namespace {

constexpr int kPicturePeels = 32;

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

}  // namespace glisson
