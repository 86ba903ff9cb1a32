#pragma once
// Purpose: which territory each branch of the portal vein belongs to: what territoriesOf() divides the liver by, and what is drawn
// of it.

#include <cstdint>
#include <vector>

#include "planning/territories/territories.h"

namespace glisson {

inline constexpr std::int32_t kOwnsNothing = -1;

/// Per branch of `portal`: the place of its pick, which is its own or the nearest picked branch towards the root;
/// choice.picks.size() where none is ("not picked"); kOwnsNothing for trunk, splenic and mesenteric branches, and for what a
/// proposal leaves aside. Throws UsageError where a pick names a branch that is not there, twice, or owns nothing.
std::vector<std::int32_t> ownersOfBranches(const VesselGraph& portal, const TerritoryChoice& choice);

}  // namespace glisson
