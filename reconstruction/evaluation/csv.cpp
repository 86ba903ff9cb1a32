#include "reconstruction/evaluation/csv.h"

#include <algorithm>

namespace glisson {

namespace {

/// The quoted cell that begins at `at`, which is left behind its closing quote; nothing where there is none.
std::optional<std::string> quotedCell(std::string_view line, std::size_t& at) {
  std::string cell;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      cell += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      cell += line[++at];
    } else {
      ++at;
      return cell;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string cell = "\"";
  for (const char c : text) {
    cell += c == '"' ? "\"\"" : std::string(1, c);
  }
  return cell + "\"";
}

std::optional<std::vector<std::string>> csvCells(std::string_view line, char separator) {
  std::vector<std::string> cells;
  for (std::size_t at = 0;; ++at) {
    if (at < line.size() && line[at] == '"') {
      auto cell = quotedCell(line, at);
      if (!cell || (at < line.size() && line[at] != separator)) {
        return std::nullopt;
      }
      cells.push_back(std::move(*cell));
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      cells.emplace_back(line.substr(at, end - at));
      at = end;
    }
    if (at >= line.size()) {
      return cells;
    }
  }
}

}  // namespace glisson
