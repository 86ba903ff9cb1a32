#pragma once
// Purpose: jobs on QThreads, one per running job. The destructor cancels what runs and waits for its threads.

#include <QThread>
#include <QTimer>
#include <map>
#include <vector>

#include "app/jobs/job_runner.h"

namespace glisson {

class ThreadJobRunner : public JobRunner {
  Q_OBJECT
 public:
  explicit ThreadJobRunner(int heavyLimit = 2, QObject* parent = nullptr);
  ~ThreadJobRunner() override;

 protected:
  void launch(JobId id, std::function<void()> work) override;

 private:
  /// One result in each turn of the event loop: several at once would keep the window from answering.
  void takeNext();

  /// Work that is over leaves a thread that may still wait for a processor to end on: nobody waits for it before it has rested.
  void reap();

  std::deque<JobId> ended_;  ///< results to take
  QTimer turn_;
  std::vector<JobId> over_;
  QTimer reap_;
  std::map<JobId, std::unique_ptr<QThread>> threads_;
};

}  // namespace glisson
