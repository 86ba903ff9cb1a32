#include "reconstruction/evaluation/rating.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "reconstruction/errors.h"

namespace glisson {

namespace {

/// 0..count - 1, each equally probable. The standard fixes the engine's numbers but not those of its distributions.
std::size_t below(std::size_t count, std::mt19937_64& random) {
  const std::uint64_t whole = std::mt19937_64::max() - std::mt19937_64::max() % count;
  std::uint64_t drawn = random();
  while (drawn >= whole) {
    drawn = random();
  }
  return static_cast<std::size_t>(drawn % count);
}

}  // namespace

RatingStudy ratingStudy(std::string question, std::vector<RatedModel> models, std::uint32_t seed, std::size_t repeats) {
  std::ranges::sort(models, {}, &RatedModel::id);
  const bool twice = std::ranges::adjacent_find(models, {}, &RatedModel::id) != models.end();
  if (models.empty() || models.front().id.empty() || twice) {
    throw std::invalid_argument("the models of a rating need ids of their own");
  }
  const std::size_t shownAgain = std::min(repeats, models.size());
  return {std::move(question), std::move(models), seed, shownAgain};
}

std::vector<Showing> showingsFor(const RatingStudy& study, std::size_t rater) {
  std::seed_seq seeds{study.seed, static_cast<std::uint32_t>(rater)};
  std::mt19937_64 random(seeds);
  std::vector<std::size_t> order(study.models.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = order.size(); left > 1; --left) {  // Fisher and Yates
    std::swap(order[left - 1], order[below(left, random)]);
  }
  std::vector<Showing> showings;
  for (std::size_t n = 0; n < study.repeats; ++n) {
    showings.push_back({order[n], false});
  }
  for (const std::size_t model : order) {
    showings.push_back({model, true});
  }
  return showings;
}

bool RatingSession::finished(std::size_t rater) const {
  return raters[rater].ratings.size() == study.models.size() + study.repeats;
}

std::size_t RatingSession::finishedRaters() const {
  std::size_t count = 0;
  for (std::size_t rater = 0; rater < raters.size(); ++rater) {
    count += finished(rater) ? 1 : 0;
  }
  return count;
}

std::optional<Showing> RatingSession::next() const {
  if (raters.empty() || finished(raters.size() - 1)) {
    return std::nullopt;
  }
  return showingsFor(study, raters.size() - 1)[raters.back().ratings.size()];
}

RatingSession withRater(RatingSession session, std::string name) {
  if (name.empty()) {
    throw UsageError("A rater needs a name; enter one.");
  }
  if (std::ranges::find(session.raters, name, &Rater::name) != session.raters.end()) {
    throw UsageError("There is a rater \"" + name + "\" already; enter another name.");
  }
  session.raters.push_back({std::move(name), {}});
  return session;
}

RatingSession withRating(RatingSession session, const Rating& rating) {
  if (!session.next()) {
    throw std::logic_error("there is nothing left to rate");
  }
  if (!isOfScale(rating)) {
    throw std::invalid_argument("a rating outside its scale");
  }
  session.raters.back().ratings.push_back(rating);
  return session;
}

bool isOfScale(const Rating& rating) {
  return rating.value >= kLowestRating && rating.value <= kHighestRating && std::isfinite(rating.seconds) && rating.seconds >= 0;
}

}  // namespace glisson
