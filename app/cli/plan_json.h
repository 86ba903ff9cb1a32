#pragma once
// Purpose: what `plan --json` says of a plan and its model beside the assessment. Lengths in mm, volumes in mL, world LPS;
// resections and planes as the plan has them, planes counted from 1.

#include <nlohmann/json.hpp>

#include "planning/case/case.h"

namespace glisson::cli {

/// [{resection, plane, originMm, normal}]: a point of each plane, and its unit normal to the resected side.
nlohmann::ordered_json planesJson(const ResectionPlan& plan);
/// The bent ones among them, with all that their bends are.
nlohmann::ordered_json bendsJson(const ResectionPlan& plan);
nlohmann::ordered_json measuresJson(const std::vector<Measure>& measures);
/// How each structure's surface was made, its SHA-256, and who accepted it; null where there is none.
nlohmann::ordered_json structuresJson(const LiverModel& model);

}  // namespace glisson::cli
