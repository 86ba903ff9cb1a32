#pragma once
// Purpose: the program's version as every export and report states it.

#include <string_view>

namespace glisson {

/// "0.1.0": the PROJECT_VERSION of CMakeLists.txt.
std::string_view glissonVersion();

}  // namespace glisson
