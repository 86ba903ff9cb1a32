#include "reconstruction/csv.h"

namespace glisson {

namespace {

/// Reads one cell and what ends it.
class CellReader {
 public:
  CellReader(std::string_view text, char separator) : text_(text), separator_(separator) {}

  [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }
  /// Nothing where it is not well formed. Stands at a separator, at the end of a line or of the text afterwards.
  std::optional<std::string> cell() {
    std::string read;
    if (atEnd() || text_[at_] != '"') {
      for (; !atEnd() && text_[at_] != separator_ && !atLineEnd(); ++at_) {
        if (text_[at_] == '"') {
          return std::nullopt;
        }
        read += text_[at_];
      }
      return read;
    }
    for (++at_; !atEnd(); ++at_) {
      if (text_[at_] == '"') {
        if (++at_; atEnd() || text_[at_] != '"') {
          return atEnd() || text_[at_] == separator_ || atLineEnd() ? std::optional(read) : std::nullopt;
        }
      }
      read += text_[at_];
    }
    return std::nullopt;
  }
  bool passSeparator() {
    const bool there = !atEnd() && text_[at_] == separator_;
    at_ += there ? 1 : 0;
    return there;
  }
  void passLineEnd() { at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1; }

 private:
  [[nodiscard]] bool atLineEnd() const { return text_[at_] == '\n' || text_.substr(at_).starts_with("\r\n"); }
  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
};

/// The cells up to the end of the line.
std::optional<std::vector<std::string>> lineOf(CellReader& reader) {
  std::vector<std::string> cells;
  do {
    std::optional<std::string> cell = reader.cell();
    if (!cell) {
      return std::nullopt;
    }
    cells.push_back(std::move(*cell));
  } while (reader.passSeparator());
  return cells;
}

}  // namespace

std::string csvCell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    line += (&cell == &cells.front() ? "" : ",") + csvCell(cell);
  }
  return line + '\n';
}

std::optional<std::vector<std::string>> csvCells(std::string_view line, char separator) {
  CellReader reader(line, separator);
  std::optional<std::vector<std::string>> cells = lineOf(reader);
  return reader.atEnd() ? cells : std::nullopt;
}

std::optional<std::vector<std::vector<std::string>>> parseCsv(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  CellReader reader(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text, ',');
  std::vector<std::vector<std::string>> lines;
  while (!reader.atEnd()) {
    std::optional<std::vector<std::string>> line = lineOf(reader);
    if (!line) {
      return std::nullopt;
    }
    lines.push_back(std::move(*line));
    reader.passLineEnd();
  }
  return lines;
}

}  // namespace glisson
