#include "planning/territories/marked_branches.h"

#include <limits>
#include <set>

namespace glisson {

namespace {
/// The branch of the site nearest to a point, among those that `counts`; nothing where none lies within `withinMm`.
template <typename Counts>
std::optional<std::int32_t> nearestBranch(const VesselGraph& portal, const Vec3& pointMm, double withinMm, Counts counts) {
  std::optional<std::int32_t> nearest;
  double least = withinMm;
  for (const VesselSite& site : portal.sites) {
    const double distance = (site.positionMm - pointMm).norm();
    if (distance < least && site.branch >= 0 && counts(portal.branches[static_cast<std::size_t>(site.branch)])) {
      least = distance;
      nearest = site.branch;
    }
  }
  return nearest;
}
}  // namespace

std::optional<std::int32_t> nearestSupplyingBranch(const VesselGraph& portal, const Vec3& pointMm) {
  return nearestBranch(portal, pointMm, std::numeric_limits<double>::infinity(),
                       [](const VesselBranch& branch) { return branch.role == BranchRole::Supplying; });
}

TerritoryMarks marksOf(const TerritoryChoice& choice, const VesselGraph& portal) {
  TerritoryMarks marks;
  if (!choice.confirmed) {
    return marks;
  }
  marks.segments = choice.segments;
  marks.proposed = choice.source == TerritorySource::Proposal && !choice.picks.empty();
  for (const TerritoryPick& pick : choice.picks) {
    TerritoryMark mark{pick.name, {}};
    for (const std::int32_t number : pick.branches) {
      const VesselBranch& branch = portal.branches.at(static_cast<std::size_t>(number));
      mark.pointsMm.push_back(portal.sites[static_cast<std::size_t>(branch.firstSite + branch.siteCount / 2)].positionMm);
    }
    marks.marks.push_back(std::move(mark));
  }
  return marks;
}

TerritoryChoice choiceOf(const TerritoryMarks& marks, const VesselGraph& portal) {
  if (marks.segments) {
    return segmentChoice(*marks.segments);
  }
  if (marks.marks.empty()) {
    return proposeLeftRight(portal);
  }
  TerritoryChoice choice;
  choice.source = marks.proposed ? TerritorySource::Proposal : TerritorySource::Picked;
  choice.confirmed = true;
  std::set<std::int32_t> taken;
  for (const TerritoryMark& mark : marks.marks) {
    TerritoryPick pick{mark.name, {}};
    for (const Vec3& point : mark.pointsMm) {
      const std::optional<std::int32_t> branch = nearestBranch(portal, point, kMarkMm, [](const VesselBranch&) { return true; });
      if (!branch || !taken.insert(*branch).second) {
        TerritoryChoice proposal = proposeLeftRight(portal);
        proposal.notes.emplace_back("The branches marked earlier are not in this portal vein; left and right are proposed anew.");
        return proposal;
      }
      pick.branches.push_back(*branch);
    }
    choice.picks.push_back(std::move(pick));
  }
  return choice;
}

}  // namespace glisson
