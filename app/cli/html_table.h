#pragma once
// Purpose: what the report of `evaluate` is built of: its style sheet, tables and cards. Texts are escaped here.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::cli {

/// CSS, for the pictures of evaluate_plots.h as well.
std::string reportSheet();

struct Cell {
  std::string text;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< takes part in the search for the least
};
struct TableRow {
  std::string heading;
  std::vector<Cell> cells;
};
/// The least number of a row stands out, as in the paper; `headings` has one more than the rows have cells.
std::string htmlTable(const std::vector<std::string>& headings, const std::vector<TableRow>& rows);
/// The row with nothing in it that stands out.
TableRow plain(TableRow row);

/// `content` is HTML and stands as it is.
std::string htmlSection(const std::string& title, const std::string& explanation, const std::string& content);
std::string htmlCard(const std::string& number, const std::string& meaning);
/// At least three digits that count, and no decimals from 100 on.
std::string significant(double value);

}  // namespace glisson::cli
