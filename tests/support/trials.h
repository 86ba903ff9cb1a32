#pragma once
// Purpose: one place that says how many random trials a test makes.

#include <dlfcn.h>

namespace glisson::test {

/// `count`, and a twentieth of it under a sanitizer: it sees the same code, and each trial takes ten times as long. Asked at run
/// time, since a test may be compiled without the sanitizer that the rooms have.
inline int trials(int count) {
  static const bool sanitized = dlsym(RTLD_DEFAULT, "__asan_init") != nullptr || dlsym(RTLD_DEFAULT, "__tsan_init") != nullptr;
  return sanitized ? (count + 19) / 20 : count;
}

}  // namespace glisson::test
