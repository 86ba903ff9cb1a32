#include "reconstruction/parallel.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>

#ifdef GLISSON_STD_THREADS
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#endif

namespace glisson {

namespace {
/// A thirtieth of the share of a thread of the window, where both want the processor: several work at once.
constexpr int kBackgroundNiceness = 15;

/// On Linux a thread has a niceness of its own, and the threads it starts inherit it.
void giveWay() { setpriority(PRIO_PROCESS, 0, std::max(kBackgroundNiceness, getpriority(PRIO_PROCESS, 0))); }
}  // namespace

#ifdef GLISSON_STD_THREADS

struct BackgroundWork::Impl {};

namespace {
std::atomic<int>& threadLimit() {
  static std::atomic<int> limit{0};
  return limit;
}
}  // namespace

struct ThreadLimit::Impl {
  explicit Impl(int threads) : before(threadLimit().exchange(threads)) {}
  ~Impl() { threadLimit().store(before); }
  int before;
};

ThreadLimit::ThreadLimit(int threads) : impl_(std::make_unique<Impl>(threads)) {}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t pieces = (count + grain - 1) / grain;
  const int limit = threadLimit().load();
  const std::size_t wanted = limit > 0 ? static_cast<std::size_t>(limit) : std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t piece = next++; piece < pieces; piece = next++) {
      try {
        body(piece * grain, std::min(count, (piece + 1) * grain));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) {
          failure = std::current_exception();
        }
        next.store(pieces);
      }
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(std::min(wanted, pieces));
  try {
    for (std::size_t i = 1; i < std::min(wanted, pieces); ++i) {
      threads.emplace_back(work);
    }
  } catch (const std::system_error&) {  // no more threads to be had: those there are do it
  }
  work();
  for (auto& thread : threads) {
    thread.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

#else

namespace {
std::atomic<tbb::task_arena*>& limitedArena() {
  static std::atomic<tbb::task_arena*> arena{nullptr};
  return arena;
}
}  // namespace

/// oneTBB's workers serve any thread: those of the calling one are told when they come.
struct BackgroundWork::Impl : tbb::task_scheduler_observer {
  Impl() { observe(true); }
  ~Impl() override { observe(false); }
  void on_scheduler_entry(bool /*isWorker*/) override { giveWay(); }
};

/// An arena of its own: the usual one has no more places than the machine has cores, whatever the control allows.
struct ThreadLimit::Impl {
  explicit Impl(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)), arena(threads) {
    limitedArena().store(&arena);
  }
  ~Impl() { limitedArena().store(nullptr); }
  tbb::global_control control;
  tbb::task_arena arena;
};

ThreadLimit::ThreadLimit(int threads) : impl_(threads > 0 ? std::make_unique<Impl>(threads) : nullptr) {}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  // Isolated: a thread that waits for this loop takes no piece of a loop around it, which would hold two pieces' memory at once.
  const auto loop = [&] {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
          [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); }, tbb::simple_partitioner());
    });
  };
  if (tbb::task_arena* arena = limitedArena().load()) {
    arena->execute(loop);
  } else {
    loop();
  }
}

#endif

ThreadLimit::~ThreadLimit() = default;

BackgroundWork::BackgroundWork() : impl_((giveWay(), std::make_unique<Impl>())) {}

BackgroundWork::~BackgroundWork() = default;

}  // namespace glisson
