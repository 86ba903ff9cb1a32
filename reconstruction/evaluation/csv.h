#pragma once
// Purpose: the cells of one line of a CSV text, to text and back (RFC 4180; no cell goes over several lines).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glisson {

/// The cell as it stands between commas: in quotes where it holds a comma, a quote or a line's end.
std::string csvCell(const std::string& text);
/// The cells of a line without its end, their quotes taken off. Nothing where a quote is not closed or something follows a quoted
/// cell.
std::optional<std::vector<std::string>> csvCells(std::string_view line, char separator);

}  // namespace glisson
