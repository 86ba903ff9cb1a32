#include "reconstruction/evaluation/rating_csv.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "reconstruction/csv.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

using Cells = std::vector<std::string>;

enum RatingColumn : std::size_t {
  kName,
  kPlace,
  kModel,
  kMethod,
  kSubject,
  kCounts,
  kValue,
  kSeconds,
  kSeed,
  kRepeats,
  kQuestion,
  kGrade,
  kColumns
};
constexpr std::array<const char*, kColumns> kNames{"rater",  "showing", "model", "method",  "subject",  "counts",
                                                   "rating", "seconds", "seed",  "repeats", "question", "grade"};

/// Reads lines of cells as a session and says which line is at fault.
class SessionReader {
 public:
  SessionReader(std::vector<Cells> lines, std::string_view file) : lines_(std::move(lines)), file_(file) {}

  RatingSession session() {
    addGrades();
    checkColumns();
    RatingSession read;
    read.study = study();
    std::set<std::string_view> names;
    for (std::size_t first = 1; first < lines_.size(); first += showings_) {
      const std::string& name = lines_[first][kName];
      if (name.empty() || !names.insert(name).second) {
        refuse(first, "starts a rater whose name is missing or was there before");
      }
      read.raters.push_back({name, ratings(read, first)});
    }
    return read;
  }

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& fact) const {
    throw InputError("\"" + file_ + "\" is no session of a blind rating (line " + std::to_string(line + 1) + " " + fact +
                     "); choose a CSV file that a rating was kept in.");
  }

  /// To a file of an earlier version.
  void addGrades() {
    if (!lines_.empty() && lines_.front() == Cells(kNames.begin(), kNames.begin() + kGrade)) {
      lines_.front().emplace_back(kNames[kGrade]);
      std::for_each(lines_.begin() + 1, lines_.end(), [](Cells& cells) { cells.emplace_back(); });
    }
  }

  void checkColumns() const {
    if (lines_.empty() || lines_.front() != Cells(kNames.begin(), kNames.end())) {
      refuse(0, "does not name its columns");
    }
    for (std::size_t n = 1; n < lines_.size(); ++n) {
      if (lines_[n].size() != kColumns) {
        refuse(n, "has another number of cells");
      }
    }
    if (lines_.size() < 2) {
      refuse(1, "is missing");
    }
  }

  [[nodiscard]] long long integer(std::size_t line, RatingColumn column, long long most) const {
    const std::optional<long long> value = parseInteger(lines_[line][column]);
    if (!value || *value < 0 || *value > most) {
      refuse(line, "holds no such number as " + std::string(kNames[column]));
    }
    return *value;
  }

  /// The models are those of the first rater, whose lines tell them all.
  RatingStudy study() {
    const auto seed = integer(1, kSeed, std::numeric_limits<std::uint32_t>::max());
    std::vector<RatedModel> models;
    std::set<std::string_view> ids;
    std::size_t end = 1;
    for (; end < lines_.size() && lines_[end][kName] == lines_[1][kName]; ++end) {
      const Cells& cells = lines_[end];
      if (cells[kCounts] == "1") {
        if (cells[kModel].empty() || !ids.insert(cells[kModel]).second) {
          refuse(end, "names no model, or one that was there before");
        }
        models.push_back({cells[kModel], cells[kMethod], cells[kSubject], cells[kGrade]});
      }
    }
    showings_ = end - 1;
    if (models.empty()) {
      refuse(1, "starts a rater without models");
    }
    const auto repeats = static_cast<std::size_t>(integer(1, kRepeats, static_cast<long long>(models.size())));
    return ratingStudy(lines_[1][kQuestion], std::move(models), static_cast<std::uint32_t>(seed), repeats);
  }

  std::vector<Rating> ratings(const RatingSession& session, std::size_t first) const {
    const std::vector<Showing> order = showingsFor(session.study, session.raters.size());
    std::vector<Rating> read;
    for (std::size_t n = 0; n < order.size(); ++n) {
      const std::size_t line = first + n;
      if (line >= lines_.size() || lines_[line][kName] != lines_[first][kName]) {
        refuse(line, "is missing, or is another rater's");
      }
      checkShowing(session.study, line, n, order[n]);
      const Cells& cells = lines_[line];
      if (cells[kValue].empty() && cells[kSeconds].empty()) {
        continue;
      }
      const std::optional<double> seconds = parseNumber(cells[kSeconds]);
      const Rating rating{static_cast<int>(integer(line, kValue, kHighestRating)), seconds.value_or(-1)};
      if (!isOfScale(rating)) {
        refuse(line, "holds a rating outside 1 to 5, or no time beside it");
      }
      if (read.size() != n) {
        refuse(line, "holds a rating behind a model that was not rated");
      }
      read.push_back(rating);
    }
    return read;
  }

  void checkShowing(const RatingStudy& study, std::size_t line, std::size_t place, const Showing& showing) const {
    const Cells& cells = lines_[line];
    const RatedModel& model = study.models[showing.model];
    for (const RatingColumn column : {kSeed, kRepeats, kQuestion}) {
      if (cells[column] != lines_[1][column]) {
        refuse(line, "differs from the lines before in " + std::string(kNames[column]));
      }
    }
    const Cells expected{std::to_string(place + 1), model.id, model.method, model.subject, showing.counts ? "1" : "0"};
    if (!std::equal(expected.begin(), expected.end(), cells.begin() + kPlace) || cells[kGrade] != model.grade) {
      refuse(line, "does not hold the model that its seed gives");
    }
  }

  std::vector<Cells> lines_;
  std::string file_;
  std::size_t showings_ = 0;  ///< lines of the first rater
};

}  // namespace

std::string ratingCsv(const RatingSession& session) {
  const RatingStudy& study = session.study;
  std::string csv = csvLine({kNames.begin(), kNames.end()});
  for (std::size_t rater = 0; rater < session.raters.size(); ++rater) {
    const std::vector<Rating>& ratings = session.raters[rater].ratings;
    const std::vector<Showing> order = showingsFor(study, rater);
    for (std::size_t n = 0; n < order.size(); ++n) {
      const RatedModel& model = study.models[order[n].model];
      const bool rated = n < ratings.size();
      csv += csvLine({session.raters[rater].name, std::to_string(n + 1), model.id, model.method, model.subject,
                      order[n].counts ? "1" : "0", rated ? std::to_string(ratings[n].value) : "",
                      rated ? formatExact(ratings[n].seconds) : "", std::to_string(study.seed), std::to_string(study.repeats),
                      study.question, model.grade});
    }
  }
  return csv;
}

RatingSession ratingSessionOfCsv(std::string_view text, std::string_view file) {
  std::optional<std::vector<Cells>> lines = parseCsv(text);
  if (!lines) {
    throw InputError(
        "\"" + std::string(file) +
        "\" is no session of a blind rating (its quotes are not closed); choose a CSV file that a rating was kept in.");
  }
  return SessionReader(std::move(*lines), file).session();
}

}  // namespace glisson
