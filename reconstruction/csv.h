#pragma once
// Purpose: cells of a CSV file (RFC 4180): separated by commas, quoted where they hold a comma, a quote or the end of a line.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glisson {

/// The text as a cell.
std::string csvCell(std::string_view text);
/// The cells, separated, with the end of the line.
std::string csvLine(const std::vector<std::string>& cells);

/// The cells of one line without its end, as texts. Nothing where a quote is not closed, stands inside a cell that begins with
/// none, or has something behind it.
std::optional<std::vector<std::string>> csvCells(std::string_view line, char separator = ',');

/// Lines of cells, as texts. Ends of lines may be those of Windows, and a byte order mark is passed over: spreadsheets write both.
/// Nothing where csvCells() says so.
std::optional<std::vector<std::vector<std::string>>> parseCsv(std::string_view text);

}  // namespace glisson
