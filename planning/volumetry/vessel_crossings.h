#pragma once
// Purpose: where the resection surface crosses the vessels inside the liver.

#include <string>
#include <vector>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/inscribed_balls.h"
#include "planning/volumetry/resected.h"

namespace glisson {

/// One entry per connected piece of (vessel voxels and resection surface): centroid, and the diameter of the circle with its area.
/// The area is multiplied by |cos| of the angle between the surface's normal and the vessel's direction, where that direction is
/// clear: the main axis of the vessel's voxels within a ball around the crossing, its variance at least twice the next one's. That
/// holds only where the whole oblique section lies in the surface, so the diameter is never below the vessel's calibre around the
/// deepest voxel of the crossing.
/// `rows`: the vessel's voxels inside L; `pieces`: the resection surface inside them, its runs those of `rows`; `balls`: of the
/// whole vessel. Largest first.
std::vector<VesselCrossing> vesselCrossings(const std::string& id, const std::string& name, const VoxelRows& rows,
                                            const std::vector<CutPiece>& pieces, const InscribedBalls& balls,
                                            const ImageGeometry& geometry);

}  // namespace glisson
