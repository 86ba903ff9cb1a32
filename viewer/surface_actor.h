#pragma once
// Purpose: one surface in a view that compares surfaces, coloured by its errors where they are there. Private to viewer/.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <array>

#include "viewer/mesh_polydata.h"
#include "viewer/surface_errors.h"

namespace glisson {

/// By detail, as the meshes of a DisplayMesh; the same array where they are the same mesh.
struct SurfaceErrors {
  std::array<vtkSmartPointer<vtkFloatArray>, kDetails> values;
};

class SurfaceActor {
 public:
  /// Uploaded with the next frame that draws it.
  SurfaceActor(vtkRenderer* renderer, std::shared_ptr<const DisplayMesh> mesh);
  ~SurfaceActor();
  SurfaceActor(const SurfaceActor&) = delete;
  SurfaceActor& operator=(const SurfaceActor&) = delete;

  /// Null: one plain colour.
  void setErrors(const std::shared_ptr<const SurfaceErrors>& errors, vtkLookupTable* colours);
  void setWireframe(bool wireframe);
  /// Keeps the side that its normal points to; null: nothing is cut away.
  void setClip(vtkPlane* plane);
  void setDetail(Detail detail);

  [[nodiscard]] bool uploaded(Detail detail) const { return uploaded_[static_cast<std::size_t>(detail)]; }
  [[nodiscard]] std::size_t triangles(Detail detail) const;
  [[nodiscard]] const std::shared_ptr<const DisplayMesh>& mesh() const { return mesh_; }
  [[nodiscard]] const std::shared_ptr<const SurfaceErrors>& errors() const { return errors_; }

 private:
  vtkRenderer* renderer_;
  std::shared_ptr<const DisplayMesh> mesh_;
  std::shared_ptr<const SurfaceErrors> errors_;
  vtkNew<vtkActor> actor_;
  std::array<vtkNew<vtkPolyDataMapper>, kDetails> mappers_;
  std::array<bool, kDetails> uploaded_{};
};

}  // namespace glisson
