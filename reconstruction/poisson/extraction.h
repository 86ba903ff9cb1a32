#pragma once
// Purpose: the surface X = iso of the solved indicator as a closed, oriented, manifold mesh.

#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/poisson/hierarchy.h"

namespace glisson::poisson {

/// Marching cubes on the finest level (marching_cases.h). Where the surface leaves the band, the band is grown with the coarser
/// level's values first, so that nothing stays open. `corner` is the cube's low corner, `cellMm` the finest cell; both in mm of the
/// output's frame.
SurfaceMesh extractSurface(std::vector<Level>& levels, float iso, const Vec3& corner, double cellMm,
                           const ExecutionContext& context);

}  // namespace glisson::poisson
