#pragma once
// Purpose: the models of one structure by all methods that were asked for, made in one background job; each is there as soon as it
// is done. What a cancelled job has made stays. UI thread only.

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/job_runner.h"
#include "app/lab/lab_subject.h"
#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

class LabExperiment : public QObject {
  Q_OBJECT
 public:
  explicit LabExperiment(JobRunner& jobs, QObject* parent = nullptr);

  /// Forgets all models and stops what runs. Null: nothing to compare.
  void setSubject(std::shared_ptr<const lab::LabSubject> subject, const ExperimentOptions& options);
  [[nodiscard]] const std::shared_ptr<const lab::LabSubject>& subject() const { return subject_; }
  [[nodiscard]] const ExperimentOptions& options() const { return options_; }

  /// Makes the models of these families that are not there yet.
  void run(const std::vector<ModelFamily>& families, const QString& title);
  void cancel();
  [[nodiscard]] bool running() const { return job_ != 0; }
  /// Models that the job was started for.
  [[nodiscard]] std::size_t wanted() const { return wanted_; }
  /// Recipes of these families without a model.
  [[nodiscard]] std::vector<ModelRecipe> missing(const std::vector<ModelFamily>& families) const;

  /// The models so far, in the order of allRecipes().
  [[nodiscard]] const Evaluation& evaluation() const { return evaluation_; }
  [[nodiscard]] std::optional<std::size_t> placeOf(const ModelRecipe& recipe) const;

 signals:
  void changed();  ///< models have come or gone, or the job has started or ended
  void failed(const QString& sentence);

 private:
  struct Arrived;
  void takeArrived();

  JobRunner& jobs_;
  std::shared_ptr<const lab::LabSubject> subject_;
  ExperimentOptions options_;
  Evaluation evaluation_;
  std::shared_ptr<Arrived> arrived_;
  QTimer look_;
  JobId job_ = 0;
  std::size_t wanted_ = 0;
};

}  // namespace glisson
