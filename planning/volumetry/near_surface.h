#pragma once
// Purpose: the few pieces of the resection surface that decide about a tumour's margin, without the others. Frame: image, mm.

#include "planning/volumetry/cut_distance.h"
#include "planning/volumetry/row_blocks.h"

namespace glisson {

/// Pieces of the surface inside `liver` among which are all that marginOf() needs: those that may be nearest, and those that may
/// come as near by what a bent plane's pieces are flattened. `cut`: cutBlocks() of the plan. None where there is no surface.
std::vector<CutPiece> surfaceNear(const TumourBoxes& tumour, const RowBlocks& liver, const std::vector<std::size_t>& cut,
                                  const Vec3& spacing, const std::vector<ImageResection>& plan);

}  // namespace glisson
