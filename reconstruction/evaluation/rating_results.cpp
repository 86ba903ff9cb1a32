#include "reconstruction/evaluation/rating_results.h"

#include <algorithm>
#include <map>

namespace glisson {

namespace {

/// One rater's ratings by method and subject.
using BySubject = std::map<std::string, std::vector<double>>;
using ByMethod = std::map<std::string, BySubject>;

double meanOf(const BySubject& ratings) {
  std::vector<double> all;
  for (const auto& [subject, values] : ratings) {
    all.insert(all.end(), values.begin(), values.end());
  }
  return spreadOf(all).mean;
}

TTestResult testOverSubjects(const BySubject& first, const BySubject& second) {
  std::vector<double> a;
  std::vector<double> b;
  for (const auto& [subject, values] : first) {
    if (const auto other = second.find(subject); other != second.end()) {
      a.push_back(spreadOf(values).mean);
      b.push_back(spreadOf(other->second).mean);
    }
  }
  return pairedTTest(a, b);
}

MethodComparison compare(const MethodRatings& first, const MethodRatings& second,
                         const std::vector<std::pair<std::string, ByMethod>>& raters) {
  MethodComparison made{first.method, second.method, welchTTest(first.ratings, second.ratings), NoTTest::TooFew, {}};
  std::vector<double> a;
  std::vector<double> b;
  for (const auto& [name, methods] : raters) {
    a.push_back(meanOf(methods.at(first.method)));
    b.push_back(meanOf(methods.at(second.method)));
    made.withinRaters.push_back({name, testOverSubjects(methods.at(first.method), methods.at(second.method))});
  }
  made.overRaters = pairedTTest(a, b);
  return made;
}

}  // namespace

RatingResults ratingResults(const RatingSession& session) {
  RatingResults results;
  std::vector<std::pair<std::string, ByMethod>> raters;
  std::map<std::string, std::vector<double>> pooled;
  std::vector<double> seconds;
  for (std::size_t rater = 0; rater < session.raters.size(); ++rater) {
    if (!session.finished(rater)) {
      continue;
    }
    ByMethod& methods = raters.emplace_back(session.raters[rater].name, ByMethod()).second;
    const std::vector<Showing> order = showingsFor(session.study, rater);
    for (std::size_t n = 0; n < order.size(); ++n) {
      if (order[n].counts) {
        const RatedModel& model = session.study.models[order[n].model];
        const Rating& rating = session.raters[rater].ratings[n];
        methods[model.method][model.subject].push_back(rating.value);
        pooled[model.method].push_back(rating.value);
        seconds.push_back(rating.seconds);
      }
    }
  }
  results.raters = session.finishedRaters();
  std::ranges::sort(seconds);
  results.medianSeconds = boxPlotOf(seconds).median;
  for (auto& [method, ratings] : pooled) {
    std::ranges::sort(ratings);
    results.methods.push_back({method, ratings, boxPlotOf(ratings), spreadOf(ratings)});
  }
  for (std::size_t first = 0; first < results.methods.size(); ++first) {
    for (std::size_t second = first + 1; second < results.methods.size(); ++second) {
      results.comparisons.push_back(compare(results.methods[first], results.methods[second], raters));
    }
  }
  return results;
}

}  // namespace glisson
