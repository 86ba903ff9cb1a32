#pragma once
// Purpose: cuts a closed mesh by planes into closed, capped parts, in double precision (method.md 5).

#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// A half-space {x : normal . (x - origin) >= 0}; origin mm LPS, unit normal.
struct HalfSpace {
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  bool operator==(const HalfSpace&) const = default;
};

struct CutResult {
  SurfaceMesh positive;  ///< closed part with normal . (x - origin) >= 0; empty where there is none
  SurfaceMesh negative;  ///< closed part on the other side
  SurfaceMesh section;   ///< the cut itself (the cap), facing +normal; open by nature; its area is the cut's area
};

/// Cuts a closed mesh by one plane. Vertices within 1e-7 mm of the plane are on it for both halves. |V1 + V2 - V| <= 1e-9 V; both
/// halves closed, oriented, manifold, checked before they are handed out. The section's corners are those of its border; where the
/// section touches itself in a vertex each half has a copy for each fan; a diagonal that would lie on an edge of the surface that
/// touches the plane gets a vertex in its middle. Where rounding leaves a section that cannot be filled, the plane is moved along
/// its normal by up to 3.2e-6 mm. Polls cancel before each try. Throws CheckFailed where `mesh` has defects or no sound cut is
/// found, ReconstructionError where the plane has no direction.
CutResult cut(const SurfaceMesh& mesh, const HalfSpace& plane, const ExecutionContext& context = {});

/// The same for parts that go into files of floats, with vertices on the places that floats have, and no self-intersections at the
/// cut once they are there. `mesh` has its vertices on such places already. Let u be floatSpacingMm(mesh), 1.2e-4 mm at 1 to 2 m:
/// vertices within 8 u of the plane are projected onto it, and every vertex of the section is rounded before the section is filled;
/// where a half would not be sound or would cross itself, other tolerances (at most 32 u) and planes moved along the normal (at
/// most 7 u) are tried. So nothing moves farther than 40 u. |V1 + V2 - V| <= 1e-9 V of the mesh so moved. Throws and polls as
/// cut() does.
CutResult cutForFloats(const SurfaceMesh& mesh, const HalfSpace& plane, const ExecutionContext& context = {});

/// The distance between neighbouring floats at the mesh's farthest coordinate, mm. Throws std::invalid_argument on an empty mesh.
double floatSpacingMm(const SurfaceMesh& mesh);

}  // namespace glisson
