#include "app/jobs/thread_job_runner.h"

#include "reconstruction/parallel.h"

namespace glisson {

namespace {

constexpr int kReapMs = 1000;

}  // namespace

ThreadJobRunner::ThreadJobRunner(int heavyLimit, QObject* parent) : JobRunner(heavyLimit, parent) {
  turn_.setSingleShot(true);
  connect(&turn_, &QTimer::timeout, this, &ThreadJobRunner::takeNext);
  reap_.setSingleShot(true);
  reap_.setInterval(kReapMs);
  connect(&reap_, &QTimer::timeout, this, &ThreadJobRunner::reap);
}

ThreadJobRunner::~ThreadJobRunner() {
  blockSignals(true);  // who listens may be half destroyed already
  cancelAll();
  for (const auto& [id, thread] : threads_) {
    thread->wait();
  }
}

void ThreadJobRunner::takeNext() {
  const JobId id = ended_.front();
  ended_.pop_front();
  if (!ended_.empty()) {
    turn_.start();  // before the result is used: that may run an event loop of its own
  }
  workEnded(id);
}

void ThreadJobRunner::reap() {
  for (const JobId id : over_) {
    threads_.erase(id);
  }
  over_.clear();
}

void ThreadJobRunner::launch(JobId id, std::function<void()> work) {
  std::unique_ptr<QThread> thread(QThread::create([run = std::move(work)] {
    const BackgroundWork background;
    run();
  }));
  connect(
      thread.get(), &QThread::finished, this,
      [this, id] {
        over_.push_back(id);
        reap_.start();
        ended_.push_back(id);
        turn_.start();
      },
      Qt::QueuedConnection);
  QThread* started = thread.get();
  threads_.emplace(id, std::move(thread));
  started->start();
}

}  // namespace glisson
