#include "planning/territories/branch_owners.h"

#include <string>

#include "planning/territories/place.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {
/// The pick that names each branch; kOwnsNothing where none does.
std::vector<std::int32_t> namedBranches(const VesselGraph& portal, const TerritoryChoice& choice) {
  std::vector<std::int32_t> picks(portal.branches.size(), kOwnsNothing);
  for (std::size_t p = 0; p < choice.picks.size(); ++p) {
    for (const std::int32_t branch : choice.picks[p].branches) {
      if (branch < 0 || at(branch) >= picks.size()) {
        throw UsageError(choice.picks[p].name + ": the portal vein has no branch " + std::to_string(branch) + "; it has 0 to " +
                         std::to_string(static_cast<long long>(picks.size()) - 1) + ".");
      }
      if (picks[at(branch)] >= 0) {
        throw UsageError(choice.picks[p].name + ": branch " + std::to_string(branch) + " is picked twice; name it once.");
      }
      picks[at(branch)] = static_cast<std::int32_t>(p);
    }
  }
  return picks;
}
}  // namespace

std::vector<std::int32_t> ownersOfBranches(const VesselGraph& portal, const TerritoryChoice& choice) {
  std::vector<std::int32_t> picks = namedBranches(portal, choice);
  std::vector<std::int32_t> owners(picks.size(), kOwnsNothing);
  std::vector<std::uint8_t> owns(choice.picks.size(), 0);
  const bool othersCompete = choice.source != TerritorySource::Proposal;
  for (std::size_t b = 0; b < picks.size(); ++b) {
    const VesselBranch& branch = portal.branches[b];
    picks[b] = picks[b] < 0 && branch.parent >= 0 ? picks[at(branch.parent)] : picks[b];
    if (branch.role != BranchRole::Supplying) {
      continue;
    }
    if (picks[b] >= 0) {
      owners[b] = picks[b];
      owns[at(picks[b])] = 1;
    } else if (othersCompete) {
      owners[b] = static_cast<std::int32_t>(choice.picks.size());
    }
  }
  for (std::size_t p = 0; p < owns.size(); ++p) {
    if (owns[p] == 0) {
      throw UsageError(choice.picks[p].name + " owns nothing of the liver; pick a branch that supplies it.");
    }
  }
  return owners;
}

}  // namespace glisson
