#pragma once
// Purpose: jobs on the UI thread itself, one after the other, each from the event loop: the same order of signals as the threads
// give, repeatable, for tests.

#include "app/jobs/job_runner.h"

namespace glisson {

class InlineJobRunner : public JobRunner {
  Q_OBJECT
 public:
  explicit InlineJobRunner(int heavyLimit = 2, QObject* parent = nullptr);

 protected:
  void launch(JobId id, std::function<void()> work) override;
};

}  // namespace glisson
