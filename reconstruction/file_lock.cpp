#include "reconstruction/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "reconstruction/errors.h"

namespace glisson {

FileLock::FileLock(const std::filesystem::path& path) {
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  const bool writable = descriptor_ >= 0 || errno == EISDIR;
  if (descriptor_ < 0) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  }
  writer_ = writable && descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
  taken_ = writable && !writer_ && errno == EWOULDBLOCK;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      writer_(std::exchange(other.writer_, false)),
      taken_(std::exchange(other.taken_, false)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(writer_, other.writer_);
  std::swap(taken_, other.taken_);
  return *this;
}

bool FileLock::holds(const std::filesystem::path& path) const {
  struct stat opened {};
  struct stat named {};
  return descriptor_ >= 0 && ::fstat(descriptor_, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void removeAbandoned(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& isTemporary) {
  std::error_code ignored;
  std::error_code ended;
  for (std::filesystem::directory_iterator entry(folder, ended), end; !ended && entry != end; entry.increment(ended)) {
    if (!isTemporary(entry->path().filename().string()) || entry->is_symlink(ignored)) {
      continue;
    }
    const FileLock left(entry->path());
    if (left.isWriter()) {
      std::filesystem::remove_all(entry->path(), ignored);
    }
  }
}

void syncToDisk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  if (!done) {
    throw InputError(path.string() + " cannot be written to the disk; check the disk and save under another name.");
  }
}

}  // namespace glisson
