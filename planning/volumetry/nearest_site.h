#pragma once
// Purpose: the nearest of some voxels for every voxel of a box: an exact Euclidean Voronoi diagram of voxel centres in mm.
// Frame: the image frame, p = spacing * index (an isometry of the world). Source: P. Felzenszwalb and D. Huttenlocher, Distance
// transforms of sampled functions, 2012: one pass per axis, each a lower envelope of parabolas that carries the site along.

#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"

namespace glisson {

inline constexpr std::int32_t kNoSite = -1;

/// The number of the nearest site per voxel of `box`, i fastest; kNoSite everywhere where there are no sites. Of equally near sites
/// one is taken, the same for any number of threads. Sites outside the box throw std::invalid_argument. Polls cancel per axis.
/// Memory: four bytes a voxel.
std::vector<std::int32_t> nearestSites(const IndexBox& box, const Vec3& spacing, std::span<const Index3> sites,
                                       const ExecutionContext& context = {});

}  // namespace glisson
