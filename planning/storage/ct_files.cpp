#include "planning/storage/ct_files.h"

#include <algorithm>

#include "planning/storage/sha256.h"
#include "reconstruction/parallel.h"

namespace glisson {

std::vector<CtFileHash> hashCtFiles(const std::filesystem::path& source) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_regular_file(source, error)) {
    files.push_back(source);
  } else if (std::filesystem::is_directory(source, error)) {
    for (const auto& entry : std::filesystem::directory_iterator(source, error)) {
      if (entry.is_regular_file(error)) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<CtFileHash> hashes(files.size());
  parallelFor(files.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      std::error_code gone;  // meanwhile: the hash says it in a sentence
      const std::uintmax_t bytes = std::filesystem::file_size(files[n], gone);
      hashes[n] = {files[n].filename().string(), static_cast<std::int64_t>(bytes), sha256HexOfFile(files[n])};
    }
  });
  return hashes;
}

}  // namespace glisson
