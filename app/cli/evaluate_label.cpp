#include "app/cli/evaluate_label.h"

#include <atomic>
#include <iostream>

#include "app/cli/evaluate_html.h"
#include "app/cli/evaluate_summary.h"
#include "app/cli/model_store.h"
#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/experiment.h"
#include "reconstruction/evaluation/models_csv.h"

namespace glisson::cli {

namespace {

/// What the library refuses of a label is said with the label's name and file.
EvaluationReference referenceOf(const std::string& segmentation, const EvaluatedLabel& label, const ExecutionContext& context) {
  try {
    return {*label.chosen.mask, label.geometry, context};
  } catch (const ReconstructionError& error) {
    throw ReconstructionError(segmentation + ", " + label.chosen.name + ": " + error.what());
  }
}

/// Makes what the store does not have and keeps it there.
class Run {
 public:
  Run(const EvaluatedLabel& label, const EvaluationReference& reference, const ModelStore& store, std::vector<ModelRecipe> recipes)
      : label_(label), reference_(reference), store_(store), recipes_(std::move(recipes)) {}

  void loadKept() {
    for (std::size_t n = 0; n < recipes_.size(); ++n) {
      models_[n] = store_.load(recipes_[n]);
      if (!models_[n]) {
        missing_.push_back(n);
      }
    }
  }
  void makeMissing(const ExecutionContext& context) {
    std::vector<ModelRecipe> recipes;
    for (const std::size_t place : missing_) {
      recipes.push_back(recipes_[place]);
    }
    makeModels(
        *label_.chosen.mask, label_.geometry, reference_, recipes, label_.options,
        [&](std::size_t n, EvaluatedModel model) { take(missing_[n], std::move(model)); }, context);
  }
  /// Once all are there.
  [[nodiscard]] Evaluation result() const {
    std::vector<EvaluatedModel> models;
    for (const std::optional<EvaluatedModel>& model : models_) {
      models.push_back(*model);
    }
    return evaluated(std::move(models));
  }

  [[nodiscard]] std::size_t all() const { return recipes_.size(); }
  [[nodiscard]] std::size_t kept() const { return recipes_.size() - missing_.size(); }
  [[nodiscard]] std::size_t made() const { return made_; }

 private:
  void take(std::size_t place, EvaluatedModel model) {
    if (model.failure != kNoMemoryForModel) {
      store_.save(model);
    }
    models_[place] = std::move(model);
    ++made_;
  }

  const EvaluatedLabel& label_;
  const EvaluationReference& reference_;
  const ModelStore& store_;
  const std::vector<ModelRecipe> recipes_;
  std::vector<std::optional<EvaluatedModel>> models_ = std::vector<std::optional<EvaluatedModel>>(recipes_.size());
  std::vector<std::size_t> missing_;
  std::atomic<std::size_t> made_{0};
};

void writeResults(const std::filesystem::path& folder, const EvaluatedLabel& label, const Evaluation& evaluation) {
  writeFileAtomically(folder / "models.csv", modelsCsv(evaluation, label.voxelVolumeMl));
  writeFileAtomically(folder / "summary.json", textOf(summaryJson(label, evaluation)) + "\n");
  writeFileAtomically(folder / "report.html", evaluationHtml(label, evaluation));
}

}  // namespace

std::filesystem::path withoutSlash(const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(text).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

std::optional<Evaluation> evaluateLabel(const LabelToEvaluate& wanted, const ExecutionContext& context) {
  const Segmentation segmentation = readSegmentation(wanted.segmentation, wanted.reading, context.range(0, 0.05));
  EvaluatedLabel label;
  label.options = wanted.options;
  label.file = withoutSlash(wanted.segmentation).filename().string();
  label.chosen = chooseMask(segmentation, wanted.choice);
  label.geometry = segmentation.geometry;
  const EvaluationReference reference = referenceOf(wanted.segmentation, label, context.range(0.05, 0.1));
  label.points = reference.pointCount();
  label.voxelVolumeMl = reference.voxelVolumeMl();

  ModelStore store(wanted.folder / "models", label);
  store.prepare();
  Run run(label, reference, store, wanted.recipes);
  run.loadKept();
  try {
    run.makeMissing(context.range(0.1, 1.0));
    context.throwIfCancelled();
  } catch (const Cancelled&) {
    complain("interrupted; " + std::to_string(run.kept() + run.made()) + " of " + std::to_string(run.all()) +
             " models are kept in " + store.folder().string() + ", and the same command goes on from there");
    return std::nullopt;
  }
  Evaluation evaluation = run.result();
  if (!evaluation.bounds) {
    throw CheckFailed(wanted.segmentation + ", " + label.chosen.name + ": no model could be made (" +
                      evaluation.models.front().failure + ")");
  }
  writeResults(wanted.folder, label, evaluation);
  std::cout << wanted.folder.string() << ": " << run.all() << " models of " << label.chosen.name << ", " << run.made() << " made, "
            << run.kept() << " kept from before, " << evaluation.failed() << " failed\n"
            << summaryText(evaluation);
  return evaluation;
}

}  // namespace glisson::cli
