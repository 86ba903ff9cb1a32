#include "reconstruction/peak_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "reconstruction/text.h"

namespace glisson {

namespace {

constexpr double kMbPerKib = 1024.0 * 1e-6;

std::optional<double> statusMb(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key + ":")) {
      std::string value = line.substr(key.size() + 1);
      value = value.substr(0, value.rfind("kB"));
      if (const auto kib = parseInteger(value)) {
        return static_cast<double>(*kib) * kMbPerKib;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

PeakMemory::PeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";  // sets the high-water mark back to what is resident now
  startMb_ = statusMb("VmRSS");
}

std::optional<double> PeakMemory::growthMb() const {
  const std::optional<double> peak = statusMb("VmHWM");
  if (!peak || !startMb_) {
    return std::nullopt;
  }
  return std::max(0.0, *peak - *startMb_);
}

}  // namespace glisson
