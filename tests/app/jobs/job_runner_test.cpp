// Both runners keep the same promises: order, exceptions, cancel, replacement, the limit of heavy jobs.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSemaphore>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <atomic>

#include "app/jobs/inline_job_runner.h"
#include "app/jobs/thread_job_runner.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

std::unique_ptr<JobRunner> makeRunner(bool threads, int limit = 2) {
  if (threads) {
    return std::make_unique<ThreadJobRunner>(limit);
  }
  return std::make_unique<InlineJobRunner>(limit);
}

/// Runs the event loop until the runner is idle; false after 20 s.
bool waitIdle(JobRunner& runner) {
  if (runner.idle()) {
    return true;
  }
  QEventLoop loop;
  QTimer::singleShot(20000, &loop, [&] { loop.exit(1); });
  QObject::connect(&runner, &JobRunner::becameIdle, &loop, [&] { loop.exit(0); });
  return loop.exec() == 0;
}

struct End {
  JobId id;
  JobState state;
  QString message;
};

class JobRunnerTest : public testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<JobRunner> runner = makeRunner(GetParam());
  std::vector<End> ends;
  void SetUp() override {
    QObject::connect(runner.get(), &JobRunner::jobEnded, [this](JobId id, JobState state, const QString& message) {
      ends.push_back({id, state, message});
    });
  }
};

TEST_P(JobRunnerTest, FinishRunsOnTheCallersThreadWithTheResultOfProcess) {
  QThread* const here = QThread::currentThread();
  QThread* worker = nullptr;
  QThread* finisher = nullptr;
  int got = 0;
  submitFor<int>(
      *runner, {.title = "answer"},
      [&](const ExecutionContext&) {
        worker = QThread::currentThread();
        return 42;
      },
      [&](int value) {
        finisher = QThread::currentThread();
        got = value;
      });
  EXPECT_EQ(got, 0) << "submit() itself must not run the work";
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_EQ(got, 42);
  EXPECT_EQ(finisher, here);
  EXPECT_EQ(worker != here, GetParam());
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].state, JobState::Done);
}

TEST_P(JobRunnerTest, AnExceptionTravelsToTheUiThread) {
  bool finished = false;
  std::string said;
  runner->submit({.title = "refused",
                  .process = [](const ExecutionContext&) { throw InputError("scan.nii is truncated"); },
                  .finish = [&] { finished = true; },
                  .fail =
                      [&](const std::exception& error) {
                        EXPECT_NE(dynamic_cast<const InputError*>(&error), nullptr);
                        said = error.what();
                      }});
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_FALSE(finished);
  EXPECT_EQ(said, "scan.nii is truncated");
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].state, JobState::Failed);
  EXPECT_EQ(ends[0].message, "scan.nii is truncated");
}

TEST_P(JobRunnerTest, WhatIsNoStandardExceptionAndLackOfMemoryBecomeMessagesToo) {
  const JobId foreign =
      runner->submit({.process = [](const ExecutionContext&) { throw 7; }});  // NOLINT: a foreign throw is the case
  const JobId memory = runner->submit({.process = [](const ExecutionContext&) { throw std::bad_alloc(); }});
  ASSERT_TRUE(waitIdle(*runner));
  ASSERT_EQ(ends.size(), 2U);
  // on threads the two end in either order
  const auto endOf = [this](JobId id) { return *std::ranges::find(ends, id, &End::id); };
  EXPECT_EQ(endOf(foreign).state, JobState::Failed);
  EXPECT_FALSE(endOf(foreign).message.isEmpty());
  EXPECT_EQ(endOf(memory).state, JobState::Failed);
  EXPECT_TRUE(endOf(memory).message.contains("memory"));
}

TEST_P(JobRunnerTest, AFinishThatThrowsIsAFailure) {
  runner->submit({.process = [](const ExecutionContext&) {}, .finish = [] { throw PlanningError("no liver"); }});
  ASSERT_TRUE(waitIdle(*runner));
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].state, JobState::Failed);
  EXPECT_EQ(ends[0].message, "no liver");
}

TEST_P(JobRunnerTest, TheNewestRequestReplacesAnOlderOneOfTheSameKey) {
  std::vector<int> finished;
  for (int i = 0; i < 5; ++i) {
    submitFor<int>(
        *runner, {.key = "assess"}, [i](const ExecutionContext&) { return i; }, [&](int value) { finished.push_back(value); });
  }
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_EQ(finished, std::vector<int>{4});
  EXPECT_EQ(std::ranges::count_if(ends, [](const End& end) { return end.state == JobState::Cancelled; }), 4);
}

TEST_P(JobRunnerTest, DifferentKeysAndNoKeyDoNotReplaceEachOther) {
  int finished = 0;
  for (const char* key : {"a", "b", "", ""}) {
    runner->submit({.key = key, .process = [](const ExecutionContext&) {}, .finish = [&] { ++finished; }});
  }
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_EQ(finished, 4);
}

TEST_P(JobRunnerTest, ACancelledJobIsShownAtOnceAndItsLateResultIsDropped) {
  bool finished = false;
  const JobId id = runner->submit({.process = [](const ExecutionContext&) {}, .finish = [&] { finished = true; }});
  runner->cancel(id);
  ASSERT_EQ(ends.size(), 1U) << "reported within the call itself";
  EXPECT_EQ(ends[0].state, JobState::Cancelled);
  runner->cancel(id);
  runner->cancel(9999);
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_FALSE(finished);
  EXPECT_EQ(ends.size(), 1U);
}

TEST_P(JobRunnerTest, ProgressArrivesOnTheUiThreadAndTheLastValueIsNotLost) {
  QThread* const here = QThread::currentThread();
  double last = -1;
  QString phase;
  QObject::connect(runner.get(), &JobRunner::jobProgressed, [&](JobId, double fraction, const QString& name) {
    EXPECT_EQ(QThread::currentThread(), here);
    EXPECT_GE(fraction, last);
    last = fraction;
    phase = name;
  });
  runner->submit({.process = [](const ExecutionContext& context) {
    for (int i = 0; i <= 1000; ++i) {
      context.report(i / 1000.0, "solve");
    }
  }});
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(phase, "solve");
}

TEST_P(JobRunnerTest, CancelAllEndsQueuedAndRunningJobs) {
  int finished = 0;
  for (int i = 0; i < 6; ++i) {
    runner->submit({.heavy = true, .process = [](const ExecutionContext&) {}, .finish = [&] { ++finished; }});
  }
  runner->cancelAll();
  EXPECT_EQ(ends.size(), 6U);
  EXPECT_EQ(runner->activeCount(), 0);
  ASSERT_TRUE(waitIdle(*runner));
  EXPECT_EQ(finished, 0);
}

INSTANTIATE_TEST_SUITE_P(Runners, JobRunnerTest, testing::Values(false, true),
                         [](const auto& runner) { return runner.param ? "Threads" : "Inline"; });

TEST(ThreadJobRunnerTest, ACancelIsReportedWhileTheWorkStillRuns) {
  ThreadJobRunner runner;
  QSemaphore started;
  QSemaphore mayEnd;
  bool reported = false;
  QObject::connect(&runner, &JobRunner::jobEnded, [&](JobId, JobState state) { reported = state == JobState::Cancelled; });
  const JobId id = runner.submit({.process = [&](const ExecutionContext&) {
    started.release();
    mayEnd.acquire();  // deaf to cancel, as a VTK filter is
  }});
  started.acquire();
  runner.cancel(id);
  EXPECT_TRUE(reported) << "before the job has answered";
  EXPECT_FALSE(runner.idle()) << "the thread is still winding down";
  mayEnd.release();
  EXPECT_TRUE(waitIdle(runner));
}

TEST(ThreadJobRunnerTest, ResultsThatCameTogetherAreTakenInSeparateTurnsOfTheEventLoop) {
  ThreadJobRunner runner;
  QSemaphore done;
  int taken = 0;
  constexpr int kJobs = 5;
  for (int n = 0; n < kJobs; ++n) {
    runner.submit({.process = [&](const ExecutionContext&) { done.release(); }, .finish = [&] { ++taken; }});
  }
  ASSERT_TRUE(done.tryAcquire(kJobs, 20000));
  QThread::msleep(50);  // the threads end
  QElapsedTimer clock;
  clock.start();
  while (taken < kJobs && clock.elapsed() < 20000) {
    const int before = taken;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_LE(taken - before, 1);
  }
  EXPECT_EQ(taken, kJobs);
}

TEST(ThreadJobRunnerTest, NoMoreHeavyJobsThanTheLimitRunAtOnceAndLightOnesDoNotWait) {
  ThreadJobRunner runner(2);
  std::atomic<int> running = 0;
  std::atomic<int> most = 0;
  QSemaphore gate;
  QSemaphore entered;
  for (int i = 0; i < 6; ++i) {
    runner.submit({.heavy = true, .process = [&](const ExecutionContext&) {
                     const int now = ++running;
                     int seen = most;
                     while (seen < now && !most.compare_exchange_weak(seen, now)) {
                     }
                     entered.release();
                     gate.acquire();
                     --running;
                   }});
  }
  bool lightDone = false;
  QEventLoop loop;
  QTimer::singleShot(20000, &loop, [&] { loop.exit(1); });
  runner.submit({.process = [](const ExecutionContext&) {},
                 .finish =
                     [&] {
                       lightDone = true;
                       loop.exit(0);
                     }});
  EXPECT_EQ(loop.exec(), 0);
  EXPECT_TRUE(lightDone);
  entered.acquire(2);
  gate.release(6);
  ASSERT_TRUE(waitIdle(runner));
  EXPECT_EQ(most, 2);
}

TEST(ThreadJobRunnerTest, TheDestructorCancelsAndWaitsForItsThreads) {
  std::atomic<bool> ended = false;
  QSemaphore started;
  {
    ThreadJobRunner runner;
    runner.submit({.process = [&](const ExecutionContext& context) {
      started.release();
      while (!context.isCancelled()) {
        QThread::yieldCurrentThread();
      }
      ended = true;
    }});
    started.acquire();
  }
  EXPECT_TRUE(ended);
}

TEST(ThreadJobRunnerTest, ThreadsThatHelpAJobGiveWayToTheWindowLikeItsOwn) {
  const auto priorities = [] {
    std::atomic<int> least{100};
    parallelFor(64, 1, [&](std::size_t, std::size_t) {
      QThread::msleep(2);  // long enough that the helpers come
      least = std::min(least.load(), getpriority(PRIO_PROCESS, 0));
    });
    return least.load();
  };
  priorities();  // the helpers exist, with the priority of this thread
  ThreadJobRunner runner(1);
  int background = -20;
  submitFor<int>(
      runner, {}, [&](const ExecutionContext&) { return priorities(); }, [&](int least) { background = least; });
  ASSERT_TRUE(waitIdle(runner));
  EXPECT_GE(background, 10);
}

}  // namespace
}  // namespace glisson

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
