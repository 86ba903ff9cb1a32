#pragma once
// Purpose: a coarse stand-in for a mesh, drawn while something moves. Display only: nothing is measured on it. Frame: mm LPS.

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// About `triangles` triangles by vertex clustering (Rossignac and Borrel 1993: every vertex moves to the mean of its grid cell).
/// Linear time (10 ms per 100,000 triangles); neither closed nor manifold. A mesh that is already that small comes back unchanged.
SurfaceMesh clustered(const SurfaceMesh& mesh, std::size_t triangles);

}  // namespace glisson
