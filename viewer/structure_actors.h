#pragma once
// Purpose: one structure in the 3D view. The parenchyma is drawn as several actors that share its mesh, cut by the GPU into the
// plan's convex parts: the remnant in the structure's colour, what is resected pale and thinner. Where a plane is bent the parts
// are not convex: one actor then has the height above the plan's surface at each vertex, and the colours meet where it is 0. Frame:
// mm LPS.

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

#include "planning/resection/plan_cells.h"
#include "viewer/mesh_polydata.h"

class vtkActor;
class vtkLookupTable;
class vtkPlane;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace glisson {

/// The colour of the parenchyma's resected side for a structure of this colour.
Rgb resectedColour(Rgb colour);

class StructureActors {
 public:
  /// The mesh is uploaded with the next frame. `split`: the plan cuts this structure (the parenchyma).
  StructureActors(vtkRenderer* renderer, std::shared_ptr<const DisplayMesh> mesh, bool split);
  ~StructureActors();
  StructureActors(const StructureActors&) = delete;
  StructureActors& operator=(const StructureActors&) = delete;

  /// A closed surface is drawn on the side that is seen alone, so its near wall is a little denser than `opacity`, as the far one
  /// would make it: 0.35 is drawn as 0.48.
  void setLook(Rgb colour, double opacity, bool visible);
  void setPlan(const ResectionPlan& plan);
  /// What the next frame draws, to be called before each one; it uploads what was not drawn before.
  void setDetail(Detail detail);
  [[nodiscard]] bool uploaded(Detail detail) const { return uploaded_[static_cast<std::size_t>(detail)]; }
  /// Triangles drawn at this detail: 0 where hidden, the mesh's once for every part.
  [[nodiscard]] std::size_t triangles(Detail detail) const;

  [[nodiscard]] const Reconstruction* source() const { return mesh_->source.get(); }
  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_->source->mesh; }
  [[nodiscard]] const SurfaceMesh& coarseMesh() const { return mesh_->coarse; }
  [[nodiscard]] bool translucent() const { return visible_ && opacity_ < 1.0; }
  [[nodiscard]] bool visible() const { return visible_; }

 private:
  /// What lies in one part of the plan.
  struct Part {
    PlanSide side = PlanSide::Remnant;
    vtkSmartPointer<vtkActor> actor;
    std::array<vtkSmartPointer<vtkPolyDataMapper>, kDetails> mappers;  ///< one for each different mesh
    std::vector<vtkSmartPointer<vtkPlane>> clips;
  };
  void addPart();
  /// Of the near wall alone where the far one is not drawn.
  [[nodiscard]] double drawnOpacity() const;
  /// As many clipping planes as `cell` has bounds, standing there.
  static void clip(Part& part, const PlanCell& cell);
  void apply();
  /// Heights above the plan's surface at the vertices of the mesh that the next frame draws, where they are out of date.
  void raise();

  vtkRenderer* renderer_;
  std::shared_ptr<const DisplayMesh> mesh_;
  bool split_;
  bool closed_;  ///< nothing is seen of its inside: only what faces the eye is drawn
  std::vector<Part> parts_;
  ResectionPlan bent_;  ///< without resections: no plane is bent
  vtkSmartPointer<vtkLookupTable> sides_;
  std::array<bool, kDetails> raised_{};  ///< by detail
  std::size_t detail_ = 0;
  Rgb colour_;
  double opacity_ = 1;
  bool visible_ = true;
  std::array<bool, kDetails> uploaded_{};
};

}  // namespace glisson
