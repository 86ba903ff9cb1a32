#include "reconstruction/io/import/text_header.h"

#include <algorithm>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/byte_source.h"
#include "reconstruction/text.h"

namespace glisson::import {

TextHeader readTextHeader(const std::filesystem::path& path, bool (*isLast)(std::string_view line)) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  constexpr std::size_t kMostLineBytes = std::size_t{1} << 16;
  ByteSource source(path, 0, Coding::Raw);
  std::string text(std::min<std::uint64_t>(kMostBytes, source.mostBytesLeft()), '\0');
  text.resize(source.read(text.data(), text.size()));
  TextHeader header;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = text.find('\n', from);
    const bool whole = end != std::string::npos;
    std::string line = text.substr(from, whole ? end - from : std::string::npos);
    if (line.size() > kMostLineBytes) {
      break;
    }
    if (line.ends_with('\r')) {
      line.pop_back();
    }
    from = whole ? end + 1 : text.size();
    header.lines.push_back(line);
    if (whole && isLast(line)) {
      header.offset = from;
      return header;
    }
  }
  throw InputError(path.string() + " has a header without an end; it is cut off or damaged, so copy or export it again.");
}

std::string trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == std::string_view::npos ? std::string()
                                         : std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> found;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    found.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

std::vector<double> numbers(const std::string& name, const std::string& field, std::string_view text, std::size_t count) {
  std::vector<double> values;
  const std::string where = " in its header field \"" + field + "\"; export it again.";
  const auto refuse = [&](const std::string& fact) { throw InputError(name + " has " + fact + where); };
  for (const std::string& word : words(text)) {
    const auto value = parseNumber(word);
    if (!value) {
      refuse("a text such as \"" + word.substr(0, 40) + "\" for a number");
    }
    values.push_back(*value);
  }
  if (values.size() != count) {
    refuse(std::to_string(values.size()) + " instead of " + std::to_string(count) + " numbers");
  }
  return values;
}

std::uint64_t countOf(const std::string& name, const std::string& field, std::string_view text) {
  const auto value = parseInteger(text);
  if (!value || *value < 0) {
    throw InputError(name + " has no whole number in its header field \"" + field + "\"; export it again.");
  }
  return static_cast<std::uint64_t>(*value);
}

}  // namespace glisson::import
