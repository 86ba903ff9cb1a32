#pragma once
// Purpose: what the blind rating of the menu and of the Compare workspace does: makes some models of one structure of the open case
// in a job and opens the window in which they are rated. This file alone decides which models are rated from there.

#include <QString>
#include <functional>

#include "app/jobs/job_runner.h"
#include "planning/case/case.h"
#include "reconstruction/evaluation/recipe.h"

class QWidget;

namespace glisson {

/// PSR of depth 5 to 8 and MCSD of four strengths, as in the experiment (reconstruction/evaluation/recipe.h), among the other
/// vessels and tumours that have a surface. The window is a child of `parent`, which outlives the job; sessions are kept in
/// `folder`. `fail` is called where no models can be made.
void startRating(JobRunner& jobs, const Case& content, const Structure& structure, const ExperimentOptions& options,
                 const QString& folder, QWidget& parent, std::function<void(const std::exception&)> fail);

}  // namespace glisson
