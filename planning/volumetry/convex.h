#pragma once
// Purpose: convex polygons and bodies cut by half-spaces, by clipping: exact up to rounding, no tables, no tolerance in the shapes.
// Frame: any orthonormal one, mm. A body is the intersection of half-spaces {p : distance(p) >= 0} with one box.

#include <span>
#include <vector>

#include "planning/volumetry/voxel_rows.h"

namespace glisson {

using Polygon = std::vector<Vec3>;  ///< convex, planar, in order

/// The polygon's part with distance >= 0 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, const ImagePlane& plane);
double areaOf(const Polygon& polygon);

/// The section of a box by a plane; empty where they do not meet.
Polygon sectionOf(const Box& box, const ImagePlane& plane);

/// Volume of box and half-spaces, mm^3: one third of the sum of face area x distance (divergence theorem) over the faces, each face
/// being its plane's section of the box clipped by the other planes.
double volumeOf(const Box& box, std::span<const ImagePlane> planes);

enum class Coplanar : std::uint8_t { No, Same, Opposite };
/// Whether two planes are one and the same within kOnPlaneMm over `reach` mm around `point`, facing the same or the opposite way.
Coplanar coplanar(const ImagePlane& a, const ImagePlane& b, const Vec3& point, double reach);

}  // namespace glisson
