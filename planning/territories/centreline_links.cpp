#include "planning/territories/centreline_links.h"

#include "planning/territories/vessel_paths.h"

namespace glisson {

CentrelineLinks linkedCentreline(const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                                 const ExecutionContext& context) {
  CentrelineLinks made;
  for (const PathVoxel& step : vesselPaths(vessel, geometry.spacing, context)) {
    const auto number = static_cast<std::int32_t>(made.sites.size());
    VesselSite site;
    site.voxel = step.voxel;
    site.positionMm = geometry.toWorld(Vec3(step.voxel[0], step.voxel[1], step.voxel[2]));
    site.radiusMm = step.radiusMm;
    site.inLiver = liver.at(step.voxel[0], step.voxel[1], step.voxel[2]);
    made.sites.push_back(site);
    made.links.emplace_back();
    if (step.parent >= 0) {
      const Index3& other = made.sites[static_cast<std::size_t>(step.parent)].voxel;
      const double mm =
          geometry.spacing.cwiseProduct(Vec3(other[0] - step.voxel[0], other[1] - step.voxel[1], other[2] - step.voxel[2])).norm();
      made.links.back().push_back({step.parent, mm});
      made.links[static_cast<std::size_t>(step.parent)].push_back({number, mm});
    }
  }
  return made;
}

}  // namespace glisson
