#pragma once
// Purpose: to poll cancel in a loop of very many short steps.

#include <cstdint>

#include "reconstruction/execution_context.h"

namespace glisson {

/// Looks at cancel every 65,536th step: some milliseconds where a step takes tens of nanoseconds. One thread.
class CancelPoll {
 public:
  explicit CancelPoll(const ExecutionContext& context) : context_(context) { context.throwIfCancelled(); }
  explicit CancelPoll(ExecutionContext&&) = delete;
  /// Once a step. Throws Cancelled after cancel().
  void operator()() {
    if (++steps_ % kSteps == 0) {
      context_.throwIfCancelled();
    }
  }

 private:
  static constexpr std::uint32_t kSteps = 65536;
  const ExecutionContext& context_;
  std::uint32_t steps_ = 0;
};

}  // namespace glisson
