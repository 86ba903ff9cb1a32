#pragma once
// Purpose: what a plan does to its tumours, in short: how many it removes, cuts and leaves, and which of them the one margin that
// is shown large belongs to. Cysts are no tumours here.

#include <cstddef>

#include "planning/volumetry/assessment.h"

namespace glisson {

struct TumourCounts {
  std::size_t removed = 0;
  std::size_t cut = 0;
  std::size_t left = 0;
  [[nodiscard]] std::size_t all() const { return removed + cut + left; }
};
TumourCounts tumourCounts(const PlanAssessment& assessment);

/// The tumour whose margin decides: of those that are cut the one whose lower bound is least (first of all one whose margin is not
/// measured), else the like of those removed, else the nearest of those left, which has no margin. Null where there is no tumour.
const TumourAssessment* decisiveTumour(const PlanAssessment& assessment);

}  // namespace glisson
