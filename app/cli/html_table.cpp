#include "app/cli/html_table.h"

#include <algorithm>
#include <cmath>

#include "app/lab/svg.h"
#include "reconstruction/text.h"

namespace glisson::cli {

using lab::escaped;
using lab::tickText;

namespace {

constexpr std::string_view kReportSheet = R"(
:root { color-scheme: light; --ink: #1d2733; --faint: #5d6b7a; --line: #dfe4ea; }
body { margin: 0; background: #f5f7f9; color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 28px 24px 60px; }
h1 { font-size: 25px; margin: 0 0 2px; } h2 { font-size: 17px; margin: 0 0 4px; }
p { margin: 4px 0 10px; max-width: 78ch; } .faint, small { color: var(--faint); }
section { background: #fff; border: 1px solid var(--line); border-radius: 8px; padding: 18px 22px; margin-top: 18px; overflow-x: auto; }
.cards { display: flex; flex-wrap: wrap; gap: 12px; margin-top: 18px; }
.card { flex: 1 1 190px; background: #fff; border: 1px solid var(--line); border-radius: 8px; padding: 12px 16px; }
.card b { display: block; font-size: 23px; line-height: 1.3; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: 8px 0 4px; }
th, td { padding: 4px 12px; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { font-weight: 600; } th:first-child, td:first-child { text-align: left; padding-left: 0; }
td.least { font-weight: 700; background: #fdf3e1; } td.text { text-align: left; white-space: normal; min-width: 17em; }
table.all { font-size: 13px; width: 100%; } table.all th:last-child { text-align: left; } table.all td, table.all th { padding: 2px 7px; }
summary { cursor: pointer; font-weight: 600; }
svg { width: 100%; height: auto; display: block; }
)";

}  // namespace

std::string reportSheet() { return std::string(kReportSheet) + std::string(lab::plotSheet()); }

std::string htmlTable(const std::vector<std::string>& headings, const std::vector<TableRow>& rows) {
  std::string html = "<table>\n<tr>";
  for (const std::string& heading : headings) {
    html += "<th>" + escaped(heading) + "</th>";
  }
  html += "</tr>\n";
  for (const TableRow& row : rows) {
    double least = std::numeric_limits<double>::infinity();
    for (const Cell& cell : row.cells) {
      least = std::isnan(cell.value) ? least : std::min(least, cell.value);
    }
    html += "<tr><td>" + escaped(row.heading) + "</td>";
    for (const Cell& cell : row.cells) {
      html += (cell.value == least ? "<td class=\"least\">" : "<td>") + escaped(cell.text) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string significant(double value) {
  const double size = std::abs(value);
  return size >= 1000 ? tickText(std::round(value)) : formatNumber(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

TableRow plain(TableRow row) {
  for (Cell& cell : row.cells) {
    cell.value = std::numeric_limits<double>::quiet_NaN();
  }
  return row;
}

std::string htmlSection(const std::string& title, const std::string& explanation, const std::string& content) {
  return "<section>\n<h2>" + escaped(title) + "</h2>\n<p class=\"faint\">" + escaped(explanation) + "</p>\n" + content +
         "</section>\n";
}

std::string htmlCard(const std::string& number, const std::string& meaning) {
  return "<div class=\"card\"><b>" + escaped(number) + "</b>" + escaped(meaning) + "</div>\n";
}

}  // namespace glisson::cli
