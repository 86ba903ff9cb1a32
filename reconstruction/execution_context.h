#pragma once
// Purpose: sticky cancel, monotone progress and a phase name for long work. Cheap to copy; every member is thread-safe.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace glisson {

/// Handed by const reference to every function that may take longer than 50 ms. Copies share one cancel flag and one progress.
class ExecutionContext {
 public:
  /// Called on the worker's thread with the fraction done (0..1, never falling) and the phase's name.
  using ProgressCallback = std::function<void(double fraction, std::string_view phase)>;

  /// Progress is dropped; cancel() still works.
  ExecutionContext();
  explicit ExecutionContext(ProgressCallback callback);

  /// Asks the work to stop. Sticky: there is no way back.
  void cancel() const;
  [[nodiscard]] bool isCancelled() const;
  /// Throws Cancelled after cancel().
  void throwIfCancelled() const;

  /// Tells progress within this context's range. A smaller fraction than one told before is raised to it. Throws Cancelled after
  /// cancel().
  void report(double fraction, std::string_view phase) const;

  /// A context whose 0..1 is [from, to] of this one; cancel and monotony are shared.
  [[nodiscard]] ExecutionContext range(double from, double to) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace glisson
