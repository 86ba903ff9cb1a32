#include "planning/resection/plan_cells.h"

#include <utility>

#include "reconstruction/errors.h"

namespace glisson {

std::vector<PlanCell> cellsOf(const ResectionPlan& plan) {
  if (hasBends(plan)) {
    throw PlanningError("The plan has a bent plane, whose sides are no convex parts; flatten it first.");
  }
  std::vector<PlanCell> resected;
  std::vector<PlanCell> remnant{{}};
  for (const Resection& resection : plan.resections) {
    if (resection.planes.empty()) {
      continue;
    }
    std::vector<PlanCell> left;
    for (PlanCell& cell : remnant) {
      // Cut by one plane after the other: what is outside is remnant, what is inside of all is resected.
      for (const HalfSpace& plane : resection.planes) {
        PlanCell outside = cell;
        outside.bounds.push_back(flipped(plane));
        left.push_back(std::move(outside));
        cell.bounds.push_back(plane);
      }
      cell.side = PlanSide::Resected;
      resected.push_back(std::move(cell));
    }
    remnant = std::move(left);
  }
  resected.insert(resected.end(), remnant.begin(), remnant.end());
  return resected;
}

}  // namespace glisson
