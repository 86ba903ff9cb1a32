#pragma once
// Purpose: where a plane crosses a closed mesh: outline loops, a grid that fills them, and whether a point lies inside. For
// drawing while the plane moves (linear time); the measured section is reconstruction/mesh/cut.h. Frame: mm LPS.

#include <utility>
#include <vector>

#include "reconstruction/mesh/cut.h"

namespace glisson {

/// Unit axes within the plane that turn as little as possible when the plane turns: v is +z (or +y) as seen in the plane,
/// u = v x normal.
struct PlaneAxes {
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitY();
};
PlaneAxes axesOf(const Vec3& normal);

using Loop = std::vector<Vec3>;  ///< closed: the last point is joined to the first

/// The loops in which the plane crosses the mesh. On a mesh that is not closed, open ends are joined to each other.
std::vector<Loop> sectionLoops(const SurfaceMesh& mesh, const HalfSpace& plane);

/// Even-odd rule within the plane.
bool isInside(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point);

/// The parts of lines `spacingMm` apart, along both axes through the plane's origin, that lie inside the loops.
std::vector<std::pair<Vec3, Vec3>> gridLines(const std::vector<Loop>& loops, const HalfSpace& plane, double spacingMm);

/// Centre of the area of the largest loop; the plane's origin where there is none.
Vec3 centreOf(const std::vector<Loop>& loops, const HalfSpace& plane);

/// How far one can go from `point` (in the plane) along the unit `direction` (in the plane) until the last loop is crossed, mm;
/// 0 where none is.
double reach(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point, const Vec3& direction);

}  // namespace glisson
