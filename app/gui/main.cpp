// glisson: the window. Starts Qt, reads the command line, opens what was asked for.

#include <QApplication>
#include <QIcon>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <optional>

#include "app/gui/main_window.h"
#include "app/gui/screenshot.h"
#include "app/gui/start_options.h"
#include "app/gui/view_area.h"
#include "app/jobs/thread_job_runner.h"
#include "reconstruction/errors.h"
#include "viewer/model_view.h"
#include "viewer/vtk_widget.h"

namespace {

int tell(const QString& message, int exitCode) {
  std::fprintf(stderr, "glisson: %s\n", qPrintable(message));
  return exitCode;
}

void nameApplication() {
  QApplication::setApplicationName("glisson");
  QApplication::setApplicationDisplayName("Glisson");
  QApplication::setOrganizationName("glisson");
  QApplication::setApplicationVersion(GLISSON_VERSION);
}

int run(QApplication& application, const glisson::StartOptions& options) {
  using namespace glisson;
  QApplication::setWindowIcon(QIcon(":/icons/glisson.svg"));
  const bool picture = !options.screenshot.isEmpty() || !options.pdf.isEmpty();
  QTemporaryDir temporary;  // a picture leaves no case behind
  const QString data = picture ? temporary.path() : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);

  Language language;
  language.use(options.language.isEmpty() ? Language::preferred() : options.language);
  std::optional<ThreadJobRunner> jobs(std::in_place, 2);
  int exitCode = 0;
  {
    MainWindow window(*jobs, language, std::filesystem::path((data + "/recovery").toStdString()));
    window.resize(options.size);
    window.opener().setOptions(options.read);
    window.opener().setUnattended(picture);
    if (picture) {
      auto* taker = new ScreenshotTaker(window, *jobs,
                                        {.picture = options.screenshot,
                                         .report = options.pdf,
                                         .plan = options.plan,
                                         .placePlane = options.sample,
                                         .withIdentity = options.identity});
      QObject::connect(taker, &ScreenshotTaker::done, &application, [&exitCode](int code, const QString& message) {
        exitCode = code == 0 ? 0 : tell(message, code);
        QApplication::exit(exitCode);
      });
    }
    window.show();
    window.views().modelView().warmUp();
    QTimer::singleShot(0, &window, [&window, &options] {
      if (options.sample) {
        window.opener().openSample();
      } else if (!options.paths.isEmpty()) {
        window.opener().openPaths(options.paths);
      }
    });
    exitCode = QApplication::exec();
    jobs.reset();  // cancels what runs and waits for it while the window it reports to still lives
  }
  return exitCode;
}

}  // namespace

int main(int argc, char** argv) {
  glisson::VtkWidget::prepareSurfaceFormat();
  QApplication application(argc, argv);
  std::setlocale(LC_ALL, "C");  // QApplication has set the user's: readers and writers must see a decimal point
  nameApplication();
  try {
    const glisson::StartOptions options = glisson::parseStartOptions(QApplication::arguments().mid(1));
    if (options.help) {
      std::fputs(qPrintable(glisson::usageText()), stdout);
      return 0;
    }
    if (options.version) {
      std::puts("glisson " GLISSON_VERSION);
      return 0;
    }
    return run(application, options);
  } catch (const glisson::UsageError& error) {
    return tell(QString::fromUtf8(error.what()), 2);
  } catch (const std::exception& error) {
    return tell(QString::fromUtf8(error.what()), 3);
  }
}
