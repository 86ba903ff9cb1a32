#pragma once
// Purpose: meshes for the GPU: SurfaceMesh -> vtkPolyData (float, mm LPS) with smooth normals. Display only: nothing is measured on
// it.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

#include "viewer/display_mesh.h"
#include "viewer/frame_budget.h"

namespace glisson {

/// Points, triangles and one area-weighted unit normal per vertex.
vtkSmartPointer<vtkPolyData> toPolyData(const SurfaceMesh& mesh);

/// A small mesh is the same object in several details.
struct DisplayMesh {
  std::shared_ptr<const Reconstruction> source;
  SurfaceMesh coarse;  ///< stand-in while something moves; empty where there are none yet
  std::array<vtkSmartPointer<vtkPolyData>, kDetails> polys;

  [[nodiscard]] vtkPolyData* poly(Detail detail) const { return polys[static_cast<std::size_t>(detail)]; }
};

}  // namespace glisson
