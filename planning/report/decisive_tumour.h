#pragma once
// Purpose: which of several tumours the one margin that is shown large belongs to.

#include "planning/volumetry/assessment.h"

namespace glisson {

/// The tumour whose margin decides: the smallest margin of those removed or cut, else the nearest of those left. Null where none
/// is.
const TumourAssessment* decisiveTumour(const PlanAssessment& assessment);

}  // namespace glisson
