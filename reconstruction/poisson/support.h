#pragma once
// Purpose: no finer triangles than the samples support. `paper` samples stand a slice apart; cells much narrower than that are
// empty between the slices, where the octree of Kazhdan et al. 2006 is not divided either.

#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/poisson/splatting.h"

namespace glisson::poisson {

/// Collapses short edges between vertices whose cell of the level below the finest holds no sample; what touches no such vertex
/// stays as it is. The enclosed volume and the topology are kept, and no new triangle crosses another one: an edge is collapsed
/// only where all the surface around it faces one way along an axis before and after, that is where it is the graph of a function.
/// `mesh` is closed and manifold; `corner` and `cellMm` as in extractSurface. Polls cancel.
void coarsenUnsupported(const CubeSamples& samples, const Vec3& corner, double cellMm, SurfaceMesh& mesh,
                        const ExecutionContext& context);

}  // namespace glisson::poisson
