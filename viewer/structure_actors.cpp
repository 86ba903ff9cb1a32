#include "viewer/structure_actors.h"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace glisson {

namespace {

constexpr double kResectedOpacity = 0.75;  ///< of the structure's own

void setColour(vtkActor* actor, Rgb colour) {
  actor->GetProperty()->SetColor(colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
}

}  // namespace

Rgb resectedColour(Rgb colour) {
  // A cold pale grey with a rest of the structure's colour: also told apart without colour vision, by lightness.
  const auto mix = [](std::uint8_t own, int grey) { return static_cast<std::uint8_t>((own + 3 * grey) / 4); };
  return {mix(colour.r, 150), mix(colour.g, 180), mix(colour.b, 205)};
}

StructureActors::StructureActors(vtkRenderer* renderer, std::shared_ptr<const DisplayMesh> mesh, bool split)
    : renderer_(renderer), mesh_(std::move(mesh)) {
  remnant_ = makeSide();
  if (split) {
    resected_ = makeSide();
  }
}

StructureActors::~StructureActors() {
  renderer_->RemoveActor(remnant_.actor);
  if (resected_) {
    renderer_->RemoveActor(resected_->actor);
  }
}

StructureActors::Side StructureActors::makeSide() {
  Side side;
  side.clip = vtkSmartPointer<vtkPlane>::New();
  side.full = vtkSmartPointer<vtkPolyDataMapper>::New();
  side.full->SetInputData(mesh_->full);
  side.full->ScalarVisibilityOff();
  side.coarse = vtkSmartPointer<vtkPolyDataMapper>::New();
  side.coarse->SetInputData(mesh_->coarsePoly);
  side.coarse->ScalarVisibilityOff();
  side.actor = vtkSmartPointer<vtkActor>::New();
  side.actor->SetMapper(side.full);
  side.actor->GetProperty()->SetInterpolationToPhong();
  side.actor->GetProperty()->SetAmbient(0.2);
  side.actor->GetProperty()->SetDiffuse(0.85);
  side.actor->GetProperty()->SetSpecular(0.15);
  side.actor->GetProperty()->SetSpecularPower(20);
  renderer_->AddActor(side.actor);
  return side;
}

void StructureActors::setLook(Rgb colour, double opacity, bool visible) {
  colour_ = colour;
  opacity_ = opacity;
  visible_ = visible;
  apply();
}

void StructureActors::setPlane(const std::optional<HalfSpace>& plane) {
  if (!resected_) {
    return;
  }
  if (plane) {
    // A VTK clipping plane keeps the side its normal points to.
    remnant_.clip->SetOrigin(plane->origin.data());
    remnant_.clip->SetNormal(-plane->normal.x(), -plane->normal.y(), -plane->normal.z());
    resected_->clip->SetOrigin(plane->origin.data());
    resected_->clip->SetNormal(plane->normal.x(), plane->normal.y(), plane->normal.z());
  }
  if (cut_ == plane.has_value()) {
    return;
  }
  cut_ = plane.has_value();
  for (Side* side : {&remnant_, &*resected_}) {
    for (vtkPolyDataMapper* mapper : {side->full.Get(), side->coarse.Get()}) {
      mapper->RemoveAllClippingPlanes();
      if (cut_) {
        mapper->AddClippingPlane(side->clip);
      }
    }
  }
  apply();
}

void StructureActors::setSimplified(bool simplified) {
  remnant_.actor->SetMapper(simplified ? remnant_.coarse : remnant_.full);
  if (resected_) {
    resected_->actor->SetMapper(simplified ? resected_->coarse : resected_->full);
  }
}

void StructureActors::apply() {
  setColour(remnant_.actor, colour_);
  remnant_.actor->GetProperty()->SetOpacity(opacity_);
  remnant_.actor->SetVisibility(visible_);
  if (resected_) {
    setColour(resected_->actor, resectedColour(colour_));
    resected_->actor->GetProperty()->SetOpacity(opacity_ < 1.0 ? kResectedOpacity * opacity_ : 1.0);
    resected_->actor->SetVisibility(visible_ && cut_);
  }
}

}  // namespace glisson
