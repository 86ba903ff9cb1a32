#pragma once

#include <chrono>

namespace glisson {

/// Counts seconds of wall time from when it was made or last restarted.
class Stopwatch {
 public:
  void restart() { start_ = std::chrono::steady_clock::now(); }
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace glisson
