#include "planning/report/decisive_tumour.h"

#include <limits>
#include <utility>

namespace glisson {

namespace {

/// Which comes first: cut, removed, left; among the same by the lower bound of the margin, or by the distance.
std::pair<int, double> rankOf(const TumourAssessment& tumour) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const double margin = tumour.marginAtLeastMm.value_or(tumour.marginMm.value_or(-kFar));
  switch (tumour.state) {
    case TumourState::Cut:
      return {0, margin};
    case TumourState::Removed:
      return {1, margin};
    case TumourState::Left:
      break;
  }
  return {2, tumour.distanceMm.value_or(kFar)};
}

}  // namespace

TumourCounts tumourCounts(const PlanAssessment& assessment) {
  TumourCounts counts;
  for (const TumourAssessment& tumour : assessment.tumours) {
    if (tumour.isCyst) {
      continue;
    }
    counts.removed += tumour.state == TumourState::Removed ? 1 : 0;
    counts.cut += tumour.state == TumourState::Cut ? 1 : 0;
    counts.left += tumour.state == TumourState::Left ? 1 : 0;
  }
  return counts;
}

const TumourAssessment* decisiveTumour(const PlanAssessment& assessment) {
  const TumourAssessment* first = nullptr;
  for (const TumourAssessment& tumour : assessment.tumours) {
    if (!tumour.isCyst && (first == nullptr || rankOf(tumour) < rankOf(*first))) {
      first = &tumour;
    }
  }
  return first;
}

}  // namespace glisson
