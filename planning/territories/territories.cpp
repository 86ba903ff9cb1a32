#include "planning/territories/territories.h"

#include <algorithm>
#include <tuple>

#include "planning/territories/branch_owners.h"
#include "planning/territories/place.h"
#include "planning/volumetry/nearest_site.h"
#include "planning/volumetry/side_pieces.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr double kMostOfLeft = 0.5;  ///< share of the supplied length: a left liver is not larger
constexpr double kUsualLeftLow = 0.15;
constexpr int kSegments = 8;
constexpr const char* kNoBifurcation =
    "The label of the portal vein has no main bifurcation, so left and right are not proposed; pick branches.";

/// Calls visit(i, j, k, set) for every voxel of L's box and deals the set ones to `parts` by the label visit returns.
template <typename LabelOf>
void dealVoxels(const Mask& liver, LabelOf&& labelOf, std::vector<Territory>& parts) {
  const IndexBox& box = liver.box();
  const auto values = liver.values();
  std::size_t n = 0;
  for (int k = box.first[2]; k < box.first[2] + box.size[2]; ++k) {
    for (int j = box.first[1]; j < box.first[1] + box.size[1]; ++j) {
      std::size_t open = parts.size();  // the part whose last run ends at the voxel before
      for (int i = box.first[0]; i < box.first[0] + box.size[0]; ++i, ++n) {
        if (values[n] == 0) {
          open = parts.size();
          continue;
        }
        const std::size_t label = labelOf(i, j, k);
        VoxelRows& rows = parts[label].rows;
        if (label == open) {
          ++rows.runs.back().n;
        } else {
          rows.runs.push_back({i, j, k, 1});
        }
        ++rows.voxels;
        open = label;
      }
    }
  }
}

/// Sides as of VesselGraph::sidesOf, without those that own nothing.
std::vector<std::int32_t> owningSides(const VesselGraph& portal, std::int32_t branch, double inLiverMm) {
  std::vector<std::int32_t> sides = portal.sidesOf(branch, inLiverMm);
  std::erase_if(sides, [&](std::int32_t side) {
    for (std::int32_t b = side; at(b) < portal.branches.size(); ++b) {
      if (portal.branches[at(b)].role == BranchRole::Supplying && portal.isDownstream(b, side)) {
        return false;
      }
    }
    return true;
  });
  return sides;
}

/// The sides of the next node behind `branch` that has two or more; empty where there is none.
std::vector<std::int32_t> divisionBehind(const VesselGraph& portal, std::int32_t branch, double inLiverMm) {
  std::vector<std::int32_t> sides = owningSides(portal, branch, inLiverMm);
  while (sides.size() == 1) {
    sides = owningSides(portal, sides.front(), inLiverMm);
  }
  return sides;
}

/// The number that ends a name, else the label.
int segmentNumber(const LabelledMask& structure) {
  const std::size_t digits = structure.name.find_last_not_of("0123456789");
  const std::size_t begin = digits == std::string::npos ? 0 : digits + 1;
  const auto number = begin < structure.name.size() ? parseInteger(structure.name.substr(begin)) : std::nullopt;
  return number && *number >= 1 && *number <= kSegments ? static_cast<int>(*number) : structure.label;
}
}  // namespace

std::string_view textOf(TerritorySource source) {
  switch (source) {
    case TerritorySource::Proposal:
      return "proposal";
    case TerritorySource::Segments:
      return "segments";
    case TerritorySource::Picked:
      break;
  }
  return "picked";
}

TerritoryChoice proposeLeftRight(const VesselGraph& portal) {
  TerritoryChoice choice;
  choice.source = TerritorySource::Proposal;
  if (!portal.mainBifurcation) {
    choice.notes.emplace_back(kNoBifurcation);
    return choice;
  }
  const auto lengthOf = [&](std::int32_t branch) { return portal.branches[at(branch)].inLiverMm; };
  const std::int32_t trunk = portal.sites[at(portal.nodes[at(*portal.mainBifurcation)].site)].branch;
  const double whole = portal.branches[at(trunk)].inLiverMm;
  std::vector<std::int32_t> sides = owningSides(portal, trunk, kSubstantialSide * whole);
  if (sides.size() < 2) {
    choice.notes.emplace_back(kNoBifurcation);
    return choice;
  }
  const auto isRightOf = [&](std::int32_t a, std::int32_t b) {
    return portal.branches[at(a)].centreMm[0] < portal.branches[at(b)].centreMm[0];
  };
  while (true) {
    const auto left = std::max_element(sides.begin(), sides.end(), isRightOf);
    std::iter_swap(left, sides.begin());
    const auto parts = divisionBehind(portal, sides.front(), kSubstantialSide * whole);
    if (lengthOf(sides.front()) <= kMostOfLeft * whole || parts.empty()) {
      break;
    }
    sides.erase(sides.begin());
    sides.insert(sides.end(), parts.begin(), parts.end());
  }
  std::sort(sides.begin() + 1, sides.end());
  choice.picks = {{"left", {sides.front()}}, {"right", {sides.begin() + 1, sides.end()}}};
  const double share = lengthOf(sides.front()) / whole;
  if (share < kUsualLeftLow || share > kMostOfLeft) {
    choice.notes.push_back("The proposed left side has " + formatNumber(100 * share, 0) +
                           " % of the portal branches' length, which is unusual; look at it closely.");
  }
  return choice;
}

Territories territoriesOf(const LiverVoxels& liver, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context) {
  if (choice.picks.empty()) {
    throw UsageError("No branch of the portal vein is picked; pick branches, or give a map of segments 1 to 8.");
  }
  const std::vector<std::int32_t> owners = ownersOfBranches(portal, choice);
  std::vector<Index3> sites;
  std::vector<std::size_t> labels;
  IndexBox box = liver.liver.box();
  for (const VesselSite& site : portal.sites) {
    if (const std::int32_t owner = owners[at(site.branch)]; owner != kOwnsNothing) {
      sites.push_back(site.voxel);
      labels.push_back(at(owner));
      box = enclosing(box, {site.voxel, {1, 1, 1}});
    }
  }
  const std::vector<std::int32_t> nearest = nearestSites(box, liver.geometry.spacing, sites, context);
  Territories made;
  made.geometry = liver.geometry;
  made.source = choice.source;
  made.confirmed = choice.confirmed;
  made.notes = choice.notes;
  for (const TerritoryPick& pick : choice.picks) {
    made.parts.push_back({pick.name, {}});
  }
  made.parts.push_back({std::string(kNotPicked), {}});
  const auto offset = [&](int i, int j, int k) {
    return static_cast<std::size_t>(i - box.first[0]) +
           static_cast<std::size_t>(box.size[0]) *
               (static_cast<std::size_t>(j - box.first[1]) +
                static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k - box.first[2]));
  };
  dealVoxels(
      liver.liver, [&](int i, int j, int k) { return labels[at(nearest[offset(i, j, k)])]; }, made.parts);
  if (made.parts.back().rows.voxels == 0) {
    made.parts.pop_back();
  }
  return made;
}

TerritoryChoice segmentChoice(const SegmentMapFile& map) {
  TerritoryChoice choice;
  choice.source = TerritorySource::Segments;
  choice.segments = map;
  choice.confirmed = true;
  return choice;
}

Territories segmentTerritories(const LiverVoxels& liver, const Segmentation& segments) {
  if (segments.geometry.cornerDistance(liver.geometry) > kSameGridMm) {
    throw InputError(segments.source + " (" + segments.geometry.describe() + ") is not on the grid of the case (" +
                     liver.geometry.describe() + "); choose a map of this CT.");
  }
  std::vector<std::vector<const Mask*>> masks(kSegments);
  for (const LabelledMask& structure : segments.structures) {
    const int number = segmentNumber(structure);
    if (number >= 1 && number <= kSegments && structure.mask) {
      masks[static_cast<std::size_t>(number) - 1].push_back(structure.mask.get());
    }
  }
  Territories made;
  made.geometry = liver.geometry;
  made.source = TerritorySource::Segments;
  made.confirmed = true;
  made.notes = segments.notes;
  for (int n = 1; n <= kSegments; ++n) {
    made.parts.push_back({"segment " + std::to_string(n), {}});
  }
  made.parts.push_back({"unassigned", {}});
  dealVoxels(
      liver.liver,
      [&](int i, int j, int k) {
        std::size_t n = 0;
        while (n < masks.size() &&
               std::none_of(masks[n].begin(), masks[n].end(), [&](const Mask* mask) { return mask->at(i, j, k); })) {
          ++n;
        }
        return n;
      },
      made.parts);
  std::erase_if(made.parts, [](const Territory& part) { return part.rows.voxels == 0; });
  if (made.parts.empty() || made.parts.front().name == "unassigned") {
    throw InputError(segments.source + " has no label 1 to 8 inside the liver; choose a map of liver segments.");
  }
  return made;
}

namespace {
/// L: all parts together, its runs as they were before they were dealt.
VoxelRows liverOf(const Territories& territories) {
  std::vector<RowRun> runs;
  for (const Territory& part : territories.parts) {
    runs.insert(runs.end(), part.rows.runs.begin(), part.rows.runs.end());
  }
  std::sort(runs.begin(), runs.end(),
            [](const RowRun& a, const RowRun& b) { return std::tie(a.k, a.j, a.i) < std::tie(b.k, b.j, b.i); });
  VoxelRows liver;
  for (const RowRun& run : runs) {
    append(liver, run);
  }
  return liver;
}
}  // namespace

std::vector<TerritoryVolume> volumesOf(const Territories& territories, const ResectionPlan& plan) {
  const std::vector<ImageResection> resections = toImage(plan, territories.geometry);
  const std::optional<SidePieces> sides =
      plan.islands.empty() ? std::nullopt : switchedSides(liverOf(territories), territories.geometry, plan, resections);
  const double voxelMl = territories.geometry.voxelVolumeMm3() * kMlPerMm3;
  std::vector<TerritoryVolume> volumes;
  volumes.reserve(territories.parts.size());
  for (const Territory& part : territories.parts) {
    std::int64_t resected = resectedUnits(part.rows, territories.geometry.spacing, resections);
    resected += sides ? sides->switchedUnits(part.rows, resections) : 0;
    const std::int64_t remnant = (static_cast<std::int64_t>(part.rows.voxels) << 32) - resected;
    volumes.push_back({part.name, static_cast<double>(part.rows.voxels) * voxelMl,
                       static_cast<double>(resected) / kUnitsPerVoxel * voxelMl,
                       static_cast<double>(remnant) / kUnitsPerVoxel * voxelMl});
  }
  return volumes;
}

}  // namespace glisson
