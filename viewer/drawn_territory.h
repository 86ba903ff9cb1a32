#pragma once
// Purpose: a territory as the 3D view draws it: the portal branches it hangs on, in its colour, with its name beside them; and the
// colours. Frame: mm LPS.
// Colours: any two of them, and each of them and the colours of liver, portal vein, hepatic veins and tumour, are at least 20 apart
// (CIE 1976), for deuteranopes too. Beyond kTerritoryColours they come again: the names tell the territories apart then.

#include <cstddef>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"
#include "reconstruction/image/structure_kind.h"

namespace glisson {

struct DrawnBranch {
  std::vector<Vec3> lineMm;  ///< from node to node
  double radiusMm = 1;       ///< of the tube that is drawn
  bool operator==(const DrawnBranch&) const = default;
};

struct DrawnTerritory {
  std::string name;  ///< UTF-8, as it stands in the view; empty: no name is drawn
  Rgb colour;
  std::vector<DrawnBranch> branches;
  bool operator==(const DrawnTerritory&) const = default;
};

inline constexpr std::size_t kTerritoryColours = 8;
/// By the territory's place in the list.
Rgb territoryColour(std::size_t place);
/// Of branches that belong to no territory.
inline constexpr Rgb kNoTerritoryColour{200, 205, 210};

}  // namespace glisson
