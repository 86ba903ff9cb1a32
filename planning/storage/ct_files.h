#pragma once
// Purpose: the fingerprint of the CT a case was planned on: the files it lies in with their SHA-256.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glisson {

struct CtFileHash {
  std::string name;  ///< file name inside the folder, or of the one file
  std::int64_t bytes = 0;
  std::string sha256;
  bool operator==(const CtFileHash&) const = default;
};

/// Of the file `source`, or of every regular file directly in the folder `source`, by name. Empty where there is nothing to read.
/// Several files are hashed in parallel. Throws InputError where a file that is there cannot be read.
std::vector<CtFileHash> hashCtFiles(const std::filesystem::path& source);

}  // namespace glisson
