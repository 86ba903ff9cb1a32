#pragma once
// Purpose: one structure in the 3D view. The parenchyma is drawn as two actors that share its mesh, cut by the GPU at the plane:
// the remnant in the structure's colour, the resected side pale and thinner. Frame: mm LPS.

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>

#include "reconstruction/mesh/cut.h"
#include "viewer/mesh_polydata.h"

class vtkActor;
class vtkPlane;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace glisson {

/// The colour of the parenchyma's resected side for a structure of this colour.
Rgb resectedColour(Rgb colour);

class StructureActors {
 public:
  /// The mesh is uploaded with the next frame. `split`: the plane cuts this structure (the parenchyma).
  StructureActors(vtkRenderer* renderer, std::shared_ptr<const DisplayMesh> mesh, bool split);
  ~StructureActors();
  StructureActors(const StructureActors&) = delete;
  StructureActors& operator=(const StructureActors&) = delete;

  void setLook(Rgb colour, double opacity, bool visible);
  void setPlane(const std::optional<HalfSpace>& plane);
  /// What the next frame draws; it uploads what was not drawn before.
  void setDetail(Detail detail);
  [[nodiscard]] bool uploaded(Detail detail) const { return uploaded_[static_cast<std::size_t>(detail)]; }
  /// Triangles drawn at this detail: 0 where hidden, twice the mesh's where both sides of a plane are.
  [[nodiscard]] std::size_t triangles(Detail detail) const;

  [[nodiscard]] const Reconstruction* source() const { return mesh_->source.get(); }
  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_->source->mesh; }
  [[nodiscard]] const SurfaceMesh& coarseMesh() const { return mesh_->coarse; }
  [[nodiscard]] bool translucent() const { return visible_ && opacity_ < 1.0; }
  [[nodiscard]] bool visible() const { return visible_; }

 private:
  /// The structure on one side of the plane.
  struct Side {
    vtkSmartPointer<vtkActor> actor;
    std::array<vtkSmartPointer<vtkPolyDataMapper>, kDetails> mappers;  ///< one for each different mesh
    vtkSmartPointer<vtkPlane> clip;
  };
  Side makeSide();
  void apply();

  vtkRenderer* renderer_;
  std::shared_ptr<const DisplayMesh> mesh_;
  Side remnant_;
  std::optional<Side> resected_;
  Rgb colour_;
  double opacity_ = 1;
  bool visible_ = true;
  bool cut_ = false;
  std::array<bool, kDetails> uploaded_{};
};

}  // namespace glisson
