#pragma once
// Purpose: one of the two models that stand side by side: its surface, then its error colours, then (where nobody has measured it
// yet) its numbers, each from a job of its own, so that what is ready is seen. The newest choice replaces those before. UI thread
// only.

#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "app/jobs/job_runner.h"
#include "app/lab/lab_subject.h"
#include "reconstruction/evaluation/evaluation.h"
#include "viewer/surface_view.h"

namespace glisson {

class LabSide : public QObject {
  Q_OBJECT
 public:
  /// `letter`: "A" or "B".
  LabSide(JobRunner& jobs, QString letter, QObject* parent);

  [[nodiscard]] const QString& letter() const { return letter_; }
  /// Shows nothing from now on. Null: nothing can be shown.
  void setSubject(std::shared_ptr<const lab::LabSubject> subject, const ExperimentOptions& options);
  /// `measured`: its numbers are known already.
  void show(const ModelRecipe& recipe, bool measured);

  [[nodiscard]] const std::optional<ModelRecipe>& recipe() const { return recipe_; }
  /// The surface of the recipe, or the one before it while it is made.
  [[nodiscard]] const ShownSurface& surface() const { return surface_; }
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }
  /// Of the vertices' distances, mm; nothing before the colours are there.
  [[nodiscard]] std::optional<double> p95Mm() const { return p95Mm_; }
  /// What was made and measured here: without measures as long as they are computed, or known from elsewhere.
  [[nodiscard]] const std::optional<EvaluatedModel>& model() const { return model_; }
  /// The surface shown is not yet that of the recipe. Told by changed() only where it lasts: what stands there stays until then.
  [[nodiscard]] bool pending() const { return pending_; }
  /// The error colours of the surface, or its numbers, are being computed.
  [[nodiscard]] bool unfinished() const { return running_[1] != 0 || running_[2] != 0; }

 signals:
  void changed();
  void failed(const QString& sentence);

 private:
  struct Made;
  /// On a worker.
  static Made make(const lab::LabSubject& subject, const ModelRecipe& recipe, const ExperimentOptions& options,
                   const ExecutionContext& context);
  void showNothing();
  void take(const Made& made, bool measured);
  void colour();
  void measure();
  [[nodiscard]] JobRequest request(const char* stage, const QString& title);

  JobRunner& jobs_;
  QString letter_;
  std::shared_ptr<const lab::LabSubject> subject_;
  ExperimentOptions options_;
  std::optional<ModelRecipe> recipe_;
  ShownSurface surface_;
  std::shared_ptr<const Reconstruction> reconstruction_;
  std::optional<double> p95Mm_;
  std::optional<EvaluatedModel> model_;
  bool pending_ = false;
  QTimer late_;                     ///< until a model that is being made is worth telling
  std::array<JobId, 3> running_{};  ///< surface, colours, numbers
};

}  // namespace glisson
