#include "planning/territories/vessel_cuts.h"

#include <algorithm>
#include <cmath>

namespace glisson {

namespace {
/// Where the way from `from` to `to` enters the resected region, 0..1; nothing where it stays outside or only touches it. The way
/// is from one voxel to the next: over it a bent plane is taken as flat.
std::optional<double> entry(const Vec3& from, const Vec3& to, const std::vector<ImageResection>& plan) {
  std::optional<double> first;
  for (const ImageResection& resection : plan) {
    double begin = 0;
    double end = resection.takesNothing() ? 0 : 1;
    const auto keepAbove = [&](double a, double b) {
      if (a < 0 && b < 0) {
        end = 0;
      } else if (a < 0) {
        begin = std::max(begin, a / (a - b));
      } else if (b < 0) {
        end = std::min(end, a / (a - b));
      }
    };
    for (const ImagePlane& plane : resection.planes) {
      keepAbove(plane.distance(from), plane.distance(to));
    }
    for (const BentSurface& bend : resection.bends) {
      keepAbove(bend.above(from), bend.above(to));
    }
    constexpr double kTouching = 1e-9;
    if (end - begin > kTouching && (!first || begin < *first)) {
      first = begin;
    }
  }
  return first;
}

/// On the trunk, or on a branch that leaves it while still inside its wall.
bool isInTrunk(const VesselGraph& graph, const VesselSite& site) {
  const VesselBranch& branch = graph.branches[static_cast<std::size_t>(site.branch)];
  if (branch.role == BranchRole::Trunk || branch.parent < 0) {
    return branch.role == BranchRole::Trunk;
  }
  const VesselSite& from = graph.sites[static_cast<std::size_t>(graph.nodes[static_cast<std::size_t>(branch.fromNode)].site)];
  return graph.branches[static_cast<std::size_t>(branch.parent)].role == BranchRole::Trunk &&
         (site.positionMm - from.positionMm).norm() <= from.radiusMm;
}
/// entry() once islands are where they belong: a way into one that is given back is none, one into a piece of the remnant that is
/// resected with the rest is.
std::optional<double> entryWithIslands(const Vec3& from, const Vec3& to, const VesselSite& site, const Vec3& spacing,
                                       const std::vector<ImageResection>& plan, const SidePieces& sides) {
  if (sides.isSwitched(PlanSide::Remnant, site.voxel) && !isResected({to, Vec3::Zero()}, plan)) {
    return 1.0;
  }
  const std::optional<double> where = entry(from, to, plan);
  if (!where) {
    return where;
  }
  constexpr double kInto = 1e-6;
  const Vec3 index = (from + std::min(1.0, *where + kInto) * (to - from)).cwiseQuotient(spacing);
  const Index3 voxel{static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
                     static_cast<int>(std::lround(index[2]))};
  const bool isGivenBack = sides.isSwitched(PlanSide::Resected, voxel) || sides.isSwitched(PlanSide::Resected, site.voxel);
  return isGivenBack ? std::nullopt : where;
}
}  // namespace

LostSites lostSites(const VesselGraph& graph, const ImageGeometry& geometry, const std::vector<ImageResection>& plan,
                    const SidePieces* sides) {
  LostSites lost;
  lost.isLost.assign(graph.sites.size(), 0);
  const auto placeOf = [&](const VesselSite& site) {
    return Vec3(geometry.spacing.cwiseProduct(Vec3(site.voxel[0], site.voxel[1], site.voxel[2])));
  };
  for (std::size_t s = 0; s < graph.sites.size(); ++s) {
    const VesselSite& site = graph.sites[s];
    const bool isRoot = site.parent < 0;
    if (!isRoot && lost.isLost[static_cast<std::size_t>(site.parent)] != 0) {
      lost.isLost[s] = 1;
      continue;
    }
    const VesselSite& before = isRoot ? site : graph.sites[static_cast<std::size_t>(site.parent)];
    const bool isCava = graph.system == VesselSystem::Hepatic && isInTrunk(graph, site);
    if (isCava || (!site.inLiver && !before.inLiver)) {
      continue;
    }
    const Vec3 from = placeOf(before);
    const Vec3 to = placeOf(site);
    const std::optional<double> where =
        sides == nullptr ? entry(from, to, plan) : entryWithIslands(from, to, site, geometry.spacing, plan, *sides);
    if (where) {
      lost.isLost[s] = 1;
      const Vec3 cut = geometry.origin + geometry.direction * (from + *where * (to - from));
      lost.cuts.push_back({site.branch, cut, site.radiusMm});
    }
  }
  return lost;
}

}  // namespace glisson
