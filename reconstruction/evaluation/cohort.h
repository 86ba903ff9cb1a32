#pragma once
// Purpose: what the experiments of several patients say together [Palomar 2016, 4.1 to 4.3, Tables 2, 3 and 5]: mean and spread of
// each depth, how often each is the best, and how many triangles the best PSR saves. Pure arithmetic on numbers, no meshes. Units
// in the names.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

/// What a cohort takes of one model.
struct ModelFigures {
  std::string id = {};  ///< modelId()
  double triangles = 0;
  double meanErrorMm = 0;  ///< paper error
  double score = 0;
  double gaussianCurvaturePerMm2 = 0;  ///< trimmed: what decides which model is similar
  double seconds = 0;
};

/// The models of one patient that the paper's tables are about.
struct PatientFigures {
  std::map<int, ModelFigures> psr;              ///< by depth, those that could be made
  std::optional<int> bestDepth;                 ///< of P_best [eq. 11]; a key of psr
  std::optional<ModelFigures> mostSimilarMcsd;  ///< C_sim [eq. 14]
  std::optional<ModelFigures> bestMcsd;         ///< C_best [eq. 11]
  std::optional<ModelFigures> bestSimplified;
  std::vector<ModelFigures> others;   ///< of the listed methods, those that could be made, in the order of allRecipes()
  std::vector<std::string> failures;  ///< "PSR d=8: why", a sentence for each model that could not be made

  [[nodiscard]] std::optional<ModelFigures> bestPsr() const;
  /// Whether M_best [eq. 12] is P_best; it is where both score the same.
  [[nodiscard]] bool psrIsBestOfAll() const;
  /// Of `others`, by its id.
  [[nodiscard]] std::optional<ModelFigures> other(const std::string& id) const;
};
PatientFigures figuresOf(const Evaluation& evaluation);

/// How a model stands to another one of the same patient.
struct Comparison {
  double fewerTrianglesPercent = 0;  ///< reductionPercent(); below 0 where it has more
  double meanErrorDifferenceMm = 0;  ///< its error less the other one's
};
/// Nothing where one of the two is missing.
std::optional<Comparison> compared(const std::optional<ModelFigures>& model, const std::optional<ModelFigures>& against);
/// Best PSR against most similar MCSD: the reduction at equal smoothness.
std::optional<Comparison> againstMostSimilar(const PatientFigures& patient);
std::optional<Comparison> againstBestMcsd(const PatientFigures& patient);
/// Best simplified model against best PSR.
std::optional<Comparison> simplifiedAgainstPsr(const PatientFigures& patient);

/// One number over the patients that have it.
struct Distribution {
  std::size_t patients = 0;
  double mean = 0;
  std::optional<double> deviation;  ///< of a sample (n - 1): nothing of fewer than two
  double least = 0;
  double greatest = 0;
};
/// All zero where there are no values.
Distribution distributionOf(std::span<const double> values);

struct ModelDistributions {
  Distribution score, meanErrorMm, triangles, gaussianCurvaturePerMm2, seconds;
};
struct DepthDistributions {
  int depth = 0;
  ModelDistributions models;
  std::size_t bestOfPsr = 0;  ///< patients whose P_best has this depth
  std::size_t bestOfAll = 0;  ///< and whose M_best it is
};
/// A listed method's variant; scored on the scale of the published models, which it is no part of.
struct OtherDistributions {
  std::string id;    ///< modelId()
  std::string name;  ///< modelName()
  ModelDistributions models;
};
struct ComparisonDistributions {
  Distribution fewerTrianglesPercent, meanErrorDifferenceMm;
};

struct CohortStatistics {
  std::size_t patients = 0;
  std::vector<DepthDistributions> depths;  ///< every depth that some patient has, ascending
  std::size_t mcsdBestOfAll = 0;           ///< patients whose M_best is an MCSD model
  ModelDistributions bestPsr, mostSimilarMcsd, bestMcsd, bestSimplified;
  std::vector<OtherDistributions> others;  ///< those that some patient has, in the order of allRecipes()
  ComparisonDistributions againstMostSimilar, againstBestMcsd, simplifiedAgainstPsr;
};
/// Means are over patients, each patient counting once: the mean of reductions, not the reduction of means.
CohortStatistics statisticsOf(std::span<const PatientFigures> patients);

}  // namespace glisson
