#pragma once
// Purpose: from the points kept with a case to the branches of its portal graph, and back.

#include <optional>

#include "planning/case/territory_marks.h"
#include "planning/territories/territories.h"

namespace glisson {

/// The supplying branch whose centreline comes nearest to a point, for what a user clicks; nothing where there is none.
std::optional<std::int32_t> nearestSupplyingBranch(const VesselGraph& portal, const Vec3& pointMm);

/// A site in the middle of each picked branch, or the map of segments. No marks for a proposal that is not confirmed.
TerritoryMarks marksOf(const TerritoryChoice& choice, const VesselGraph& portal);

inline constexpr double kMarkMm = 2;
/// Confirmed, as it was when it was marked; a map of segments is not looked for here. No marks: left and right as proposed,
/// unconfirmed; the same with a note where the marked branches are not there any more (no centreline within kMarkMm of a point, or
/// one branch for two points).
TerritoryChoice choiceOf(const TerritoryMarks& marks, const VesselGraph& portal);

}  // namespace glisson
