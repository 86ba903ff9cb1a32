#pragma once
// Purpose: the way from a point to the intersection of some half-spaces, for depths under a resection. Frame: the image frame, mm.

#include <span>

#include "planning/volumetry/voxel_rows.h"

namespace glisson {

/// The distance of p to the intersection and the unit direction of the way to it, where it is less than `best`; 0 inside, within
/// kOnPlaneMm. Both stay where the intersection is empty. By the optimality conditions: some one, two or three planes are active,
/// the step is a sum of their normals with positive weights, and it ends in all half-spaces. Only one point does that, so the first
/// one found is it. Source: S. Boyd, L. Vandenberghe, Convex Optimization, 2004, 5.5.3.
void keepProjection(const Vec3& p, std::span<const ImagePlane> planes, double& best, Vec3& normal);

}  // namespace glisson
