#pragma once
// Purpose: meshes for the GPU: SurfaceMesh -> vtkPolyData (float, mm LPS) with smooth normals. Display only: nothing is measured on
// it.

#include <vtkSmartPointer.h>

#include "viewer/display_mesh.h"

class vtkPolyData;

namespace glisson {

/// Points, triangles and one area-weighted unit normal per vertex.
vtkSmartPointer<vtkPolyData> toPolyData(const SurfaceMesh& mesh);

struct DisplayMesh {
  std::shared_ptr<const Reconstruction> source;
  SurfaceMesh coarse;  ///< stand-in while something moves
  vtkSmartPointer<vtkPolyData> full;
  vtkSmartPointer<vtkPolyData> coarsePoly;
};

}  // namespace glisson
