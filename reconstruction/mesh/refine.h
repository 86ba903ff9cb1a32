#pragma once
// Purpose: splits long edges of a mesh where it is asked to, so that a curve can follow it there. Frame: mm LPS.

#include <functional>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// The mesh with every edge longer than `longestMm` of the triangles that `wanted` (by their corners' places) split in its middle,
/// and again, until none is left or 10 rounds are over. Conforming: an edge is split in both its triangles. New vertices lie on the
/// places that floats have.
SurfaceMesh splitLongEdges(const SurfaceMesh& mesh, double longestMm,
                           const std::function<bool(const Vec3& a, const Vec3& b, const Vec3& c)>& wanted);

}  // namespace glisson
