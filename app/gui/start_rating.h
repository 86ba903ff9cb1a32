#pragma once
// Purpose: what the blind rating of the menu and of the Compare workspace does: makes some models of one structure of the open case
// in a job and opens the window in which they are rated.

#include <QString>
#include <functional>

#include "app/jobs/job_runner.h"
#include "planning/case/case.h"
#include "reconstruction/evaluation/rated_recipes.h"

class QWidget;

namespace glisson {

/// The models of `recipes` (ratedRecipes), among the other vessels and tumours that have a surface. The window is a child of
/// `parent`, which outlives the job; sessions are kept in `folder`. `fail` is called where no models can be made.
void startRating(JobRunner& jobs, const Case& content, const Structure& structure, std::vector<RatedRecipe> recipes,
                 const ExperimentOptions& options, const QString& folder, QWidget& parent,
                 std::function<void(const std::exception&)> fail);

}  // namespace glisson
