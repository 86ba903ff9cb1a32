#pragma once
// Purpose: the tests of a blind rating as CSV, for whoever goes on with them elsewhere. One line for each test of each pair of
// methods; all differences are of the first less the second. Columns: first, second, test (welch, paired_over_raters,
// paired_over_patients, or paired_over_grades where models of one grade are paired), rater (of the last kind; else empty),
// mean_difference, t, degrees_of_freedom, p (two-sided, not corrected for the number of comparisons), no_test (too_few, no_spread;
// then the numbers are empty), and on every line of a pair the numbers of ratings, means and standard deviations of both. '.' is
// the decimal sign, numbers are exact.

#include <string>

#include "reconstruction/evaluation/rating_results.h"

namespace glisson {

/// Without comparisons only the line of columns.
std::string ratingTestsCsv(const RatingResults& results);

}  // namespace glisson
