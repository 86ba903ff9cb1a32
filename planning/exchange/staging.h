#pragma once
// Purpose: a package's folder while it is being written: hidden beside its place, gone again unless it is published. Private to
// planning/exchange.

#include <filesystem>
#include <string>
#include <vector>

#include "reconstruction/file_lock.h"

namespace glisson {

class StagingFolder {
 public:
  /// Makes `directory` where it is missing and `.<name>.tmp` (or `.<name>_2.tmp`, ...) in it; removes those that
  /// killed programs left there. Throws InputError.
  StagingFolder(const std::filesystem::path& directory, std::string name);
  /// Removes what was not published, and the directories that were made for it.
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return staging_; }
  /// fsync, then moved to `<name>`, or `<name>_2`, ... where a folder of that name is there: never over one. Throws InputError.
  std::filesystem::path publish();

 private:
  void makeDirectory();
  [[noreturn]] void refuse(int error) const;

  std::filesystem::path directory_;
  std::string name_;
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> made_;  ///< directories made for this package, outermost first
  FileLock lock_;                            ///< tells other programs that the staging folder is in use
  bool published_ = false;
};

}  // namespace glisson
