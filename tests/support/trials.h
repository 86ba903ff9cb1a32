#pragma once
// Purpose: one place that says how many random trials a test makes.

namespace glisson::test {

/// `count`, and a twentieth of it under a sanitizer: it sees the same code, and each trial takes ten times as long.
constexpr int trials(int count) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (count + 19) / 20;
#else
  return count;
#endif
}

}  // namespace glisson::test
