#include "reconstruction/execution_context.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "reconstruction/errors.h"

namespace glisson {

struct ExecutionContext::State {
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  double fraction = 0.0;
  ProgressCallback callback;
};

ExecutionContext::ExecutionContext() : state_(std::make_shared<State>()) {}

ExecutionContext::ExecutionContext(ProgressCallback callback) : ExecutionContext() { state_->callback = std::move(callback); }

void ExecutionContext::cancel() const { state_->cancelled.store(true); }

bool ExecutionContext::isCancelled() const { return state_->cancelled.load(std::memory_order_relaxed); }

void ExecutionContext::throwIfCancelled() const {
  if (isCancelled()) {
    throw Cancelled();
  }
}

void ExecutionContext::report(double fraction, std::string_view phase) const {
  throwIfCancelled();
  if (!state_->callback) {
    return;
  }
  const std::lock_guard lock(state_->mutex);
  const double whole = from_ + std::clamp(fraction, 0.0, 1.0) * (to_ - from_);
  state_->fraction = std::max(state_->fraction, whole);
  state_->callback(state_->fraction, phase);
}

ExecutionContext ExecutionContext::range(double from, double to) const {
  ExecutionContext part = *this;
  part.from_ = from_ + from * (to_ - from_);
  part.to_ = from_ + to * (to_ - from_);
  return part;
}

}  // namespace glisson
