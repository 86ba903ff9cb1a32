#pragma once
// Purpose: a mesh as files hold it: float vertices. What collapses when rounded is welded and dropped; every vertex still knows the
// double vertex it stands for. Frame: mm LPS.

#include <array>
#include <cstdint>
#include <vector>

#include "planning/exchange/mesh_files.h"

namespace glisson {

struct FloatMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> source;  ///< per vertex: the vertex of the double mesh it was rounded from
};

/// Rounds, welds equal vertices, drops triangles that lost a corner and pairs that fold onto each other, and flips the long edge of
/// triangles whose three corners fell on one line. Throws PlanningError where a coordinate is not finite or not a float.
FloatMesh toFloatMesh(const SurfaceMesh& mesh);

/// Area-weighted unit normals per vertex; (0,0,1) where a vertex has no area around it.
std::vector<std::array<float, 3>> vertexNormals(const FloatMesh& mesh);

}  // namespace glisson
