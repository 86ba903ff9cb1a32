#pragma once
// Purpose: takes a mesh apart at its sharp edges, as vtkPolyDataNormals with Splitting does to give them normals of their own: what
// 3D Slicer's models are when they are handed out (method.md 3, step 6). In mm, where the angles are those of the body.

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

inline constexpr double kFeatureAngleDegrees = 60;  ///< of 3D Slicer's ModelMaker

/// The same triangles in their order. At each vertex, those that are joined by edges of two triangles whose normals differ by less
/// than `featureAngleDegrees` keep one copy of it; others have copies of their own. Unused vertices are dropped.
SurfaceMesh splitAtSharpEdges(const SurfaceMesh& mesh, double featureAngleDegrees = kFeatureAngleDegrees);

}  // namespace glisson
