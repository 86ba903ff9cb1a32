#pragma once
// Purpose: which sites of a vessel graph a plan cuts off from their root. A part of LiverPerfusion.

#include "planning/territories/perfusion.h"
#include "planning/volumetry/side_pieces.h"

namespace glisson {

struct LostSites {
  std::vector<std::uint8_t> isLost;  ///< per site
  std::vector<VesselCut> cuts;
};

/// `plan` in the image frame of `geometry`. `sides`: where islands are given to the other side; null where none is.
LostSites lostSites(const VesselGraph& graph, const ImageGeometry& geometry, const std::vector<ImageResection>& plan,
                    const SidePieces* sides = nullptr);

}  // namespace glisson
