#include "planning/case/territory_marks.h"

#include <algorithm>

#include "reconstruction/errors.h"

namespace glisson {

void validate(const TerritoryMarks& marks) {
  const bool tooLong =
      std::ranges::any_of(marks.marks, [](const TerritoryMark& mark) { return mark.pointsMm.size() > kMostMarkPoints; });
  if (marks.marks.size() > kMostTerritoryMarks || tooLong) {
    throw PlanningError("A case holds at most 100 territories of at most 100 points each; point at fewer branches.");
  }
  if (marks.segments && (marks.segments->path.empty() || !marks.marks.empty() || marks.proposed)) {
    throw PlanningError("A map of segments needs its path, and no branches beside it; choose the map again.");
  }
  for (const TerritoryMark& mark : marks.marks) {
    const bool finite = std::ranges::all_of(mark.pointsMm, [](const Vec3& point) { return point.allFinite(); });
    if (mark.name.empty() || mark.pointsMm.empty() || !finite) {
      throw PlanningError("A territory needs a name and points that are finite numbers; point at its branches again.");
    }
  }
}

}  // namespace glisson
