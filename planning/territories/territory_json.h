#pragma once
// Purpose: territories and the effect of a plan on the remnant's blood as JSON: `estimates` in `plan --territories --json`.

#include <string>

#include "planning/territories/perfusion.h"
#include "planning/territories/territories.h"
#include "planning/territories/tumour_territories.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

/// Everything `plan --territories` tells besides the assessment.
struct TerritoryReport {
  Territories territories;  ///< no parts where nothing could be proposed
  std::vector<TerritoryVolume> volumes;
  PerfusionEstimate effect;
  std::vector<std::string> notes;
  std::vector<TumourTerritories> tumours;  ///< which of them each tumour lies in
};

/// The object of toJson(assessment) with `estimates` as its last key. camelCase, units in the keys, positions LPS.
std::string toJson(const PlanAssessment& assessment, const TerritoryReport& report, const LiverPerfusion& perfusion);

}  // namespace glisson
