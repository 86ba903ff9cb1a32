// Measures how soon the Compare workspace shows the Poisson model of a depth after its slider moved: until the solver is done, the
// surface ready to be drawn, the frame with it drawn, the frame with its error colours drawn.
//   depth_slider [CT SEGMENTATION]     without paths: the sample patient
// Prints a line for each move, and the median and the worst of the ten to depth 7, which follows each other depth.

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/gui/lab_side.h"
#include "app/gui/lab_views.h"
#include "app/gui/lab_workspace.h"
#include "app/gui/main_window.h"
#include "app/jobs/thread_job_runner.h"

namespace glisson {
namespace {

constexpr int kLongestMs = 60000;

/// Milliseconds since the slider moved; -1: not yet.
struct Moments {
  qint64 surface = -1;
  qint64 drawn = -1;
  qint64 coloured = -1;
};

Moments moveTo(MainWindow& window, JobRunner& jobs, int depth) {
  LabSide& side = window.lab().side(0);
  SurfaceView& view = window.lab().views().view(0);
  Moments moments;
  bool colours = false;
  QElapsedTimer clock;
  QObject listener;
  QEventLoop loop;
  QObject::connect(&side, &LabSide::changed, &listener, [&] {
    if (!side.pending() && moments.surface < 0) {
      moments.surface = clock.elapsed();
    }
    colours = !side.pending() && side.surface().errors != nullptr;
  });
  QObject::connect(&view, &VtkWidget::frameDrawn, &listener, [&] {
    if (moments.surface >= 0 && moments.drawn < 0) {
      moments.drawn = clock.elapsed();
    }
    if (colours && moments.coloured < 0) {
      moments.coloured = clock.elapsed();
    }
    if (moments.coloured >= 0 && jobs.idle()) {
      loop.quit();
    }
  });
  // an event loop as the program's own: QTest's waits sleep between events
  QObject::connect(&jobs, &JobRunner::becameIdle, &loop, [&] {
    if (moments.coloured >= 0) {
      loop.quit();
    }
  });
  clock.start();
  window.findChild<QSlider*>("labDepth")->setValue(depth);
  QTimer::singleShot(kLongestMs, &loop, &QEventLoop::quit);
  loop.exec();
  return moments;
}

int measure(const QStringList& paths) {
  QTemporaryDir folder;
  Language language;
  language.use("en");
  std::optional<ThreadJobRunner> jobs(std::in_place, 2);
  MainWindow window(*jobs, language, folder.filePath("recovery").toStdString());
  window.resize(1440, 900);
  window.show();
  if (paths.isEmpty()) {
    window.opener().openSample();
  } else {
    window.opener().openPaths(paths);
  }
  const bool ready =
      QTest::qWaitFor([&] { return window.document().isOpen() && jobs->idle() && window.builder().missing() == 0; }, 120000);
  if (!ready) {
    std::puts("the case cannot be opened");
    return 4;
  }
  window.workspaces().setCurrent(Workspace::Compare);
  std::puts("depth triangles solver_ms surface_ms drawn_ms coloured_ms");
  std::vector<qint64> drawn;
  for (const int depth : {6, 7, 5, 7, 8, 7, 6, 7, 5, 7, 8, 7, 6, 7, 5, 7, 8, 7, 6, 7}) {
    const Moments moments = moveTo(window, *jobs, depth);
    if (depth == 7) {
      drawn.push_back(moments.drawn);
    }
    const auto& made = window.lab().side(0).reconstruction();
    const auto& model = window.lab().side(0).model();
    std::printf("%5d %9zu %9.0f %10lld %8lld %11lld\n", depth, made ? made->mesh.triangles.size() : 0,
                model ? 1e3 * model->seconds.total() : 0, static_cast<long long>(moments.surface),
                static_cast<long long>(moments.drawn), static_cast<long long>(moments.coloured));
  }
  std::ranges::sort(drawn);
  std::printf("depth 7 drawn: median %lld, worst %lld ms\n", static_cast<long long>(drawn[drawn.size() / 2]),
              static_cast<long long>(drawn.back()));
  jobs.reset();
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
  const QApplication application(argc, argv);
  return glisson::measure(QApplication::arguments().mid(1));
}
