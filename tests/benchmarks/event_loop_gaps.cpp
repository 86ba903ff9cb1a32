// Measures how long the window does not answer: every event the UI thread handles is timed (wall clock and CPU time of that thread)
// while a case is opened, reconstructed, planned, compared, saved, exported, shown in two languages, and opened again.
//   event_loop_gaps [CT SEGMENTATION]     without paths: the sample patient
// Prints, per phase: turns of the event loop, their median and worst, and every turn above 100 ms with what ran in it; then how
// long the work went on after a cancel.

#include <QEventLoop>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>
#include <cstdio>

#include "app/gui/compare_window.h"
#include "app/gui/export_panel.h"
#include "app/gui/main_window.h"
#include "app/gui/plane_placer.h"
#include "app/gui/view_area.h"
#include "app/jobs/thread_job_runner.h"
#include "tests/benchmarks/timed_application.h"
#include "viewer/plane_handles.h"

namespace glisson {
namespace {

template <class Until>
bool runUntil(Until until, int seconds) {
  // A loop as the program's own: processEvents() with a time limit spins, and gives timers another rank.
  QEventLoop loop;
  QTimer look;
  bool reached = until();
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    reached = until();
    if (reached) {
      loop.quit();
    }
  });
  look.start(20);
  QTimer::singleShot(seconds * 1000, &loop, &QEventLoop::quit);
  if (!reached) {
    loop.exec();
  }
  return reached;
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

/// Phases in the order of the work; each waits until nothing goes on any more, so that its turns are its own.
class Session {
 public:
  Session(TimedApplication& application, QStringList paths) : application_(application), paths_(std::move(paths)) {
    language_.use("en");
    window_.resize(1600, 1000);
    window_.opener().setUnattended(true);
    QObject::connect(&window_, &MainWindow::failed, [this](const QString& message) { problem_ = message; });
    QObject::connect(&window_.opener(), &CaseOpener::opened, [this] { ++opened_; });
    QObject::connect(&window_.exportPanel(), &ExportPanel::exported, [this] { exported_ = true; });
    QObject::connect(&window_, &MainWindow::reportWritten, [this] { reported_ = true; });
  }

  bool openCase() {
    act("show", [&] {
      window_.show();
      window_.views().modelView().warmUp();
    });
    application_.act("open", [&] { openInputs(); });
    if (!runUntil([&] { return document_.isOpen() || !problem_.isEmpty(); }, 600) || !problem_.isEmpty()) {
      return false;
    }
    application_.begin("reconstruct");
    const bool built = runUntil([&] { return jobs_.idle() && window_.builder().missing() == 0; }, 600);
    rest(kRestMs);
    return built;
  }

  void plan() {
    act("place", [&] { window_.placer().placeAsSeen(); });
    dragPlane(application_, window_.views().modelView());
    settle();
    turnCamera(application_, window_.views().modelView());
    act("bend", [&] { document_.startBend(); });
    act("undo", [&] { document_.undoStack().undo(); });
    act("redo", [&] { document_.undoStack().redo(); });
    act("undo", [&] { document_.undoStack().undo(); });
  }

  void look() {
    auto* axial = window_.findChild<SliceView*>("axialView");
    for (int i = 0; i < 20; ++i) {
      application_.act("slices", [&] { QTest::keyClick(axial, Qt::Key_Up); });
      rest(20);
    }
    const std::string liver = document_.content().model->structures.front().id;
    act("hide", [&] { document_.setVisible(liver, false); });
    act("show again", [&] { document_.setVisible(liver, true); });
    act("opacity", [&] { document_.setOpacity(liver, 0.6); });
    for (const Workspace step : {Workspace::Case, Workspace::Model, Workspace::Export, Workspace::Plan}) {
      act("steps", [&] { window_.workspaces().setCurrent(step); });
    }
  }

  void compare() {
    act("methods", [&] { window_.workspaces().setCurrent(Workspace::Compare); });
    act("methods", [&] { window_.findChild<QSlider*>("labDepth")->setValue(6); });
    act("methods", [&] { window_.workspaces().setCurrent(Workspace::Plan); });
    act("plans", [&] { document_.duplicatePlan(); });
    act("plans", [&] { window_.findChild<QAction*>("actionComparePlans")->trigger(); });
    if (auto* plans = window_.findChild<CompareWindow*>("compareWindow")) {
      act("plans", [&] { plans->close(); });
    }
    act("plans", [&] { document_.undoStack().undo(); });
  }

  void write() {
    application_.act("save", [&] { document_.saveAs(caseFile()); });
    runUntil([&] { return document_.isClean(); }, 120);
    rest(500);
    act("export", [&] {
      window_.workspaces().setCurrent(Workspace::Export);
      window_.exportPanel().exportTo(folder_.path());
    });
    if (auto* accept = window_.findChild<QPushButton*>("deviationAccept")) {
      act("export", [&] { accept->click(); });
    }
    runUntil([&] { return exported_ || !problem_.isEmpty(); }, 300);
    rest(500);
    application_.act("report", [&] { window_.writeReport(folder_.filePath("plan.pdf")); });
    runUntil([&] { return reported_ || !problem_.isEmpty(); }, 120);
    rest(500);
    act("language", [&] { window_.setLanguage("de"); });
  }

  void openAgain() {
    application_.act("open anew", [&] { openInputs(); });
    runUntil([&] { return opened_ > 1 || !problem_.isEmpty(); }, 600);
    rest(300);
    application_.act("cancel", [&] { jobs_.cancelAll(); });
    QElapsedTimer clock;
    clock.start();
    runUntil([&] { return jobs_.idle(); }, 120);
    windingDownMs_ = clock.elapsed();
    rest(kRestMs);
    application_.act("reopen", [&] { window_.opener().openPaths({QString::fromStdString(caseFile())}); });
    rest(500);
    settle();
    act("close", [&] { window_.close(); });
  }

  int report() const {
    application_.report();
    std::printf("\nwork went on for %lld ms after the cancel\n", static_cast<long long>(windingDownMs_));
    if (!exported_ || !problem_.isEmpty()) {
      std::fprintf(stderr, "exported: %d; %s\n", exported_ ? 1 : 0, qPrintable(problem_));
      return 4;
    }
    return 0;
  }

 private:
  static constexpr int kRestMs = 1500;

  void openInputs() { paths_.isEmpty() ? window_.opener().openSample() : window_.opener().openPaths(paths_); }
  [[nodiscard]] std::string caseFile() const { return folder_.filePath("case.glisson").toStdString(); }
  /// Until all is computed and drawn.
  void settle() {
    runUntil([&] { return jobs_.idle(); }, 120);
    rest(kRestMs);
  }
  template <class Act>
  void act(const QString& phase, Act act) {
    application_.act(phase, act);
    settle();
  }

  TimedApplication& application_;
  QStringList paths_;
  QTemporaryDir folder_;
  Language language_;
  ThreadJobRunner jobs_{2};
  MainWindow window_{jobs_, language_, folder_.filePath("recovery").toStdString()};
  Document& document_ = window_.document();
  QString problem_;
  bool exported_ = false;
  bool reported_ = false;
  int opened_ = 0;
  qint64 windingDownMs_ = 0;
};

int measure(TimedApplication& application, const QStringList& paths) {
  application.watch();
  Session session(application, paths);
  if (session.openCase()) {
    session.plan();
    session.look();
    session.compare();
    session.write();
    session.openAgain();
  }
  return session.report();
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
