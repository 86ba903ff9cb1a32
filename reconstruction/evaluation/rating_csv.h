#pragma once
// Purpose: a rating session as a CSV file and back: the file that it is kept in while it goes on, and the one that is evaluated
// elsewhere. One line for each showing of each rater, also of what is still to be rated, so that the session can go on from it.
// Columns: rater, showing (from 1), model, method, subject, counts (0: shown again, that rating counts), rating (1..5) and seconds
// (both empty: not rated yet), on every line the same seed, repeats, question, and grade, which files of earlier versions lack.
// '.' is the decimal sign, numbers are exact.

#include <string>
#include <string_view>

#include "reconstruction/evaluation/rating.h"

namespace glisson {

/// A session without raters has only the line of columns, and cannot be read back.
std::string ratingCsv(const RatingSession& session);

/// Throws InputError, which names `file`, where the text is no such session: every cell is checked, the order against its seed.
RatingSession ratingSessionOfCsv(std::string_view text, std::string_view file);

}  // namespace glisson
