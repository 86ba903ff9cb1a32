#include "app/jobs/job_runner.h"

#include <algorithm>
#include <mutex>
#include <new>

#include "reconstruction/errors.h"

namespace glisson {

struct JobRunner::Entry {
  JobRequest request;
  ExecutionContext context;
  JobState state = JobState::Queued;
  bool working = false;  ///< its work was launched and has not ended
  std::exception_ptr error;

  std::mutex progressMutex;
  double fraction = 0;
  QString phase;
  bool progressPosted = false;
};

JobRunner::JobRunner(int heavyLimit, QObject* parent) : QObject(parent), heavyLimit_(std::max(1, heavyLimit)) {}

JobRunner::~JobRunner() = default;

JobId JobRunner::submit(JobRequest request) {
  if (!request.key.isEmpty()) {
    std::vector<JobId> stale;
    for (const auto& [id, entry] : entries_) {
      if (entry->request.key == request.key) {
        stale.push_back(id);
      }
    }
    for (const JobId id : stale) {
      cancel(id);
    }
  }
  const JobId id = nextId_++;
  auto entry = std::make_shared<Entry>();
  entry->request = std::move(request);
  const std::weak_ptr<Entry> weak = entry;
  entry->context = ExecutionContext([this, id, weak](double fraction, std::string_view phase) {
    const std::shared_ptr<Entry> self = weak.lock();
    if (!self) {
      return;
    }
    {
      const std::lock_guard lock(self->progressMutex);
      self->fraction = fraction;
      self->phase = QString::fromUtf8(phase.data(), static_cast<qsizetype>(phase.size()));
      if (std::exchange(self->progressPosted, true)) {
        return;  // one event on its way is enough: it reads the newest values
      }
    }
    QMetaObject::invokeMethod(this, [this, id] { tellProgress(id); });
  });
  entries_.emplace(id, entry);
  emit jobAdded(id, entry->request.title, entry->request.quiet);
  schedule();
  return id;
}

void JobRunner::schedule() {
  const auto heavyWorking = [this] {
    return std::ranges::count_if(entries_, [](const auto& item) { return item.second->working && item.second->request.heavy; });
  };
  std::vector<std::pair<JobId, std::shared_ptr<Entry>>> starting;
  auto room = heavyLimit_ - static_cast<int>(heavyWorking());
  for (const auto& [id, entry] : entries_) {
    if (entry->state != JobState::Queued || (entry->request.heavy && room <= 0)) {
      continue;
    }
    room -= entry->request.heavy ? 1 : 0;
    entry->state = JobState::Running;
    entry->working = true;
    starting.emplace_back(id, entry);
  }
  for (const auto& [id, entry] : starting) {
    start(id, entry);
  }
}

void JobRunner::start(JobId id, const std::shared_ptr<Entry>& entry) {
  emit jobStarted(id);
  launch(id, [entry] {
    try {
      entry->context.throwIfCancelled();
      entry->request.process(entry->context);
    } catch (...) {
      entry->error = std::current_exception();
    }
  });
}

void JobRunner::workEnded(JobId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) {
    return;
  }
  const std::shared_ptr<Entry> entry = found->second;
  entry->working = false;
  entries_.erase(found);
  if (entry->state == JobState::Running) {
    conclude(id, *entry);
  }
  schedule();
  tellIdle();
}

void JobRunner::conclude(JobId id, Entry& entry) {
  try {
    if (entry.error) {
      std::rethrow_exception(entry.error);
    }
    entry.state = JobState::Done;
    if (entry.request.finish) {
      entry.request.finish();
    }
    emit jobEnded(id, JobState::Done, {});
  } catch (const Cancelled&) {
    entry.state = JobState::Cancelled;
    emit jobEnded(id, JobState::Cancelled, {});
  } catch (const std::exception& error) {
    entry.state = JobState::Failed;
    if (entry.request.fail) {
      entry.request.fail(error);
    }
    emit jobEnded(id, JobState::Failed, messageOf(error));
  } catch (...) {  // the one boundary for what is no std::exception: the program lives
    const std::runtime_error unknown("The work ended with an unknown error.");
    entry.state = JobState::Failed;
    if (entry.request.fail) {
      entry.request.fail(unknown);
    }
    emit jobEnded(id, JobState::Failed, messageOf(unknown));
  }
}

void JobRunner::cancel(JobId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end() || found->second->state == JobState::Cancelled) {
    return;
  }
  const std::shared_ptr<Entry> entry = found->second;
  entry->state = JobState::Cancelled;
  entry->context.cancel();
  if (!entry->working) {
    entries_.erase(found);
  }
  emit jobEnded(id, JobState::Cancelled, {});
  schedule();
  tellIdle();
}

void JobRunner::cancelAll() {
  std::vector<JobId> ids;
  for (const auto& [id, entry] : entries_) {
    ids.push_back(id);
  }
  // newest first: a running job's end must not start the next queued one
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
    cancel(*id);
  }
}

bool JobRunner::idle() const { return entries_.empty(); }

int JobRunner::activeCount() const {
  return static_cast<int>(
      std::ranges::count_if(entries_, [](const auto& item) { return item.second->state != JobState::Cancelled; }));
}

void JobRunner::tellProgress(JobId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end() || found->second->state != JobState::Running) {
    return;
  }
  double fraction = 0;
  QString phase;
  {
    const std::lock_guard lock(found->second->progressMutex);
    found->second->progressPosted = false;
    fraction = found->second->fraction;
    phase = found->second->phase;
  }
  emit jobProgressed(id, fraction, phase);
}

void JobRunner::tellIdle() {
  if (entries_.empty()) {
    emit becameIdle();
  }
}

QString messageOf(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return QStringLiteral("There is not enough memory for this; close other programs and try again.");
  }
  return QString::fromUtf8(error.what());
}

}  // namespace glisson
