#pragma once
// Purpose: one writer per case file, told to other processes by the kernel's lock on the file itself (flock): no second file is
// left behind, and a killed program's lock is gone with it.

#include <filesystem>

namespace glisson {

class FileLock {
 public:
  FileLock() = default;
  /// Opens `path` and tries to become its writer; does not wait. isOpen() is false where there is no such file.
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
  /// This object is the writer.
  [[nodiscard]] bool isWriter() const { return writer_; }
  /// `path` still names the file that was opened.
  [[nodiscard]] bool holds(const std::filesystem::path& path) const;

 private:
  int descriptor_ = -1;
  bool writer_ = false;
};

/// Makes the file's, or the folder's, content durable. Throws InputError.
void syncToDisk(const std::filesystem::path& path);

}  // namespace glisson
