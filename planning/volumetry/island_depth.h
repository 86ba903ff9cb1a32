#pragma once
// Purpose: how deep a tumour that is cut reaches into the remnant where islands are given to the other side: tumour_depth.h for a
// region that is no intersection of half-spaces. Frame: image, mm.

#include "planning/volumetry/cut_distance.h"
#include "planning/volumetry/side_pieces.h"

namespace glisson {

/// The greatest way from a corner of the tumour's voxels that stays in the remnant, islands where they are given to, to the
/// resection surface. `cut`: that surface, without what no longer divides the sides.
CutDistance::Way greatestDepth(const VoxelRows& tumour, const Vec3& spacing, const std::vector<ImageResection>& plan,
                               const SidePieces& sides, const CutDistance& cut);

}  // namespace glisson
