#pragma once
// Purpose: times what the UI thread does, turn by turn of the event loop. Wall clock and processor time of that thread,
// milliseconds.

#include <QApplication>
#include <map>
#include <vector>

namespace glisson {

/// The window answers within this time.
inline constexpr double kAnswerMs = 100.0;

/// One event, or one call from outside the event loop.
struct Part {
  QString what;
  int depth = 0;  ///< events that are handled within others are deeper
  double wallMs = 0;
  double cpuMs = 0;
};

/// One turn of the event loop: from the first event that is handled to the last one before the loop looks for news from outside.
struct Round {
  QString phase;
  double startMs = 0;  ///< of the monotonic clock, as `perf record -k mono` has it
  double wallMs = 0;
  double cpuMs = 0;
  double queuedMs = 0;  ///< ready to run while others had the processors
  double aloneMs =
      0;  ///< cpuMs and what the busiest thread of the software OpenGL took: the wall clock of a machine without other work
  std::vector<Part> parts;
};

class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  /// From now on.
  void watch();

  /// What is called from outside the event loop counts as a part of its turn too; what follows belongs to phase `name`.
  template <class Act>
  void act(const QString& name, Act act) {
    begin(name);
    timed(name + " (call)", act);
  }
  void begin(const QString& name);

  /// A line for each phase, and every turn above kAnswerMs with what ran in it, on standard output.
  void report() const;

 protected:
  bool notify(QObject* receiver, QEvent* event) override;

 private:
  template <class Act>
  void timed(const QString& what, Act act) {
    const std::size_t at = enter(what);
    act();
    leave(at);
  }
  std::size_t enter(const QString& what);
  void leave(std::size_t part);
  void endRound();
  /// Of the busiest thread of the software OpenGL since the last call.
  double drawingMs();

  QString phase_ = "start";
  std::vector<Round> rounds_;
  std::map<int, double> drawingMs_;  ///< of the threads of the software OpenGL until the last turn
  bool watching_ = false;
  bool blocked_ = false;  ///< since the loop last woke up
  int depth_ = 0;
  Round current_;
};

}  // namespace glisson
