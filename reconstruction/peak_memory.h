#pragma once
// Purpose: how much the program's resident memory grew at its highest, for reports. Linux only (/proc).

#include <optional>

namespace glisson {

/// Measures from its construction, which ends what an earlier one measures: the system keeps one high-water mark.
class PeakMemory {
 public:
  PeakMemory();
  /// MB (1e6 bytes) above the resident memory at construction; nothing where the system does not tell.
  [[nodiscard]] std::optional<double> growthMb() const;

 private:
  std::optional<double> startMb_;
};

}  // namespace glisson
