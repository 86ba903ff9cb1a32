#pragma once
// Purpose: SHA-256 of bytes and files, for the case file's CT and the package's manifest. Source: FIPS 180-4, sections 5.1.1, 6.2.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace glisson {

/// For data that come in pieces: update() any number of times, then hex() once.
class Sha256 {
 public:
  Sha256();
  void update(std::span<const std::byte> data);
  /// 64 lower-case hexadecimal digits; the object is used up.
  [[nodiscard]] std::string hex();

 private:
  std::array<std::uint32_t, 8> state_;
  std::array<std::byte, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

/// 64 lower-case hexadecimal digits.
std::string sha256Hex(std::span<const std::byte> data);
/// Reads in pieces of 1 MiB. Throws InputError where the file cannot be read to its end.
std::string sha256HexOfFile(const std::filesystem::path& path);

}  // namespace glisson
