#pragma once
// Purpose: how deep a tumour that is cut reaches into the remnant: minus its margin (method.md 5). Frame: image, mm.

#include "planning/volumetry/resected.h"

namespace glisson {

/// The greatest distance of the boxes' points to the resected region, mm; the direction it is measured along in `normal`. Exact for
/// one resection of flat planes (the distance to a convex body is greatest at a corner) and for several of one plane each; of
/// others, whose deepest point can lie between corners, within 0.05 mm. Bent: over corners. To a bent surface by touching planes
/// from the nearest of 169 of its points, within 0.01 mm where its radius is larger than the depth; where the steps do not settle,
/// the largest of their depths, and along a plane's normal where they find none: no corner outside has depth 0.
double greatestDepth(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan, Vec3& normal);

}  // namespace glisson
