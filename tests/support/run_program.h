#pragma once
// Purpose: runs a built program as the user would and keeps what it said.

#include <filesystem>
#include <string>
#include <vector>

namespace glisson::test {

struct Finished {
  int exitCode = -1;  ///< 128 + signal where it was killed
  std::string out;
  std::string err;
};

/// Starts programFolder()/<program>; `environment` holds NAME=VALUE added to the test's own. A positive `interruptAfterSeconds`
/// sends one SIGINT then.
Finished runProgram(const std::string& program, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {}, double interruptAfterSeconds = 0);

/// A folder of its own below the system's temporary folder; gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string bytesOf(const std::filesystem::path& path);
/// Names of everything below a folder, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

}  // namespace glisson::test
