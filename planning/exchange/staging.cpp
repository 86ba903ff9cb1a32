#include "planning/exchange/staging.h"

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

constexpr int kMostOfOneName = 1000;

std::string withNumber(const std::string& name, int number) { return number == 1 ? name : name + "_" + std::to_string(number); }

/// .<code>_<plan>_<YYYYMMDD-HHMM>.tmp, or _2, ... before the ending.
bool isStaging(const std::string& name) {
  constexpr std::array kShapes{".?*_?*_[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9]-[0-9][0-9][0-9][0-9].tmp",
                               ".?*_?*_[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9]-[0-9][0-9][0-9][0-9]_[0-9].tmp",
                               ".?*_?*_[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9]-[0-9][0-9][0-9][0-9]_[0-9][0-9].tmp"};
  return std::ranges::any_of(kShapes, [&](const char* shape) { return ::fnmatch(shape, name.c_str(), 0) == 0; });
}

/// rename() that does not replace, where the file system can; 0 or errno.
int renameNoReplace(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return 0;
  }
  if (errno != EINVAL && errno != ENOSYS) {
    return errno;
  }
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(to, ignored))) {
    return EEXIST;
  }
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

StagingFolder::StagingFolder(const std::filesystem::path& directory, std::string name)
    : directory_(std::filesystem::absolute(directory).lexically_normal()), name_(std::move(name)) {
  if (!directory_.has_filename()) {
    directory_ = directory_.parent_path();  // "out/" is "out"
  }
  makeDirectory();
  removeAbandoned(directory_, isStaging);
  for (int number = 1; staging_.empty() && number <= kMostOfOneName; ++number) {
    const std::filesystem::path candidate = directory_ / ("." + withNumber(name_, number) + ".tmp");
    if (::mkdir(candidate.c_str(), 0777) == 0) {
      lock_ = FileLock(candidate);
      // Another program that tidies up may have taken it for an abandoned one before it was locked.
      staging_ = lock_.holds(candidate) ? candidate : std::filesystem::path();
    } else if (errno != EEXIST) {
      const int error = errno;
      for (auto made = made_.rbegin(); made != made_.rend(); ++made) {
        ::rmdir(made->c_str());
      }
      refuse(error);
    }
  }
  if (staging_.empty()) {
    refuse(EEXIST);
  }
}

StagingFolder::~StagingFolder() {
  if (published_) {
    return;
  }
  std::error_code ignored;
  std::filesystem::remove_all(staging_, ignored);
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) {
    ::rmdir(made->c_str());  // fails where something else has come into it, as it should
  }
}

void StagingFolder::makeDirectory() {
  std::vector<std::filesystem::path> missing;
  for (std::filesystem::path at = directory_; !at.empty() && at != at.root_path(); at = at.parent_path()) {
    std::error_code ignored;
    if (std::filesystem::exists(at, ignored)) {
      break;
    }
    missing.push_back(at);
  }
  for (auto at = missing.rbegin(); at != missing.rend(); ++at) {
    if (::mkdir(at->c_str(), 0777) == 0) {
      made_.push_back(*at);
    } else if (errno != EEXIST) {
      const int error = errno;
      for (auto made = made_.rbegin(); made != made_.rend(); ++made) {
        ::rmdir(made->c_str());
      }
      refuse(error);
    }
  }
}

void StagingFolder::refuse(int error) const {
  throw InputError("The package cannot be written into \"" + directory_.string() + "\" (" + std::generic_category().message(error) +
                   "): choose another folder or make room.");
}

std::filesystem::path StagingFolder::publish() {
  syncFolder(staging_);
  for (int number = 1; number <= kMostOfOneName; ++number) {
    std::filesystem::path target = directory_ / withNumber(name_, number);
    const int error = renameNoReplace(staging_, target);
    if (error == 0) {
      published_ = true;
      syncFolder(directory_);
      return target;
    }
    if (error != EEXIST && error != ENOTEMPTY) {
      refuse(error);
    }
  }
  refuse(EEXIST);
}

}  // namespace glisson
