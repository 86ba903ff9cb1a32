#pragma once
// Purpose: cuts a closed mesh by planes into closed, capped parts, in double precision (method.md 5).

#include <functional>
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

/// A surface that stands over a plane as a graph.
struct CuttingSurface {
  HalfSpace plane;
  /// How far a point lies above the surface along the plane's normal, mm: linear along the normal, with slope 1.
  std::function<double(const Vec3&)> above;
  double mostCurved = 0;  ///< no second derivative of the height over the plane is larger, 1/mm
};

/// The section follows a curved surface, at its corners exactly and between them within this, mm.
inline constexpr double kCurvedCutMm = 0.05;

/// cutForFloats() along a surface: positive is what lies above it. Long edges of the mesh near the surface are split first (their
/// new corners on the places of floats), the mesh is cut where its edges cross the surface, and the section has inner points, close
/// enough for kCurvedCutMm as long as no radius of the surface is below 5 mm. Both halves have the same section. The promises are
/// those of cutForFloats(); the volume is that of the mesh with its edges split.
CutResult cutForFloats(const SurfaceMesh& mesh, const CuttingSurface& surface, const ExecutionContext& context = {});

/// The distance between neighbouring floats at the mesh's farthest coordinate, mm. Throws std::invalid_argument on an empty mesh.
double floatSpacingMm(const SurfaceMesh& mesh);

}  // namespace glisson
