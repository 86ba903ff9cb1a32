#pragma once
// Purpose: how much the program's resident memory grew at its highest, for the report's peakGrowthMb. Linux only (/proc).

#include <optional>

namespace glisson::cli {

/// Measures from its construction.
class PeakMemory {
 public:
  PeakMemory();
  /// MB (1e6 bytes) above the resident memory at construction; nothing where the system does not tell.
  [[nodiscard]] std::optional<double> growthMb() const;

 private:
  std::optional<double> startMb_;
};

}  // namespace glisson::cli
