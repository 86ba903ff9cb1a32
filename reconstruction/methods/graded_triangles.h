#pragma once
// Purpose: the polygonisation that follows a vessel's calibre: triangles whose edges have one proportion to the local radius, large
// on trunks and small on thin branches, as far as a bound of distance lets them be. On a tube the radius is that of its curvature.
// Frame: mm LPS. Source of the idea: B. R. de Araujo, J. A. P. Jorge: Curvature dependent polygonization of implicit surfaces.
// SIBGRAPI, 2004 (as Wu et al. 2010 use it); here edges are collapsed (mesh/collapser.h) until they have that length.

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// A closed manifold mesh with the pieces, handles and volume of `mesh`, whose edges are about `ratio` times the local radius
/// (local_radius.h) long, or as long as they were where that is more; no vertex of `mesh` lies farther from it than `distanceMm`.
/// Where that cannot be had together (a large organ, whose roughness decides), the mesh is that of simplify().
/// Throws CheckFailed where `mesh` is not closed and manifold, Cancelled. The same bytes for any number of threads.
SurfaceMesh gradeTriangles(const SurfaceMesh& mesh, double ratio, double distanceMm, const ExecutionContext& context = {});

}  // namespace glisson
