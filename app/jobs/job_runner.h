#pragma once
// Purpose: background work of the window. A job is process(ExecutionContext) on a worker and finish() on the UI thread; an
// exception of process() travels to fail() on the UI thread. Two runners with the same behaviour: QThreads (the program), inline
// (tests). Every member is called on the UI thread (the runner's own), every signal is emitted there.

#include <QObject>
#include <QString>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "reconstruction/execution_context.h"

namespace glisson {

using JobId = quint64;

enum class JobState : std::uint8_t { Queued, Running, Done, Failed, Cancelled };

struct JobRequest {
  QString key{};       ///< a newer request with the same key replaces an older one; empty: never replaced
  QString title{};     ///< shown in the job bar
  bool heavy = false;  ///< waits until fewer than the runner's limit of heavy jobs run; the others start at once
  bool quiet = false;  ///< not shown in the job bar
  std::function<void(const ExecutionContext&)> process{};
  std::function<void()> finish{};                     ///< may be empty
  std::function<void(const std::exception&)> fail{};  ///< may be empty; never called for Cancelled
};

class JobRunner : public QObject {
  Q_OBJECT
 public:
  /// At most `heavyLimit` heavy jobs at a time.
  explicit JobRunner(int heavyLimit, QObject* parent = nullptr);
  ~JobRunner() override;

  /// Starts or queues the job. A job of the same key that has not finished is cancelled first and its result dropped.
  JobId submit(JobRequest request);
  /// Shown as cancelled at once; its thread ends when the work next polls; a late result is dropped. Unknown ids: nothing.
  void cancel(JobId id);
  void cancelAll();
  /// Nothing is queued, running, or still winding down after a cancel.
  [[nodiscard]] bool idle() const;
  /// Jobs that are queued or running now.
  [[nodiscard]] int activeCount() const;

 signals:
  void jobAdded(glisson::JobId id, const QString& title, bool quiet);
  void jobStarted(glisson::JobId id);
  void jobProgressed(glisson::JobId id, double fraction, const QString& phase);
  /// `message` is empty but for Failed.
  void jobEnded(glisson::JobId id, glisson::JobState state, const QString& message);
  void becameIdle();

 protected:
  /// Runs `work` (never throws) somewhere, later, then calls workEnded(id) on the runner's thread.
  virtual void launch(JobId id, std::function<void()> work) = 0;
  void workEnded(JobId id);

 private:
  struct Entry;
  void schedule();
  void start(JobId id, const std::shared_ptr<Entry>& entry);
  void conclude(JobId id, Entry& entry);
  void tellProgress(JobId id);
  void tellIdle();

  int heavyLimit_;
  JobId nextId_ = 1;
  std::map<JobId, std::shared_ptr<Entry>> entries_;
};

/// submit() for work with a result: process returns a value, finish receives it.
template <class Result>
JobId submitFor(JobRunner& runner, JobRequest request, std::function<Result(const ExecutionContext&)> process,
                std::function<void(Result)> finish) {
  auto result = std::make_shared<std::optional<Result>>();
  request.process = [result, work = std::move(process)](const ExecutionContext& context) { result->emplace(work(context)); };
  request.finish = [result, done = std::move(finish)] { done(std::move(result->value())); };
  return runner.submit(std::move(request));
}

/// One English sentence, shown through shownSentence(): an Error's own, "not enough memory", or the foreign text.
QString messageOf(const std::exception& error);

}  // namespace glisson
