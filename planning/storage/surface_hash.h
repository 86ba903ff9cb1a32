#pragma once
// Purpose: which surface it is, in any session.

#include <string>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// SHA-256 of the vertices and triangles.
std::string surfaceHash(const SurfaceMesh& mesh);

}  // namespace glisson
