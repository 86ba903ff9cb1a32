#include "viewer/structure_actors.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glisson {

namespace {

constexpr double kResectedOpacity = 0.75;  ///< of the structure's own
constexpr double kBlendMm = 0.5;           ///< on each side of a bent surface, at most

/// Nothing is seen of its inside, from outside: half of the pixels need not be shaded. Where a plane cuts it the section lies
/// before.
bool enclosesVolume(const MeshDefects& defects) {
  return !defects.noTriangles && defects.openEdges == 0 && defects.orientationEdges == 0 && !defects.inward;
}

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
    : renderer_(renderer), mesh_(std::move(mesh)), split_(split), closed_(enclosesVolume(mesh_->source->defects)) {
  sides_ = vtkSmartPointer<vtkLookupTable>::New();
  sides_->SetNumberOfTableValues(2);
  sides_->SetRange(-kBlendMm, kBlendMm);
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
  part.actor->GetProperty()->SetBackfaceCulling(closed_);
  renderer_->AddActor(part.actor);
  parts_.push_back(std::move(part));
}

void StructureActors::setLook(Rgb colour, double opacity, bool visible) {
  colour_ = colour;
  opacity_ = opacity;
  visible_ = visible;
  apply();
}

double StructureActors::drawnOpacity() const {
  // What lies between the two walls is seen through the near one: it takes half of the far one's density.
  constexpr double kWalls = 1.5;
  return closed_ ? 1 - std::pow(1 - opacity_, kWalls) : opacity_;
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
  const bool bent = hasBends(plan);
  if (bent != !bent_.resections.empty()) {
    while (!parts_.empty()) {  // their mappers draw in another way
      renderer_->RemoveActor(parts_.back().actor);
      parts_.pop_back();
    }
  }
  bent_ = bent ? plan : ResectionPlan();
  raised_ = {};
  const std::vector<PlanCell> cells = bent ? std::vector<PlanCell>(1) : cellsOf(plan);
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

namespace {
/// Positive on the resected side, zero on the plan's surface: the highest of the resections, each as high as its lowest plane.
class PlanHeight {
 public:
  explicit PlanHeight(const ResectionPlan& plan) {
    for (const Resection& resection : plan.resections) {
      std::vector<Surface>& planes = resections_.emplace_back();
      for (const ResectionPlane& plane : resection.planes) {
        planes.push_back({plane, plane.bend ? std::optional(BentSurface(plane)) : std::nullopt});
      }
    }
  }
  [[nodiscard]] double at(const Vec3& p) const {
    double highest = -kFarMm;
    for (const std::vector<Surface>& planes : resections_) {
      double lowest = planes.empty() ? -kFarMm : kFarMm;
      for (const Surface& plane : planes) {
        lowest = std::min(lowest, plane.bent ? plane.bent->above(p) : plane.flat.normal.dot(p - plane.flat.origin));
      }
      highest = std::max(highest, lowest);
    }
    return highest;
  }

 private:
  static constexpr double kFarMm = 1e6;
  struct Surface {
    HalfSpace flat;
    std::optional<BentSurface> bent;
  };
  std::vector<std::vector<Surface>> resections_;
};
}  // namespace

void StructureActors::raise() {
  if (bent_.resections.empty() || raised_[detail_]) {
    return;
  }
  const PlanHeight height(bent_);
  vtkPolyData* mesh = mesh_->polys[detail_];
  vtkNew<vtkFloatArray> heights;
  heights->SetName("height");
  heights->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType n = 0; n < mesh->GetNumberOfPoints(); ++n) {
    Vec3 at;
    mesh->GetPoint(n, at.data());
    heights->SetValue(n, static_cast<float>(height.at(at)));
  }
  // The mesh is shared with other views: only the heights are this one's.
  vtkNew<vtkPolyData> raised;
  raised->ShallowCopy(mesh);
  raised->GetPointData()->SetScalars(heights);
  vtkPolyDataMapper* mapper = parts_.front().mappers[detail_];
  mapper->SetInputData(raised);
  mapper->SetLookupTable(sides_);
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUsePointData();
  mapper->SetInterpolateScalarsBeforeMapping(true);
  mapper->UseLookupTableScalarRangeOn();
  for (std::size_t d = 0; d < kDetails; ++d) {
    raised_[d] = raised_[d] || mesh_->polys[d] == mesh_->polys[detail_];
  }
}

void StructureActors::setDetail(Detail detail) {
  detail_ = static_cast<std::size_t>(detail);
  for (const Part& part : parts_) {
    part.actor->SetMapper(part.mappers[detail_]);
  }
  for (std::size_t d = 0; d < kDetails; ++d) {
    uploaded_[d] = uploaded_[d] || (visible_ && mesh_->polys[d] == mesh_->polys[detail_]);
  }
  raise();
}

std::size_t StructureActors::triangles(Detail detail) const {
  const auto count = static_cast<std::size_t>(mesh_->poly(detail)->GetNumberOfPolys());
  return visible_ ? count * parts_.size() : 0U;
}

void StructureActors::apply() {
  if (!bent_.resections.empty()) {
    // Two colours that meet at 0: the table's range is so narrow that its blend is not seen.
    const Rgb pale = resectedColour(colour_);
    const double paleOpacity = opacity_ < 1.0 ? kResectedOpacity : 1.0;
    sides_->SetTableValue(0, colour_.r / 255.0, colour_.g / 255.0, colour_.b / 255.0, 1);
    sides_->SetTableValue(1, pale.r / 255.0, pale.g / 255.0, pale.b / 255.0, paleOpacity);
    sides_->Modified();
    parts_.front().actor->GetProperty()->SetOpacity(drawnOpacity());
    parts_.front().actor->SetVisibility(visible_);
    return;
  }
  for (const Part& part : parts_) {
    const bool resected = part.side == PlanSide::Resected;
    setColour(part.actor, resected ? resectedColour(colour_) : colour_);
    part.actor->GetProperty()->SetOpacity(resected && opacity_ < 1.0 ? kResectedOpacity * drawnOpacity() : drawnOpacity());
    part.actor->SetVisibility(visible_);
  }
}

}  // namespace glisson
