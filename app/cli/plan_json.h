#pragma once
// Purpose: what `plan --json` says of a plan and its model beside the assessment. Lengths in mm, volumes in mL, world LPS;
// resections and planes as the plan has them, planes counted from 1.

#include "planning/case/case.h"
#include "reconstruction/json.h"

namespace glisson::cli {

/// [{resection, plane, originMm, normal}]: a point of each plane, and its unit normal to the resected side.
Json planesJson(const ResectionPlan& plan);
/// The bent ones among them, with all that their bends are.
Json bendsJson(const ResectionPlan& plan);
Json measuresJson(const std::vector<Measure>& measures);
/// How each structure's surface was made, its SHA-256, and who accepted it; null where there is none.
Json structuresJson(const LiverModel& model);

}  // namespace glisson::cli
