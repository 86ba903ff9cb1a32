#pragma once
// Purpose: how thick a body is at each vertex of its surface: the radius of the greatest ball inside that touches there; of a tube
// the tube's own. Frame: mm LPS.
// Source: J. Ma, S. W. Bae, S. Choi: 3D medial axis point approximation using nearest neighbors and the normal field. The Visual
// Computer, 2012 (balls that shrink until nothing is inside); here steps between voxels, which are no wall, stop no ball, and the
// median over the surroundings stands for each.

#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// One for each vertex of a closed mesh whose triangles face outward, above 0 and at most half the mesh's least extent. The same
/// bytes for any number of threads. Throws std::invalid_argument where there are no vertices. Polls cancel every few thousand
/// vertices.
std::vector<double> localRadii(const SurfaceMesh& mesh, const ExecutionContext& context = {});

}  // namespace glisson
