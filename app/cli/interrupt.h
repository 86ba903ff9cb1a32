#pragma once
// Purpose: Ctrl-C as a cancel. The signal is taken by a thread of its own, so that no code runs in a signal handler and nothing
// global is needed.

#include <csignal>
#include <thread>

#include "reconstruction/execution_context.h"

namespace glisson::cli {

/// While it lives, the first SIGINT or SIGTERM cancels the context; the second ends the program at once with exit code 130. Make it
/// before any other thread, since threads inherit the blocked signals.
class InterruptCancels {
 public:
  explicit InterruptCancels(const ExecutionContext& context);
  ~InterruptCancels();
  InterruptCancels(const InterruptCancels&) = delete;
  InterruptCancels& operator=(const InterruptCancels&) = delete;

 private:
  sigset_t before_{};
  std::thread thread_;
};

}  // namespace glisson::cli
