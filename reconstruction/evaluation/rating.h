#pragma once
// Purpose: a blind rating of models by experts, as a value [Palomar 2016, 3.4]. Each rater sees every model in a random order of
// his own and rates it from 1 (very low) to 5 (very high). The first six models are then shown a second time, in the same order,
// before the others: nobody has references at the start, so the second rating counts and the first is kept beside it. A session
// holds the ratings of several raters and can go on at any time (rating_csv.h keeps it in a file).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glisson {

inline constexpr int kLowestRating = 1;
inline constexpr int kHighestRating = 5;
/// Models that the paper's raters could rate again.
inline constexpr std::size_t kPaperRepeats = 6;

struct RatedModel {
  std::string id;       ///< unique among the models
  std::string method;   ///< what is compared; no rater may see it
  std::string subject;  ///< of whom the model is (a pseudonym)
  /// Models of one subject and one grade are pairs between methods. Empty: all of one subject are.
  std::string grade = {};
  bool operator==(const RatedModel&) const = default;
};

struct RatingStudy {
  std::string question;
  std::vector<RatedModel> models;  ///< sorted by id: the order handed in decides nothing
  std::uint32_t seed = 0;          ///< of all random orders
  std::size_t repeats = 0;         ///< at most as many as models
  bool operator==(const RatingStudy&) const = default;
};
/// Throws std::invalid_argument where there is no model, or an id is empty or given twice.
RatingStudy ratingStudy(std::string question, std::vector<RatedModel> models, std::uint32_t seed,
                        std::size_t repeats = kPaperRepeats);

struct Showing {
  std::size_t model = 0;  ///< place in RatingStudy::models
  bool counts = true;     ///< false: the model is shown again, and that rating counts
  bool operator==(const Showing&) const = default;
};
/// What rater number `rater` is shown, in order: the same on every platform. An order is a permutation of all models, each equally
/// probable.
std::vector<Showing> showingsFor(const RatingStudy& study, std::size_t rater);

struct Rating {
  int value = 0;       ///< kLowestRating..kHighestRating
  double seconds = 0;  ///< from the showing to the rating, pauses left out
  bool operator==(const Rating&) const = default;
};

struct Rater {
  std::string name;
  std::vector<Rating> ratings;  ///< of the first showings, in order
  bool operator==(const Rater&) const = default;
};

struct RatingSession {
  RatingStudy study;
  std::vector<Rater> raters;  ///< the last one is rating, or has finished; earlier ones may have left before their end
  bool operator==(const RatingSession&) const = default;

  /// Whether that rater has rated all showings.
  [[nodiscard]] bool finished(std::size_t rater) const;
  [[nodiscard]] std::size_t finishedRaters() const;
  /// The last rater's next one; nothing where there is no rater or nothing left to rate.
  [[nodiscard]] std::optional<Showing> next() const;
};

/// The session with a further rater; one who has not finished before him is thereby left out. Throws UsageError where there is one
/// of that name or the name is empty.
RatingSession withRater(RatingSession session, std::string name);
/// The session with next() rated. Throws std::invalid_argument where the value is none of the scale or the time no number of
/// seconds, std::logic_error where there is nothing to rate.
RatingSession withRating(RatingSession session, const Rating& rating);

/// Whether a rating can be such a one.
bool isOfScale(const Rating& rating);

}  // namespace glisson
