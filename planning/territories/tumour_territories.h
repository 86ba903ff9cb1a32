#pragma once
// Purpose: which territories each tumour lies in. Estimates as the territories are.
// Units: mL and % of the tumour's own voxels. Those outside L lie in none, so the shares may add up to less than the tumour.

#include "planning/case/case.h"
#include "planning/territories/territories.h"

namespace glisson {

struct TerritoryShare {
  std::string name;  ///< of the territory
  double volumeMl = 0;
  double percent = 0;  ///< of the tumour
};

struct TumourTerritories {
  std::string id;
  std::string name;
  std::vector<TerritoryShare> shares;  ///< largest first; none: it lies outside all of them
};

/// One entry for each lesion of the model, in its order. None where there are no territories. Throws PlanningError where a lesion
/// has no mask.
std::vector<TumourTerritories> tumourTerritories(const Case& source, const Territories& territories);

}  // namespace glisson
