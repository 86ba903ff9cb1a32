#include "planning/report/decisive_tumour.h"

namespace glisson {

namespace {
double lowerBound(const TumourAssessment& tumour) { return tumour.marginAtLeastMm.value_or(tumour.marginMm.value_or(0.0)); }
}  // namespace

const TumourAssessment* decisiveTumour(const PlanAssessment& assessment) {
  const TumourAssessment* margin = nullptr;
  const TumourAssessment* nearest = nullptr;
  for (const TumourAssessment& tumour : assessment.tumours) {
    // the lower bound decides
    if (tumour.marginMm && (margin == nullptr || lowerBound(tumour) < lowerBound(*margin))) {
      margin = &tumour;
    }
    if (!tumour.marginMm && tumour.distanceMm && (nearest == nullptr || *tumour.distanceMm < *nearest->distanceMm)) {
      nearest = &tumour;
    }
  }
  return margin != nullptr ? margin : nearest;
}

}  // namespace glisson
