#pragma once
// Purpose: the few corners of a set of voxel boxes that matter for extents and diameters. Frame: image, mm.

#include <utility>
#include <vector>

#include "planning/volumetry/voxel_rows.h"

namespace glisson {

/// Corners of the voxels' boxes, among them every vertex of their convex hull. Method: a vertex of the hull is a vertex of the hull
/// of the corners in its own plane between two slices, and those are found plane by plane (Andrew's monotone chain, 1979).
std::vector<Vec3> hullCorners(const VoxelRows& rows, const Vec3& spacing);

/// The two corners farthest apart: the longest diameter of the voxels' boxes, exactly. Both zero where there are no voxels.
std::pair<Vec3, Vec3> farthestCorners(const VoxelRows& rows, const Vec3& spacing);

}  // namespace glisson
