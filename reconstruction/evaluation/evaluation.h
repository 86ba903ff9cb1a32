#pragma once
// Purpose: the experiment's result for one label: all models with their measures, and what the formulas of scores.h say of them.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/evaluation/measures.h"
#include "reconstruction/evaluation/recipe.h"
#include "reconstruction/evaluation/scores.h"

namespace glisson {

/// Seconds by stage. A stage that several models share counts in each of them; the time of PSR holds that of the points [3.3].
struct ModelSeconds {
  double sample = 0, solve = 0, extract = 0, decimate = 0, smooth = 0, simplify = 0;
  double measure = 0;  ///< no part of the total
  [[nodiscard]] double total() const { return sample + solve + extract + decimate + smooth + simplify; }
};

/// Failure of a model that the memory did not suffice for: another run may make it.
inline constexpr const char* kNoMemoryForModel = "There is not enough memory for this model; close other programs and try again.";

/// One model as made and measured, or why it could not be.
struct EvaluatedModel {
  ModelRecipe recipe;
  int usedDepth = 0;  ///< PSR families: below recipe.depth where the voxels carry no more; 0 of methods that have none
  std::optional<ModelMeasures> measures;
  std::string failure;  ///< one sentence where there are no measures
  ModelSeconds seconds;
  /// How much the program grew while the model's surface was made; of MCSD, while the sweep's were until this one was measured.
  std::optional<double> peakMemoryMb;

  /// modelName() with the depth that was used; of a failed model, with the one that was asked for.
  [[nodiscard]] std::string name() const;
};

struct ModelScore {
  NormalisedObjectives normalised;
  double score = 0;
  bool pareto = false;       ///< on the front of its own: the published families together, the simplified models, or the others
  bool paretoOfAll = false;  ///< on the front of all models
};

/// Places in `models`. Where a model failed it has no score and takes no part.
struct Evaluation {
  std::vector<EvaluatedModel> models;
  std::vector<std::optional<ModelScore>> scores;  ///< one for each model
  std::optional<ObjectiveBounds> bounds;          ///< of the published models
  bool publishedComplete = false;                 ///< each published model is there or failed: scores and choices are final
  std::optional<std::size_t> bestPsr;             ///< P_best [eq. 11]
  std::optional<std::size_t> bestMcsd;            ///< C_best [eq. 11]
  std::optional<std::size_t> bestOfAll;           ///< M_best [eq. 12]: of the published models
  std::optional<std::size_t> mostSimilar;         ///< C_sim [eq. 14]: of trimmed K
  std::optional<std::size_t> bestSimplified;      ///< least score of the simplified models
  std::optional<std::size_t> bestOther;           ///< least score of the other methods' models

  [[nodiscard]] std::size_t failed() const;
  /// Null where the model has no score, or further models may change it.
  [[nodiscard]] const ModelScore* finalScore(std::size_t place) const;
};

/// Scores all models that have measures. Where no published model has any, nothing is scored.
Evaluation evaluated(std::vector<EvaluatedModel> models);

}  // namespace glisson
