#include "reconstruction/evaluation/rating_results.h"

#include <algorithm>
#include <map>
#include <set>

namespace glisson {

namespace {

/// Subject and grade: what models of two methods are a pair by.
using PairKey = std::pair<std::string, std::string>;
/// One rater's ratings.
using ByPair = std::map<PairKey, std::vector<double>>;
using ByMethod = std::map<std::string, ByPair>;

double meanOf(const ByPair& ratings) {
  std::vector<double> all;
  for (const auto& [key, values] : ratings) {
    all.insert(all.end(), values.begin(), values.end());
  }
  return spreadOf(all).mean;
}

TTestResult testOverPairs(const ByPair& first, const ByPair& second) {
  std::vector<double> a;
  std::vector<double> b;
  for (const auto& [key, values] : first) {
    if (const auto other = second.find(key); other != second.end()) {
      a.push_back(spreadOf(values).mean);
      b.push_back(spreadOf(other->second).mean);
    }
  }
  return pairedTTest(a, b);
}

std::vector<std::string> gradesOf(const ByPair& first, const ByPair& second) {
  std::set<std::string> grades;
  for (const auto& [key, values] : first) {
    if (!key.second.empty() && second.contains(key)) {
      grades.insert(key.second);
    }
  }
  return {grades.begin(), grades.end()};
}

MethodComparison compare(const MethodRatings& first, const MethodRatings& second,
                         const std::vector<std::pair<std::string, ByMethod>>& raters) {
  MethodComparison made{first.method, second.method, welchTTest(first.ratings, second.ratings), NoTTest::TooFew, {}, {}};
  std::vector<double> a;
  std::vector<double> b;
  for (const auto& [name, methods] : raters) {
    a.push_back(meanOf(methods.at(first.method)));
    b.push_back(meanOf(methods.at(second.method)));
    made.withinRaters.push_back({name, testOverPairs(methods.at(first.method), methods.at(second.method))});
    made.grades = gradesOf(methods.at(first.method), methods.at(second.method));
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
        methods[model.method][{model.subject, model.grade}].push_back(rating.value);
        pooled[model.method].push_back(rating.value);
        seconds.push_back(rating.seconds);
      }
    }
  }
  results.raters = session.finishedRaters();
  std::ranges::sort(seconds);
  results.medianSeconds = medianOf(seconds);
  for (auto& [method, ratings] : pooled) {
    std::ranges::sort(ratings);
    results.methods.push_back({method, ratings, boxPlotOf(ratings), spreadOf(ratings)});
    results.methods.back().box.median = medianOf(ratings);
  }
  for (std::size_t first = 0; first < results.methods.size(); ++first) {
    for (std::size_t second = first + 1; second < results.methods.size(); ++second) {
      results.comparisons.push_back(compare(results.methods[first], results.methods[second], raters));
    }
  }
  return results;
}

}  // namespace glisson
