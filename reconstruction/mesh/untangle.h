#pragma once
// Purpose: takes the few self-intersections out of a smoothed mesh that smoothing leaves behind decimation: the vertices of the
// triangles concerned move toward the mean of their neighbours, the rest stays where it is. Topology is never changed.

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

struct Untangled {
  std::size_t before = 0;         ///< intersecting pairs found
  std::size_t after = 0;          ///< pairs that are left
  std::size_t movedVertices = 0;  ///< vertices that moved
};

/// Moves vertices of `mesh` in up to eight rounds and keeps the round with the fewest pairs: none where every round has as many as
/// the mesh or more, or where there are more than `mostPairs` to begin with (then the mesh is wrong as a whole, not in places).
/// Polls cancel as countSelfIntersections does.
Untangled untangle(SurfaceMesh& mesh, std::size_t mostPairs, const ExecutionContext& context = {});

}  // namespace glisson
