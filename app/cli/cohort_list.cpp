#include "app/cli/cohort_list.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "planning/exchange/atomic_file.h"
#include "reconstruction/csv.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

constexpr std::array<std::string_view, 7> kColumns{"name", "segmentation", "label", "structure", "labels", "accept", "prefer"};
constexpr const char* kWayOut =
    "the first line names the columns: name,segmentation and, where wanted, label or structure, labels, accept, prefer";

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// A folder of this name can be made below DIR on any file system, and is none of the cohort's own files.
bool isFolderName(const std::string& name) {
  const auto isPlain = [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; };
  constexpr std::size_t kLongestName = 100;
  return name.size() <= kLongestName && !name.starts_with('.') && !name.ends_with('.') &&
         name.find_first_of("/\\:*?\"<>|") == std::string::npos && std::all_of(name.begin(), name.end(), isPlain) &&
         !toLower(name).starts_with("cohort.");
}

class ListReader {
 public:
  explicit ListReader(std::filesystem::path file) : file_(std::move(file)) {}

  CohortList read() {
    CohortList list;
    list.file = file_.filename().string();
    std::string text = readWholeFile(file_);
    if (text.starts_with("\xEF\xBB\xBF")) {
      text.erase(0, 3);  // some spreadsheets begin so
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      const std::vector<std::string> cells = cellsOf(line);
      if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); })) {
        continue;
      }
      if (columns_.empty()) {
        takeColumns(cells);
      } else {
        list.entries.push_back(entryOf(cells));
        list.entries.back().number = static_cast<int>(list.entries.size());
      }
    }
    if (list.entries.empty()) {
      throw InputError(file_.string() + " lists no patient; " + kWayOut + "; each further line is a patient");
    }
    return list;
  }

 private:
  [[noreturn]] void refuse(const std::string& fact) const {
    throw InputError(file_.string() + ", line " + std::to_string(line_) + ": " + fact);
  }

  /// None for a comment. A spreadsheet puts a comment with a separator into quotes.
  [[nodiscard]] std::vector<std::string> cellsOf(const std::string& line) {
    const std::string content = trimmed(line);
    if (content.starts_with('#') || content.starts_with("\"#")) {
      return {};
    }
    if (columns_.empty()) {
      const auto holds = [&](char c) { return line.find(c) != std::string::npos; };
      separator_ = holds('\t') ? '\t' : holds(';') ? ';' : ',';
    }
    auto cells = csvCells(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line, separator_);
    if (!cells) {
      refuse("a quote is not closed or stands inside a cell; a cell with quotes begins and ends with one and doubles those within");
    }
    std::transform(cells->begin(), cells->end(), cells->begin(), trimmed);
    return std::move(*cells);
  }

  void takeColumns(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) {
      columns_.push_back(toLower(cell));
      const bool known = std::find(kColumns.begin(), kColumns.end(), columns_.back()) != kColumns.end();
      if (!known || std::count(columns_.begin(), columns_.end(), columns_.back()) > 1) {
        refuse("column " + std::to_string(columns_.size()) + " is none that is known, or is there twice; " + kWayOut);
      }
    }
    for (const char* needed : {"name", "segmentation"}) {
      if (std::find(columns_.begin(), columns_.end(), needed) == columns_.end()) {
        refuse(std::string("there is no column ") + needed + "; " + kWayOut);
      }
    }
  }

  [[nodiscard]] CohortEntry entryOf(const std::vector<std::string>& cells) {
    if (cells.size() > columns_.size()) {
      refuse("there are " + std::to_string(cells.size()) + " cells for " + std::to_string(columns_.size()) +
             " columns; put a cell that holds a separator in quotes");
    }
    std::map<std::string, std::string> row;
    for (std::size_t n = 0; n < columns_.size(); ++n) {
      row[columns_[n]] = n < cells.size() ? cells[n] : std::string();
    }
    CohortEntry entry;
    entry.line = line_;
    entry.name = nameOf(row["name"]);
    entry.listedSegmentation = row["segmentation"];
    if (entry.listedSegmentation.empty()) {
      refuse(entry.name + " has no segmentation; name its file or folder");
    }
    entry.segmentation = file_.parent_path() / entry.listedSegmentation;
    entry.choice = choiceOf(row["label"], row["structure"]);
    entry.input = {.labels = row["labels"], .accept = row["accept"], .prefer = row["prefer"]};
    return entry;
  }

  std::string nameOf(const std::string& name) {
    if (name.empty()) {
      refuse("the patient has no name; give it one");
    }
    if (!isFolderName(name)) {
      refuse("the name cannot be that of a folder; take letters, digits, blanks, - and _");
    }
    // Some file systems do not tell upper from lower case.
    const auto [at, isNew] = lineOfName_.emplace(toLower(name), line_);
    if (!isNew) {
      refuse("the name " + name + " stands in line " + std::to_string(at->second) + " already; give each patient its own");
    }
    return name;
  }

  [[nodiscard]] MaskChoice choiceOf(const std::string& label, const std::string& structure) const {
    MaskChoice choice;
    choice.structure = structure;
    if (!label.empty()) {
      if (!structure.empty()) {
        refuse("there are a label and a structure; leave one of them empty");
      }
      const auto number = parseInteger(label);
      if (!number || *number != static_cast<int>(*number)) {
        refuse("the label is no whole number; a name belongs in the column structure");
      }
      choice.label = static_cast<int>(*number);
    }
    return choice;
  }

  std::filesystem::path file_;
  int line_ = 0;
  char separator_ = ',';
  std::vector<std::string> columns_;  ///< in lower case; empty until they are read
  std::map<std::string, int> lineOfName_;
};

}  // namespace

CohortList readCohortList(const std::filesystem::path& file) { return ListReader(file).read(); }

}  // namespace glisson::cli
