#pragma once
// Purpose: where a plane crosses a closed mesh: outline loops, a grid that fills them, and whether a point lies inside. For
// drawing while the plane moves (linear time); the measured section is reconstruction/mesh/cut.h. Frame: mm LPS.

#include <utility>
#include <vector>

#include "planning/resection/bend.h"

namespace glisson {

/// Unit axes within the plane that turn as little as possible when the plane turns: v is +z (or +y) as seen in the plane,
/// u = v x normal.
struct PlaneAxes {
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitY();
};
PlaneAxes axesOf(const Vec3& normal);

using Loop = std::vector<Vec3>;  ///< closed: the last point is joined to the first

/// The loops in which the plane, bent or not, crosses the mesh: their points lie on the mesh's edges. On a mesh that is not closed,
/// open ends are joined to each other. What is asked of loops below is asked of their shadows in the plane, along its normal.
std::vector<Loop> sectionLoops(const SurfaceMesh& mesh, const ResectionPlane& plane);

/// Even-odd rule within the plane.
bool isInside(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point);

/// The parts of lines `spacingMm` apart, along both axes through the plane's origin, that lie inside the loops.
std::vector<std::pair<Vec3, Vec3>> gridLines(const std::vector<Loop>& loops, const HalfSpace& plane, double spacingMm);

/// The same over a bent plane: each line in pieces of at most 2 mm, on the surface.
std::vector<std::pair<Vec3, Vec3>> gridLines(const std::vector<Loop>& loops, const BentSurface& surface, double spacingMm);

/// The part of a bent surface inside the loops, as triangles some `stepMm` wide that face the resected side. Empty where the loops
/// cross each other.
SurfaceMesh filled(const std::vector<Loop>& loops, const BentSurface& surface, double stepMm);

/// Centre of the area of the largest loop; the plane's origin where there is none.
Vec3 centreOf(const std::vector<Loop>& loops, const HalfSpace& plane);

/// How far one can go from `point` (in the plane) along the unit `direction` (in the plane) until the last loop is crossed, mm;
/// 0 where none is.
double reach(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point, const Vec3& direction);

}  // namespace glisson
