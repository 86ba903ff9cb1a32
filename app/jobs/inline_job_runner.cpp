#include "app/jobs/inline_job_runner.h"

namespace glisson {

InlineJobRunner::InlineJobRunner(int heavyLimit, QObject* parent) : JobRunner(heavyLimit, parent) {}

void InlineJobRunner::launch(JobId id, std::function<void()> work) {
  QMetaObject::invokeMethod(
      this,
      [this, id, run = std::move(work)] {
        run();
        workEnded(id);
      },
      Qt::QueuedConnection);
}

}  // namespace glisson
