#include "tests/benchmarks/timed_application.h"

#include <QAbstractEventDispatcher>
#include <QDir>
#include <QFile>
#include <QMetaEnum>
#include <QThread>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <utility>

namespace glisson {

namespace {

constexpr double kShownMs = 5;  ///< parts of a long turn that are named

double clockMs(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// How long this thread has waited for a processor so far: "time on the processor, time in the queue, turns", in nanoseconds.
double queuedMs() {
  QFile stat("/proc/thread-self/schedstat");
  const QList<QByteArray> numbers = stat.open(QIODevice::ReadOnly) ? stat.readAll().split(' ') : QList<QByteArray>();
  return numbers.size() > 1 ? numbers[1].toDouble() * 1e-6 : 0;
}

double median(std::vector<double>& values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

void TimedApplication::watch() {
  watching_ = true;
  // Dispatchers tell of themselves in different order: one handles events between the two signals, another outside of them. What
  // both have: the loop looks for news where it is about to block, or where it wakes up without having been.
  const QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
  connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] {
    if (!std::exchange(blocked_, false)) {
      endRound();
    }
  });
  connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] {
    blocked_ = true;
    endRound();
  });
}

void TimedApplication::begin(const QString& name) {
  endRound();
  phase_ = name;
}

std::size_t TimedApplication::enter(const QString& what) {
  const double now = clockMs(CLOCK_MONOTONIC);
  const double cpu = clockMs(CLOCK_THREAD_CPUTIME_ID);
  if (current_.parts.empty()) {
    current_.phase = phase_;
    current_.startMs = now;
    current_.cpuMs = cpu;
    current_.queuedMs = queuedMs();
  }
  current_.parts.push_back({what, depth_++, now, cpu});
  return current_.parts.size() - 1;
}

void TimedApplication::leave(std::size_t part) {
  Part& ended = current_.parts[part];
  ended.wallMs = clockMs(CLOCK_MONOTONIC) - ended.wallMs;
  ended.cpuMs = clockMs(CLOCK_THREAD_CPUTIME_ID) - ended.cpuMs;
  --depth_;
}

void TimedApplication::endRound() {
  if (depth_ > 0 || current_.parts.empty()) {
    return;  // a loop within an event belongs to that event
  }
  current_.wallMs = clockMs(CLOCK_MONOTONIC) - current_.startMs;
  current_.cpuMs = clockMs(CLOCK_THREAD_CPUTIME_ID) - current_.cpuMs;
  current_.queuedMs = queuedMs() - current_.queuedMs;
  current_.aloneMs = current_.cpuMs + drawingMs();
  rounds_.push_back(std::move(current_));
  current_ = {};
}

double TimedApplication::drawingMs() {
  double busiest = 0;
  for (const QString& task : QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    QFile name("/proc/self/task/" + task + "/comm");
    if (name.open(QIODevice::ReadOnly) && name.readAll().startsWith("llvmpipe")) {
      const int id = task.toInt();
      constexpr unsigned kThreadClock = 6;  // the kernel's clock of the processor time of one thread
      const double now = clockMs(static_cast<clockid_t>((~static_cast<unsigned>(id) << 3U) | kThreadClock));
      busiest = std::max(busiest, now - std::exchange(drawingMs_[id], now));
    }
  }
  return busiest;
}

bool TimedApplication::notify(QObject* receiver, QEvent* event) {
  if (!watching_ || QThread::currentThread() != thread()) {
    return QApplication::notify(receiver, event);
  }
  // the name first: the receiver may not outlive its event
  const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
  const QString what = QString("%1 %2 %3").arg(receiver->metaObject()->className(), receiver->objectName(), type);
  bool handled = false;
  timed(what, [&] { handled = QApplication::notify(receiver, event); });
  return handled;
}

void TimedApplication::report() const {
  QStringList phases;
  for (const Round& round : rounds_) {
    if (!phases.contains(round.phase)) {
      phases << round.phase;
    }
  }
  std::printf("%-14s %7s %10s %10s %10s %10s %10s %6s\n", "phase", "turns", "median ms", "worst ms", "median cpu", "worst cpu",
              "alone ms", ">100");
  for (const QString& phase : phases) {
    std::vector<double> wall;
    std::vector<double> cpu;
    std::vector<double> alone;
    for (const Round& round : rounds_) {
      if (round.phase == phase) {
        wall.push_back(round.wallMs);
        cpu.push_back(round.cpuMs);
        alone.push_back(round.aloneMs);
      }
    }
    if (wall.empty()) {
      continue;
    }
    const double middle = median(wall);
    const double cpuMiddle = median(cpu);
    const auto above = std::ranges::count_if(wall, [](double ms) { return ms > kAnswerMs; });
    std::printf("%-14s %7zu %10.1f %10.1f %10.1f %10.1f %10.1f %6ld\n", qPrintable(phase), wall.size(), middle, wall.back(),
                cpuMiddle, cpu.back(), std::ranges::max(alone), static_cast<long>(above));
  }
  std::puts("\nturns above 100 ms:");
  for (const Round& round : rounds_) {
    if (round.wallMs <= kAnswerMs) {
      continue;
    }
    std::printf("%s at %.3f s: %.0f ms wall, %.0f ms cpu, %.0f ms alone, %.0f ms queued\n", qPrintable(round.phase),
                round.startMs * 1e-3, round.wallMs, round.cpuMs, round.aloneMs, round.queuedMs);
    for (const Part& part : round.parts) {
      if (part.wallMs >= kShownMs) {
        std::printf("    %*s%4.0f wall %4.0f cpu  %s\n", 2 * part.depth, "", part.wallMs, part.cpuMs, qPrintable(part.what));
      }
    }
  }
}

}  // namespace glisson
