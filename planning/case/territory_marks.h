#pragma once
// Purpose: what the user said about the territories, kept with the case. As points, since branches are found anew from the labels:
// a point means the portal branch whose centreline it lies on, with all behind it. Frame: mm LPS.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

struct TerritoryMark {
  std::string name;
  std::vector<Vec3> pointsMm;
  bool operator==(const TerritoryMark&) const = default;
};

/// A map of liver segments where it lies, as a case keeps it: the map itself is read again.
struct SegmentMapFile {
  std::string path;    ///< absolute
  std::string sha256;  ///< of what it said: its segments on the case's grid
  bool operator==(const SegmentMapFile&) const = default;
};

struct TerritoryMarks {
  std::vector<TerritoryMark> marks;  ///< none: nothing was said, left and right are proposed
  bool proposed = false;             ///< left and right as proposed, looked at and confirmed; else the user pointed at branches
  std::optional<SegmentMapFile> segments{};  ///< a map instead of branches; no marks then
  bool operator==(const TerritoryMarks&) const = default;
};

/// More than anybody points at; each point is looked up among the portal branches.
inline constexpr std::size_t kMostTerritoryMarks = 100;
inline constexpr std::size_t kMostMarkPoints = 100;

/// Throws PlanningError where a name or a mark is empty, a point is not finite or there are too many of them, a map of segments has
/// no path, or there are marks beside it.
void validate(const TerritoryMarks& marks);

}  // namespace glisson
