#pragma once
// Purpose: which part of the liver belongs to which branches of the portal vein, or to which segment of a map. Estimates: the true
// watersheds follow the flow, these follow the nearest labelled centreline.
// Units: voxels and mL of L; every voxel of L belongs to exactly one part, so the parts' voxels add up to |L|.
// Rule: a voxel belongs to the branch whose centreline voxel is nearest, centre to centre in mm, among all supplying branches; what
// belongs to branches that no pick names is "not picked". Trunk, splenic and mesenteric branches own nothing. The proposal divides
// all of L among left and right: there the nearest among their branches decides.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planning/case/territory_marks.h"
#include "planning/territories/vessel_graph.h"
#include "planning/volumetry/voxel_rows.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/image/segmentation.h"

namespace glisson {

enum class TerritorySource : std::uint8_t { Proposal, Picked, Segments };
/// "proposal", "picked", "segments".
std::string_view textOf(TerritorySource source);

/// A name for branches of the portal vein: they and all behind them, up to branches that another pick names.
struct TerritoryPick {
  std::string name;
  std::vector<std::int32_t> branches;
};

struct TerritoryChoice {
  std::vector<TerritoryPick> picks;
  TerritorySource source = TerritorySource::Picked;
  std::optional<SegmentMapFile> segments{};  ///< of source Segments: the map that is read; no picks then
  bool confirmed = false;                    ///< a person has looked at it; a proposal begins unconfirmed
  std::vector<std::string> notes;            ///< why a proposal is empty, or is to be looked at closely
};

/// Left and right from the main bifurcation; unconfirmed. The left side is the branch that supplies farthest to the patient's left;
/// where that is more than half of the liver, the division lies farther on (the right posterior branch leaves first), and is looked
/// for there. No picks, with a note, where the label has no main bifurcation.
TerritoryChoice proposeLeftRight(const VesselGraph& portal);

/// Confirmed: whoever names a map has made or seen it.
TerritoryChoice segmentChoice(const SegmentMapFile& map);

inline constexpr std::string_view kNotPicked = "not picked";

struct Territory {
  std::string name;
  VoxelRows rows;
};

struct Territories {
  ImageGeometry geometry;
  /// In the order of the picks or by number; last "not picked", or "unassigned" where a map leaves voxels out, if there are any.
  std::vector<Territory> parts;
  TerritorySource source = TerritorySource::Picked;
  bool confirmed = false;
  std::vector<std::string> notes;
};

/// Throws UsageError where a pick names a branch that is not there, twice, or owns nothing, and where there are no picks. Polls
/// cancel.
Territories territoriesOf(const LiverVoxels& liver, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context = {});

/// A map of segments 1 to 8, by the number at the end of a structure's name, else by its label. Voxels of L in none are
/// "unassigned"; of overlapping ones the first has the voxel. Throws InputError where the map is on another grid or has no such
/// label inside the liver.
Territories segmentTerritories(const LiverVoxels& liver, const Segmentation& segments);

struct TerritoryVolume {
  std::string name;
  double volumeMl = 0;
  double resectedMl = 0;
  double remnantMl = 0;
};
/// How much of each part a plan takes, by exact fractions of voxels, islands where the plan gives them. Throws PlanningError where
/// a plane is not finite.
std::vector<TerritoryVolume> volumesOf(const Territories& territories, const ResectionPlan& plan);

}  // namespace glisson
