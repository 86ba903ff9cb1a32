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
    : renderer_(renderer), mesh_(std::move(mesh)), split_(split) {
  addPart();
}

StructureActors::~StructureActors() {
  for (const Part& part : parts_) {
    renderer_->RemoveActor(part.actor);
  }
}

void StructureActors::addPart() {
  Part part;
  for (std::size_t d = 0; d < kDetails; ++d) {
    const auto same = std::ranges::find(mesh_->polys, mesh_->polys[d]) - mesh_->polys.begin();
    if (static_cast<std::size_t>(same) < d) {
      part.mappers[d] = part.mappers[static_cast<std::size_t>(same)];
      continue;
    }
    part.mappers[d] = vtkSmartPointer<vtkPolyDataMapper>::New();
    part.mappers[d]->SetInputData(mesh_->polys[d]);
    part.mappers[d]->ScalarVisibilityOff();
  }
  part.actor = vtkSmartPointer<vtkActor>::New();
  part.actor->SetMapper(part.mappers[detail_]);
  part.actor->GetProperty()->SetInterpolationToPhong();
  part.actor->GetProperty()->SetAmbient(0.2);
  part.actor->GetProperty()->SetDiffuse(0.85);
  part.actor->GetProperty()->SetSpecular(0.15);
  part.actor->GetProperty()->SetSpecularPower(20);
  renderer_->AddActor(part.actor);
  parts_.push_back(std::move(part));
}

void StructureActors::setLook(Rgb colour, double opacity, bool visible) {
  colour_ = colour;
  opacity_ = opacity;
  visible_ = visible;
  apply();
}

void StructureActors::clip(Part& part, const PlanCell& cell) {
  if (part.clips.size() != cell.bounds.size()) {
    part.clips.resize(cell.bounds.size());
    for (vtkPolyDataMapper* mapper : part.mappers) {
      mapper->RemoveAllClippingPlanes();  // also: one mapper may stand for several details
      for (vtkSmartPointer<vtkPlane>& plane : part.clips) {
        plane = plane == nullptr ? vtkSmartPointer<vtkPlane>::New() : plane;
        mapper->AddClippingPlane(plane);
      }
    }
  }
  for (std::size_t n = 0; n < cell.bounds.size(); ++n) {
    // A VTK clipping plane keeps the side its normal points to.
    part.clips[n]->SetOrigin(cell.bounds[n].origin.data());
    part.clips[n]->SetNormal(cell.bounds[n].normal.data());
  }
}

void StructureActors::setPlan(const ResectionPlan& plan) {
  if (!split_) {
    return;
  }
  const std::vector<PlanCell> cells = cellsOf(plan);
  while (parts_.size() > cells.size()) {
    renderer_->RemoveActor(parts_.back().actor);
    parts_.pop_back();
  }
  if (parts_.size() < cells.size()) {
    uploaded_ = {};
  }
  while (parts_.size() < cells.size()) {
    addPart();
  }
  for (std::size_t n = 0; n < cells.size(); ++n) {
    parts_[n].side = cells[n].side;
    clip(parts_[n], cells[n]);
  }
  apply();
}

void StructureActors::setDetail(Detail detail) {
  detail_ = static_cast<std::size_t>(detail);
  for (const Part& part : parts_) {
    part.actor->SetMapper(part.mappers[detail_]);
  }
  for (std::size_t d = 0; d < kDetails; ++d) {
    uploaded_[d] = uploaded_[d] || (visible_ && mesh_->polys[d] == mesh_->polys[detail_]);
  }
}

std::size_t StructureActors::triangles(Detail detail) const {
  const auto count = static_cast<std::size_t>(mesh_->poly(detail)->GetNumberOfPolys());
  return visible_ ? count * parts_.size() : 0U;
}

void StructureActors::apply() {
  for (const Part& part : parts_) {
    const bool resected = part.side == PlanSide::Resected;
    setColour(part.actor, resected ? resectedColour(colour_) : colour_);
    part.actor->GetProperty()->SetOpacity(resected && opacity_ < 1.0 ? kResectedOpacity * opacity_ : opacity_);
    part.actor->SetVisibility(visible_);
  }
}

}  // namespace glisson
