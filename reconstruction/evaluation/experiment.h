#pragma once
// Purpose: makes and measures the models of the experiment: recipes in, EvaluatedModels out, as each is done. What several models
// have in common is computed once (sweepMcsd()); several are measured at once.

#include <functional>
#include <span>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

/// Takes model number `place` of the recipes. Called on several threads at once, in no fixed order.
using ModelVisitor = std::function<void(std::size_t place, EvaluatedModel model)>;

/// Every recipe's model is visited once; one that cannot be made or measured carries its failure, and the others go on. PSR and the
/// listed methods are made on all threads, one model after the other, from the mask each time: their seconds are those of a single
/// run. An MCSD model's seconds are of one thread, beside others. Numbers but seconds are the same for any number of threads. What
/// the visitor throws ends the work. Throws ReconstructionError where the label has no surface, UsageError, Cancelled.
void makeModels(const Mask& mask, const ImageGeometry& geometry, const EvaluationReference& reference,
                std::span<const ModelRecipe> recipes, const ExperimentOptions& options, const ModelVisitor& visit,
                const ExecutionContext& context = {});

}  // namespace glisson
