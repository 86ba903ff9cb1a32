#pragma once
// Purpose: which voxels a structure of a case is made from.

#include "planning/case/case.h"

namespace glisson {

/// L for the parenchyma, else the mask as it was read; on the grid of the case's segmentation. Throws PlanningError where the case
/// has no such mask.
const Mask& maskOf(const Case& source, const Structure& structure);

}  // namespace glisson
