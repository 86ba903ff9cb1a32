#include "app/gui/lab_experiment.h"

#include <algorithm>
#include <mutex>

#include "reconstruction/evaluation/experiment.h"

namespace glisson {

namespace {
constexpr int kLookMs = 100;
}

/// Where the job's threads leave their models; outlives whoever waits for them.
struct LabExperiment::Arrived {
  std::mutex mutex;
  std::vector<EvaluatedModel> models;
};

LabExperiment::LabExperiment(JobRunner& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {
  look_.setInterval(kLookMs);
  connect(&look_, &QTimer::timeout, this, &LabExperiment::takeArrived);
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId id) {
    if (id == job_) {
      takeArrived();
      look_.stop();
      job_ = 0;
      emit changed();
    }
  });
}

void LabExperiment::setSubject(std::shared_ptr<const lab::LabSubject> subject, const ExperimentOptions& options) {
  cancel();
  arrived_.reset();
  subject_ = std::move(subject);
  options_ = options;
  evaluation_ = {};
  emit changed();
}

std::vector<ModelRecipe> LabExperiment::missing(const std::vector<ModelFamily>& families) const {
  std::vector<ModelRecipe> recipes = allRecipes();
  std::erase_if(recipes, [&](const ModelRecipe& recipe) {
    return placeOf(recipe).has_value() || std::ranges::find(families, recipe.family) == families.end();
  });
  return recipes;
}

void LabExperiment::run(const std::vector<ModelFamily>& families, const QString& title) {
  const std::vector<ModelRecipe> recipes = missing(families);
  if (subject_ == nullptr || running() || recipes.empty()) {
    return;
  }
  arrived_ = std::make_shared<Arrived>();
  wanted_ = recipes.size();
  JobRequest request{.key = "lab/experiment", .title = title, .heavy = true};
  request.process = [subject = subject_, options = options_, recipes, arrived = arrived_](const ExecutionContext& context) {
    const EvaluationReference& reference = subject->reference(context.range(0.0, 0.05));
    const auto visit = [&](std::size_t /*place*/, EvaluatedModel model) {
      model.peakMemoryMb.reset();  // the window's other work is in it
      const std::lock_guard lock(arrived->mutex);
      arrived->models.push_back(std::move(model));
    };
    makeModels(subject->mask(), subject->geometry(), reference, recipes, options, visit, context.range(0.05, 1.0));
  };
  request.fail = [this](const std::exception& error) { emit failed(messageOf(error)); };
  job_ = jobs_.submit(std::move(request));
  look_.start();
  emit changed();
}

void LabExperiment::cancel() {
  if (running()) {
    jobs_.cancel(job_);
  }
}

void LabExperiment::takeArrived() {
  std::vector<EvaluatedModel> models;
  if (arrived_ != nullptr) {
    const std::lock_guard lock(arrived_->mutex);
    models.swap(arrived_->models);
  }
  if (models.empty()) {
    return;
  }
  models.insert(models.end(), evaluation_.models.begin(), evaluation_.models.end());
  const std::vector<ModelRecipe> order = allRecipes();
  std::ranges::sort(models, {},
                    [&](const EvaluatedModel& model) { return std::ranges::find(order, model.recipe) - order.begin(); });
  evaluation_ = evaluated(std::move(models));
  emit changed();
}

std::optional<std::size_t> LabExperiment::placeOf(const ModelRecipe& recipe) const {
  const auto found = std::ranges::find(evaluation_.models, recipe, &EvaluatedModel::recipe);
  return found == evaluation_.models.end() ? std::nullopt
                                           : std::optional(static_cast<std::size_t>(found - evaluation_.models.begin()));
}

}  // namespace glisson
