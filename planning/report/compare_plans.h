#pragma once
// Purpose: several plans of one case in one table, and what differs between two of them. Nothing here says which plan is best: the
// smallest and the largest value of a row are marked, and that is all. Units: in the rows' ids.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planning/resection/resection_plan.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

/// A plan with its numbers. Both outlive the comparison.
struct AssessedPlan {
  const ResectionPlan& plan;
  const PlanAssessment& assessment;
};

struct ComparedRow {
  std::string_view id;                        ///< "functionalRemnantMl"
  std::vector<std::optional<double>> values;  ///< by plan; nothing where the plan has no such number
  std::vector<bool> smallest;                 ///< by plan; no marks where fewer than two values are known or all are the same
  std::vector<bool> largest;
};

struct PlanComparison {
  std::vector<std::string> names;
  std::vector<ComparedRow> rows;
};

/// Of all resections together.
double cutAreaMm2(const PlanAssessment& assessment);

/// Rows: resections, planes, safetyMarginMm, resectedMl, remnantMl, functionalRemnantMl, flrPercent, cutAreaMm2, tumoursRemoved,
/// tumoursCut, tumoursLeft, leastMarginMm (the smallest lower bound among tumours that are removed or cut), vesselsCrossed (of 3 mm
/// and more). Throws PlanningError with fewer than two or more than four plans.
PlanComparison comparePlans(std::span<const AssessedPlan> plans);

/// One sentence for each thing that differs, planes first; one that says so where nothing does. Values that print alike are alike.
std::vector<std::string> differenceOf(const AssessedPlan& a, const AssessedPlan& b);

/// The `comparison` object of `plan --json`, as text; `differences` may be empty.
std::string toJson(const PlanComparison& comparison, const std::vector<std::string>& differences);

}  // namespace glisson
