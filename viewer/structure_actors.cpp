#include "viewer/structure_actors.h"

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

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
  for (std::size_t d = 0; d < kDetails; ++d) {
    const auto same = std::ranges::find(mesh_->polys, mesh_->polys[d]) - mesh_->polys.begin();
    if (static_cast<std::size_t>(same) < d) {
      side.mappers[d] = side.mappers[static_cast<std::size_t>(same)];
      continue;
    }
    side.mappers[d] = vtkSmartPointer<vtkPolyDataMapper>::New();
    side.mappers[d]->SetInputData(mesh_->polys[d]);
    side.mappers[d]->ScalarVisibilityOff();
  }
  side.actor = vtkSmartPointer<vtkActor>::New();
  side.actor->SetMapper(side.mappers.front());
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
    for (vtkPolyDataMapper* mapper : side->mappers) {
      mapper->RemoveAllClippingPlanes();  // also: one mapper may stand for several details
      if (cut_) {
        mapper->AddClippingPlane(side->clip);
      }
    }
  }
  apply();
}

void StructureActors::setDetail(Detail detail) {
  const auto index = static_cast<std::size_t>(detail);
  remnant_.actor->SetMapper(remnant_.mappers[index]);
  if (resected_) {
    resected_->actor->SetMapper(resected_->mappers[index]);
  }
  for (std::size_t d = 0; d < kDetails; ++d) {
    uploaded_[d] = uploaded_[d] || (visible_ && mesh_->polys[d] == mesh_->polys[index]);
  }
}

std::size_t StructureActors::triangles(Detail detail) const {
  const auto count = static_cast<std::size_t>(mesh_->poly(detail)->GetNumberOfPolys());
  return visible_ ? count * (cut_ ? 2U : 1U) : 0U;
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
