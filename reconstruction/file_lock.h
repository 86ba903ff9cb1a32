#pragma once
// Purpose: one writer per file or folder, told to other processes by the kernel's lock on the file itself (flock): no second file
// is left behind, and a killed program's lock is gone with it.

#include <filesystem>
#include <functional>
#include <string>

namespace glisson {

class FileLock {
 public:
  FileLock() = default;
  /// Opens `path`, a file or a folder, and tries to become its writer; does not wait. isOpen() is false where there is no such
  /// file.
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
  /// This object is the writer.
  [[nodiscard]] bool isWriter() const { return writer_; }
  /// Somebody else is. Where neither is told, the file cannot be locked: it is read-only, or its file system knows no locks.
  [[nodiscard]] bool isTaken() const { return taken_; }
  /// `path` still names the file that was opened.
  [[nodiscard]] bool holds(const std::filesystem::path& path) const;

 private:
  int descriptor_ = -1;
  bool writer_ = false;
  bool taken_ = false;
};

/// Removes the temporary files and folders directly in `folder` that a killed program left: those that isTemporary(name) knows and
/// that nobody is the writer of. Whoever makes one becomes its writer at once, and looks with holds() whether it was faster.
void removeAbandoned(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& isTemporary);

/// Makes the file's, or the folder's, content durable. Throws InputError.
void syncToDisk(const std::filesystem::path& path);

}  // namespace glisson
