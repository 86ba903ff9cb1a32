#include "reconstruction/evaluation/rating_tests_csv.h"

#include <algorithm>

#include "reconstruction/csv.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

using Cells = std::vector<std::string>;

void append(Cells& cells, const TTestResult& result) {
  if (const auto* absence = std::get_if<NoTTest>(&result)) {
    cells.insert(cells.end(), {"", "", "", "", *absence == NoTTest::TooFew ? "too_few" : "no_spread"});
    return;
  }
  const TTest& test = std::get<TTest>(result);
  for (const double number : {test.meanDifference, test.t, test.degreesOfFreedom, test.p}) {
    cells.push_back(formatExact(number));
  }
  cells.emplace_back();
}

void append(Cells& cells, const MethodRatings& method) {
  cells.push_back(std::to_string(method.ratings.size()));
  cells.push_back(formatExact(method.spread.mean));
  cells.push_back(method.ratings.size() > 1 ? formatExact(method.spread.deviation) : "");
}

}  // namespace

std::string ratingTestsCsv(const RatingResults& results) {
  std::string csv = csvLine({"first", "second", "test", "rater", "mean_difference", "t", "degrees_of_freedom", "p", "no_test",
                             "ratings_first", "mean_first", "sd_first", "ratings_second", "mean_second", "sd_second"});
  for (const MethodComparison& comparison : results.comparisons) {
    const auto add = [&](const char* test, const std::string& rater, const TTestResult& result) {
      Cells cells{comparison.first, comparison.second, test, rater};
      append(cells, result);
      for (const std::string& name : {comparison.first, comparison.second}) {
        append(cells, *std::ranges::find(results.methods, name, &MethodRatings::method));
      }
      csv += csvLine(cells);
    };
    add("welch", "", comparison.pooled);
    add("paired_over_raters", "", comparison.overRaters);
    for (const RaterTest& rater : comparison.withinRaters) {
      add(comparison.grades.empty() ? "paired_over_patients" : "paired_over_grades", rater.rater, rater.test);
    }
  }
  return csv;
}

}  // namespace glisson
