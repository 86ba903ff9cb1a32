#pragma once
// Purpose: a plan's numbers as lines of text on stdout.

#include "planning/report/compare_plans.h"
#include "planning/report/flr_card.h"
#include "planning/volumetry/margin_plane.h"
#include "planning/volumetry/tumour_measures.h"

namespace glisson::cli {

void print(const PlanAssessment& assessment);
void printBends(const ResectionPlan& plan);
void print(const FlrCard& card);
void print(const std::vector<TumourMeasures>& measures);
void print(const std::vector<Measure>& measures);
void print(const MarginProposal& proposal);
void print(const PlanComparison& comparison, const std::vector<std::string>& differences);

}  // namespace glisson::cli
