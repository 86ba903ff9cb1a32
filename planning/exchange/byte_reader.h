#pragma once
// Purpose: reads bytes from outside without ever reading past their end. Private to planning/exchange.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "reconstruction/errors.h"

namespace glisson {

[[noreturn]] inline void refuseMesh(const std::string& file, const std::string& fact) {
  throw InputError("\"" + file + "\" " + fact + ": write the mesh again with the program it came from.");
}

class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t at() const { return at_; }

  template <typename T>
  T take() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    const std::string_view part = take(sizeof(T));
    std::memcpy(&value, part.data(), sizeof(T));
    return value;
  }
  std::string_view take(std::size_t count) {
    if (count > left()) {
      refuseMesh(file_, "ends in the middle (" + std::to_string(bytes_.size()) + " bytes)");
    }
    const std::string_view part = bytes_.substr(at_, count);
    at_ += count;
    return part;
  }
  /// The next line without its end; false at the end of the bytes.
  bool line(std::string_view& text) {
    if (left() == 0) {
      return false;
    }
    const std::string_view rest = bytes_.substr(at_);
    const std::size_t end = rest.find('\n');
    text = rest.substr(0, end);
    at_ += end == std::string_view::npos ? rest.size() : end + 1;
    if (text.ends_with('\r')) {
      text.remove_suffix(1);
    }
    return true;
  }

 private:
  std::string_view bytes_;
  std::string file_;
  std::size_t at_ = 0;
};

/// The next word of `text`, which is shortened by it; empty where there is none.
inline std::string_view nextWord(std::string_view& text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    text = {};
    return {};
  }
  text.remove_prefix(first);
  const std::string_view word = text.substr(0, text.find_first_of(kBlank));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace glisson
