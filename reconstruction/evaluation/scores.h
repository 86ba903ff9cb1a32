#pragma once
// Purpose: which model is best: errors and triangles on one scale, the objective score, the Pareto front, the most similar
// smoothness [Palomar 2016, eq. 9 to 14; method.md 4]. Pure arithmetic on numbers, no meshes.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace glisson {

/// A model in the space of the two objectives; less is better in both.
struct Objectives {
  double errorMm = 0;
  double triangles = 0;
};

/// The extremes over all published models of one label.
struct ObjectiveBounds {
  Objectives least;
  Objectives greatest;
};
/// Throws std::invalid_argument where there are no models.
ObjectiveBounds boundsOf(std::span<const Objectives> models);

/// Each objective on the scale of the bounds [eq. 9]: within 0..1 for the models that the bounds are of. 0 where all models are
/// alike.
struct NormalisedObjectives {
  double error = 0;
  double triangles = 0;
  /// sigma = sqrt(error^2 + triangles^2) [eq. 10].
  [[nodiscard]] double score() const;
};
NormalisedObjectives normalised(const Objectives& model, const ObjectiveBounds& bounds);

/// The place of the least value: arg min [eq. 11, 12]; the first of several. Nothing where there are no values.
std::optional<std::size_t> placeOfLeast(std::span<const double> values);
/// arg min |K(C) - K(P_best)| [eq. 14]; the first of several.
std::optional<std::size_t> placeOfNearest(std::span<const double> values, double wanted);

/// For each model whether it lies on the Pareto front: no other one is as good in both objectives and better in one. Equal models
/// are all on it, or none.
std::vector<bool> onParetoFront(std::span<const Objectives> models);

/// How much less `fewer` is than `more`, in %: 79.7 on average for the triangles of the paper's Table 3 (it says 79.59). 0 where
/// `more` is 0.
double reductionPercent(double fewer, double more);

}  // namespace glisson
