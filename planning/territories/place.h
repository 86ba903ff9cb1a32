#pragma once

#include <cstddef>
#include <cstdint>

namespace glisson {

/// The place in a vector of a site, branch or piece, whose numbers are signed since -1 means none.
[[nodiscard]] constexpr std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }

}  // namespace glisson
