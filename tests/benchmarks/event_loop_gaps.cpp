// Measures how long the window does not answer: every event the UI thread handles is timed (wall clock and CPU time of that thread)
// while a case is opened, reconstructed, planned, saved, exported and shown in two languages.
//   event_loop_gaps [CT SEGMENTATION]     without paths: the sample patient
// Prints, per phase: events, median and worst round of the event loop, and every round above 100 ms with what ran in it.

#include <sys/resource.h>

#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QElapsedTimer>
#include <QMetaEnum>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "app/gui/export_panel.h"
#include "app/gui/main_window.h"
#include "app/gui/plane_placer.h"
#include "app/gui/view_area.h"
#include "app/jobs/thread_job_runner.h"
#include "viewer/plane_handles.h"

namespace glisson {
namespace {

constexpr double kLimitMs = 100.0;

double cpuMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

struct Part {
  QString what;
  double wallMs = 0;
  double cpuMs = 0;
};

/// One turn of the event loop, from waking up to waiting again.
struct Round {
  QString phase;
  double wallMs = 0;
  double cpuMs = 0;
  std::vector<Part> parts;
};

class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  QString phase = "start";
  std::vector<Round> rounds;

  void watch() {
    const QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
    connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] { beginRound(); });
    connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] { endRound(); });
    beginRound();
  }
  /// What is called from outside the event loop counts as a part of the round too.
  template <class Act>
  void act(const QString& name, Act act) {
    endRound();
    phase = name;
    beginRound();
    timed(name + " (call)", act);
  }

 protected:
  bool notify(QObject* receiver, QEvent* event) override {
    if (inside_) {
      return QApplication::notify(receiver, event);
    }
    // the name first: the receiver may not outlive its event
    const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
    const QString what = QString("%1 %2 %3").arg(receiver->metaObject()->className(), receiver->objectName(), type);
    bool handled = false;
    timed(what, [&] { handled = QApplication::notify(receiver, event); });
    return handled;
  }

 private:
  template <class Act>
  void timed(const QString& what, Act act) {
    inside_ = true;
    QElapsedTimer wall;
    wall.start();
    const double cpu = cpuMs();
    act();
    current_.parts.push_back({what, static_cast<double>(wall.nsecsElapsed()) * 1e-6, cpuMs() - cpu});
    inside_ = false;
  }
  void beginRound() {
    endRound();
    current_ = {phase, 0, 0, {}};
    clock_.start();
    cpu_ = cpuMs();
    running_ = true;
  }
  void endRound() {
    if (!running_) {
      return;
    }
    running_ = false;
    current_.wallMs = static_cast<double>(clock_.nsecsElapsed()) * 1e-6;
    current_.cpuMs = cpuMs() - cpu_;
    rounds.push_back(std::move(current_));
    current_ = {};
  }

  bool inside_ = false;
  bool running_ = false;
  QElapsedTimer clock_;
  double cpu_ = 0;
  Round current_;
};

template <class Until>
bool runUntil(Until until, int seconds) {
  QElapsedTimer clock;
  clock.start();
  while (!until()) {
    if (clock.elapsed() > seconds * 1000) {
      return false;
    }
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
  }
  return true;
}

void rest(int milliseconds) {
  QElapsedTimer clock;
  clock.start();
  runUntil([&] { return clock.elapsed() > milliseconds; }, 60);
}

void dragPlane(TimedApplication& application, ModelView& view) {
  const std::optional<HandleLayout> layout = view.handles();
  if (!layout) {
    return;
  }
  const ViewCamera camera = view.camera();
  const Pixel centre = camera.toPixel(layout->anchor);
  const auto at = [&](int step) { return QPoint(qRound(centre.x()) + 2 * step, qRound(centre.y()) + step); };
  constexpr int kSteps = 30;
  application.act("drag", [&] { QTest::mousePress(&view, Qt::LeftButton, {}, at(0)); });
  for (int step = 1; step <= kSteps; ++step) {
    application.act("drag", [&] { QTest::mouseMove(&view, at(step)); });
    rest(20);
  }
  application.act("drag", [&] { QTest::mouseRelease(&view, Qt::LeftButton, {}, at(kSteps)); });
}

void turnCamera(TimedApplication& application, ModelView& view) {
  const QPoint corner(view.width() / 8, view.height() / 8);
  application.act("turn", [&] { QTest::mousePress(&view, Qt::LeftButton, {}, corner); });
  for (int step = 1; step <= 30; ++step) {
    application.act("turn", [&] { QTest::mouseMove(&view, corner + QPoint(3 * step, step)); });
    rest(20);
  }
  application.act("turn", [&] { QTest::mouseRelease(&view, Qt::LeftButton, {}, corner + QPoint(90, 30)); });
  rest(1500);
}

void report(const std::vector<Round>& rounds) {
  QStringList phases;
  for (const Round& round : rounds) {
    if (!phases.contains(round.phase)) {
      phases << round.phase;
    }
  }
  std::printf("%-14s %7s %10s %10s %10s %10s %6s\n", "phase", "rounds", "median ms", "worst ms", "median cpu", "worst cpu", ">100");
  for (const QString& phase : phases) {
    std::vector<double> wall;
    std::vector<double> cpu;
    for (const Round& round : rounds) {
      if (round.phase == phase && !round.parts.empty()) {
        wall.push_back(round.wallMs);
        cpu.push_back(round.cpuMs);
      }
    }
    if (wall.empty()) {
      continue;
    }
    std::ranges::sort(wall);
    std::ranges::sort(cpu);
    const auto above = std::ranges::count_if(cpu, [](double ms) { return ms > kLimitMs; });
    std::printf("%-14s %7zu %10.1f %10.1f %10.1f %10.1f %6ld\n", qPrintable(phase), wall.size(), wall[wall.size() / 2], wall.back(),
                cpu[cpu.size() / 2], cpu.back(), static_cast<long>(above));
  }
  std::puts("\nrounds above 100 ms:");
  for (Round round : rounds) {
    if (round.wallMs <= kLimitMs) {
      continue;
    }
    std::printf("%s: %.0f ms wall, %.0f ms cpu\n", qPrintable(round.phase), round.wallMs, round.cpuMs);
    std::ranges::sort(round.parts, std::ranges::greater(), &Part::wallMs);
    for (std::size_t i = 0; i < std::min<std::size_t>(5, round.parts.size()); ++i) {
      if (round.parts[i].wallMs >= 5) {
        std::printf("    %6.0f wall %6.0f cpu  %s\n", round.parts[i].wallMs, round.parts[i].cpuMs, qPrintable(round.parts[i].what));
      }
    }
  }
}

int measure(TimedApplication& application, const QStringList& paths) {
  const QTemporaryDir folder;
  Language language;
  language.use("en");
  ThreadJobRunner jobs(2);
  MainWindow window(jobs, language, folder.filePath("recovery").toStdString());
  window.resize(1600, 1000);
  application.watch();
  application.act("show", [&] { window.show(); });
  rest(1000);
  window.opener().setUnattended(true);
  QString problem;
  QObject::connect(&window, &MainWindow::failed, [&](const QString& message) { problem = message; });
  application.act("open", [&] { paths.isEmpty() ? window.opener().openSample() : window.opener().openPaths(paths); });
  if (!runUntil([&] { return window.document().isOpen() || !problem.isEmpty(); }, 600) || !problem.isEmpty()) {
    std::fprintf(stderr, "not opened: %s\n", qPrintable(problem));
    return 3;
  }
  application.act("reconstruct", [] {});
  const bool built = runUntil([&] { return jobs.idle() && window.builder().missing() == 0; }, 600);
  rest(2000);
  application.act("place", [&] { window.placer().placeAsSeen(); });
  runUntil([&] { return jobs.idle() && window.document().freshness() == Freshness::All; }, 120);
  rest(2000);
  dragPlane(application, window.views().modelView());
  runUntil([&] { return jobs.idle(); }, 120);
  rest(2000);
  turnCamera(application, window.views().modelView());
  application.act("undo", [&] { window.document().undoStack().undo(); });
  runUntil([&] { return jobs.idle(); }, 120);
  rest(1000);
  auto* axial = window.findChild<SliceView*>("axialView");
  for (int i = 0; i < 20; ++i) {
    application.act("slices", [&] { QTest::keyClick(axial, Qt::Key_Up); });
    rest(20);
  }
  application.act("save", [&] { window.document().saveAs(folder.filePath("case.glisson").toStdString()); });
  runUntil([&] { return window.document().isClean(); }, 120);
  rest(500);
  bool exported = false;
  QObject::connect(&window.exportPanel(), &ExportPanel::exported, [&] { exported = true; });
  application.act("export", [&] {
    window.workspaces().setCurrent(Workspace::Export);
    window.exportPanel().exportTo(folder.path());
    if (auto* accept = window.findChild<QPushButton*>("deviationAccept")) {
      accept->click();
    }
  });
  runUntil([&] { return exported || !problem.isEmpty(); }, 300);
  rest(500);
  application.act("language", [&] { window.setLanguage("de"); });
  rest(1500);
  application.act("reopen", [&] { window.opener().openPaths({folder.filePath("case.glisson")}); });
  rest(500);
  runUntil([&] { return jobs.idle(); }, 120);
  rest(2000);
  application.act("close", [&] { window.close(); });
  report(application.rounds);
  if (!built || !exported) {
    std::fprintf(stderr, "built %d, exported %d: %s\n", built ? 1 : 0, exported ? 1 : 0, qPrintable(problem));
    return 4;
  }
  return 0;
}

}  // namespace
}  // namespace glisson

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  const QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  glisson::VtkWidget::prepareSurfaceFormat();
  glisson::TimedApplication application(argc, argv);
  return glisson::measure(application, application.arguments().mid(1));
}
