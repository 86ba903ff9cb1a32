#pragma once
// Purpose: a mask's centreline as a forest of voxels with parents: joined, rooted, its rings opened, its spurs pruned. A part of
// vesselGraphOf(); see vessel_graph.h for the method. Lengths in mm.

#include "planning/territories/vessel_graph.h"

namespace glisson {

struct CentrelineTree {
  std::vector<VesselSite> sites;      ///< parent set, branch not; in no particular order
  std::vector<std::int32_t> piece;    ///< tree of each site; the one with most length inside the liver is 0
  std::vector<std::uint8_t> isLoose;  ///< per tree: a small piece nothing is known about
  std::vector<std::string> notes;     ///< beginning with `name`
};

/// Polls cancel.
CentrelineTree centrelineTreeOf(const std::string& name, const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                                const ExecutionContext& context);

}  // namespace glisson
