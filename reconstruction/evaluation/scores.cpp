#include "reconstruction/evaluation/scores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace glisson {

namespace {

double onScale(double value, double least, double greatest) {
  return greatest > least ? (value - least) / (greatest - least) : 0.0;
}

}  // namespace

ObjectiveBounds boundsOf(std::span<const Objectives> models) {
  if (models.empty()) {
    throw std::invalid_argument("boundsOf: no models");
  }
  ObjectiveBounds bounds{models.front(), models.front()};
  for (const Objectives& model : models) {
    bounds.least = {std::min(bounds.least.errorMm, model.errorMm), std::min(bounds.least.triangles, model.triangles)};
    bounds.greatest = {std::max(bounds.greatest.errorMm, model.errorMm), std::max(bounds.greatest.triangles, model.triangles)};
  }
  return bounds;
}

double NormalisedObjectives::score() const { return std::sqrt(error * error + triangles * triangles); }

NormalisedObjectives normalised(const Objectives& model, const ObjectiveBounds& bounds) {
  return {onScale(model.errorMm, bounds.least.errorMm, bounds.greatest.errorMm),
          onScale(model.triangles, bounds.least.triangles, bounds.greatest.triangles)};
}

std::optional<std::size_t> placeOfLeast(std::span<const double> values) {
  const auto least = std::min_element(values.begin(), values.end());
  return least == values.end() ? std::nullopt : std::optional(static_cast<std::size_t>(least - values.begin()));
}

std::optional<std::size_t> placeOfNearest(std::span<const double> values, double wanted) {
  std::vector<double> away(values.size());
  std::transform(values.begin(), values.end(), away.begin(), [&](double value) { return std::abs(value - wanted); });
  return placeOfLeast(away);
}

std::vector<bool> onParetoFront(std::span<const Objectives> models) {
  std::vector<std::size_t> order(models.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return models[a].triangles < models[b].triangles ||
           (models[a].triangles == models[b].triangles && models[a].errorMm < models[b].errorMm);
  });
  // In the order of triangles a model is on the front where its error is below that of all with fewer, or where it is the like of
  // one that is.
  std::vector<bool> front(models.size(), false);
  double leastError = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Objectives& model = models[order[n]];
    const bool likeTheLast = n > 0 && front[order[n - 1]] && model.errorMm == models[order[n - 1]].errorMm &&
                             model.triangles == models[order[n - 1]].triangles;
    front[order[n]] = model.errorMm < leastError || likeTheLast;
    leastError = std::min(leastError, model.errorMm);
  }
  return front;
}

double reductionPercent(double fewer, double more) { return more == 0.0 ? 0.0 : 100.0 * (1.0 - fewer / more); }

}  // namespace glisson
