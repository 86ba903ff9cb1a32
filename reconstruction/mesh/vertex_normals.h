#pragma once
// Purpose: a normal for every vertex of a surface, for shading and for what looks along it.

#include <vector>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// Unit, to the triangles' outer side, each triangle counting by its area; +z where a vertex has none.
std::vector<Vec3> vertexNormals(const SurfaceMesh& mesh);

/// Makes them unit; +z where one has no length.
void normalise(std::vector<Vec3>& normals);

}  // namespace glisson
