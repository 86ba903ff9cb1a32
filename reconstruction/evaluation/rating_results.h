#pragma once
// Purpose: what the ratings of a session say of the methods [Palomar 2016, 3.4 and 4.4]: box plots, and tests of each pair of
// methods. The paper's Welch test pools all ratings. Those of one rater are not independent, so two paired tests stand beside it:
// one over the raters, each with the mean of his ratings, and one within each rater over the subjects and their grades.

#include <string>
#include <vector>

#include "reconstruction/evaluation/rating.h"
#include "reconstruction/evaluation/statistics.h"
#include "reconstruction/evaluation/t_test.h"

namespace glisson {

struct MethodRatings {
  std::string method;
  std::vector<double> ratings;  ///< ascending
  BoxPlot box;                  ///< its median is medianOf()
  Spread spread;
};

struct RaterTest {
  std::string rater;
  TTestResult test;
};

/// All differences are of the first method less the second.
struct MethodComparison {
  std::string first;
  std::string second;
  TTestResult pooled;                   ///< Welch's test of all ratings, as in the paper
  TTestResult overRaters;               ///< paired: the mean of each rater
  std::vector<RaterTest> withinRaters;  ///< paired: the mean of each subject, and grade, that has models of both methods
  std::vector<std::string> grades;      ///< that have models of both; none where the subjects alone are paired
};

struct RatingResults {
  std::size_t raters = 0;
  double medianSeconds = 0;                   ///< of the ratings that count
  std::vector<MethodRatings> methods;         ///< by name
  std::vector<MethodComparison> comparisons;  ///< each pair once
};

/// Of the raters that have finished, and of ratings that count.
RatingResults ratingResults(const RatingSession& session);

}  // namespace glisson
