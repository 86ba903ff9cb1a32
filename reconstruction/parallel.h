#pragma once
// Purpose: the one door to threads for numerical loops: oneTBB, or std::thread where GLISSON_STD_THREADS is defined (tsan preset:
// Debian's TBB gives false races). Results must not depend on the number of threads: write to disjoint places, sum in a fixed
// order.

#include <cstddef>
#include <functional>
#include <memory>

namespace glisson {

/// Limits parallelFor to n threads while it lives (0 = all cores). Not nested; used by the command line's --threads and by tests.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// From now on the calling thread takes the processor only where no thread of usual priority wants it, and so do, while this lives,
/// the threads that help it in parallelFor: the window answers while they work. A thread that gave way once keeps doing so, since
/// Linux lets no process take that back; a loop of another thread that it helps later waits for it where the processors are taken.
/// Make and destroy it on one thread.
class BackgroundWork {
 public:
  BackgroundWork();
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Calls body(begin, end) for disjoint pieces of [0, count), each at most grain long, on several threads. The first exception
/// thrown by a body is thrown here after all pieces have ended.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace glisson
