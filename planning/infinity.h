#pragma once

#include <limits>

namespace glisson {

/// Farther than anything: what a search for the least distance begins with.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace glisson
