#include "app/jobs/thread_job_runner.h"

#include <sys/resource.h>

namespace glisson {

namespace {

constexpr int kBackgroundNiceness = 5;

}  // namespace

ThreadJobRunner::ThreadJobRunner(int heavyLimit, QObject* parent) : JobRunner(heavyLimit, parent) {}

ThreadJobRunner::~ThreadJobRunner() {
  blockSignals(true);  // who listens may be half destroyed already
  cancelAll();
  for (const auto& [id, thread] : threads_) {
    thread->wait();
  }
}

void ThreadJobRunner::launch(JobId id, std::function<void()> work) {
  std::unique_ptr<QThread> thread(QThread::create([run = std::move(work)] {
    // on Linux a thread has a niceness of its own, and the threads it starts inherit it: the window keeps answering
    setpriority(PRIO_PROCESS, 0, kBackgroundNiceness);
    run();
  }));
  connect(
      thread.get(), &QThread::finished, this,
      [this, id] {
        const auto found = threads_.find(id);
        if (found != threads_.end()) {
          found->second->wait();
          found->second.release()->deleteLater();  // we are inside a slot of its own signal
          threads_.erase(found);
        }
        workEnded(id);
      },
      Qt::QueuedConnection);
  QThread* started = thread.get();
  threads_.emplace(id, std::move(thread));
  started->start();
}

}  // namespace glisson
