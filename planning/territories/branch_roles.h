#pragma once
// Purpose: which branches are trunk, which supply or drain the liver, and where the trunk divides. A part of vesselGraphOf().

#include "planning/territories/vessel_graph.h"

namespace glisson {

/// Fills inLiverMm, downstreamMm, centreMm and role of every branch, and the main bifurcation. `isLoose` per tree; `cava` may be
/// null.
void assignRoles(VesselGraph& graph, const std::vector<std::uint8_t>& isLoose, const Mask* cava);

}  // namespace glisson
