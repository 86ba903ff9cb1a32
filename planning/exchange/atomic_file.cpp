#include "planning/exchange/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "reconstruction/errors.h"

namespace glisson {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) {
      ::close(number_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  /// close() may be the first to hear that the disk is full.
  bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void cannotWrite(const std::filesystem::path& path, int error) {
  throw InputError("\"" + path.string() + "\" cannot be written (" + reason(error) + "): choose another folder or make room.");
}

/// 0 or the errno of what failed.
int writeAll(Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      return written < 0 ? errno : EIO;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file.number()) != 0) {
    return errno;
  }
  return file.close() ? 0 : errno;
}

}  // namespace

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::filesystem::path temporary = folder / ("." + path.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (file.number() < 0) {
    cannotWrite(path, errno);
  }
  int error = writeAll(file, bytes);
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(temporary.c_str());
    cannotWrite(path, error);
  }
  syncFolder(folder);
}

std::string readWholeFile(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) {
    throw InputError("\"" + path.string() + "\" cannot be read (" + reason(errno) + "): check the path and your rights.");
  }
  std::error_code error;
  const std::uintmax_t size = std::filesystem::is_regular_file(path, error) ? std::filesystem::file_size(path, error) : 0;
  if (error || !std::filesystem::is_regular_file(path, error)) {
    throw InputError("\"" + path.string() + "\" is not a regular file: name a file.");
  }
  if (size > kLargestMeshFile) {
    throw InputError("\"" + path.string() + "\" is larger than 2 GiB and is not read: simplify it first.");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.number(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      throw InputError("\"" + path.string() + "\" ended while it was being read: copy it again.");
    }
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

void syncFolder(const std::filesystem::path& folder) {
  const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some network file systems cannot fsync a folder (EINVAL); the files themselves are safe by then.
  if (file.number() < 0 || (::fsync(file.number()) != 0 && errno != EINVAL)) {
    cannotWrite(folder, errno);
  }
}

}  // namespace glisson
