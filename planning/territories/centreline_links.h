#pragma once
// Purpose: the voxels of the middle lines of a mask, joined. A part of centrelineTreeOf().

#include <span>

#include "planning/territories/vessel_graph.h"

namespace glisson {

/// Two voxels that touch, and the mm between their centres.
struct SiteLink {
  std::int32_t to = 0;
  double mm = 0;
};

struct CentrelineLinks {
  std::vector<VesselSite> sites;             ///< parents not set
  std::vector<std::vector<SiteLink>> links;  ///< per site, both ways

  [[nodiscard]] const std::vector<SiteLink>& of(std::int32_t site) const { return links[static_cast<std::size_t>(site)]; }
};

/// Polls cancel.
CentrelineLinks linkedCentreline(const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                                 const ExecutionContext& context);

}  // namespace glisson
