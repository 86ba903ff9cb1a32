#pragma once
// Purpose: reads a CSV text back: another hand than the one that writes it.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::test {

/// Cells as they were written, quoted ones without their quotes (RFC 4180).
inline std::vector<std::vector<std::string>> readCsv(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string cell;
  bool inQuotes = false;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (inQuotes && c == '"' && n + 1 < text.size() && text[n + 1] == '"') {
      cell += text[++n];
    } else if (c == '"') {
      inQuotes = !inQuotes;
    } else if (inQuotes || (c != ',' && c != '\n' && c != '\r')) {
      cell += c;
    } else if (c == ',') {
      row.push_back(std::move(cell));
      cell.clear();
    } else if (c == '\n') {
      row.push_back(std::move(cell));
      cell.clear();
      rows.push_back(std::move(row));
      row.clear();
    }
  }
  if (!cell.empty() || !row.empty()) {
    row.push_back(std::move(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Each row by the names of the first one.
inline std::vector<std::map<std::string, std::string>> namedRows(std::string_view text) {
  const std::vector<std::vector<std::string>> rows = readCsv(text);
  std::vector<std::map<std::string, std::string>> named;
  for (std::size_t n = 1; n < rows.size(); ++n) {
    std::map<std::string, std::string>& row = named.emplace_back();
    for (std::size_t column = 0; column < rows.front().size(); ++column) {
      row[rows.front()[column]] = rows[n].at(column);
    }
  }
  return named;
}

}  // namespace glisson::test
