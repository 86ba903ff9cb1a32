#pragma once
// Purpose: `glisson --screenshot` and `--pdf`: waits until every structure is made and every number computed, then writes the
// picture of the whole window, 3D included, or the report.

#include <QImage>
#include <QObject>

#include "app/jobs/job_runner.h"

namespace glisson {

class MainWindow;

/// The window as it is now; the 3D views as VtkWidget::picture() gives them, with what lies over them.
QImage pictureOf(MainWindow& window);

class ScreenshotTaker : public QObject {
  Q_OBJECT
 public:
  /// Either path may be empty. `placePlane`: puts the first plane where the plan is empty (the sample patient's picture).
  /// `withIdentity`: the report names the patient.
  ScreenshotTaker(MainWindow& window, JobRunner& jobs, QString picture, QString report, bool placePlane, bool withIdentity);

 signals:
  /// 0: written. 3: an input was refused or the file cannot be written. 4: a structure could not be made. `message` is empty for 0.
  void done(int exitCode, const QString& message);

 private:
  void proceed();
  void write();
  void finish(int exitCode, const QString& message);
  MainWindow& window_;
  JobRunner& jobs_;
  QString picture_;
  QString report_;
  bool placePlane_;
  bool withIdentity_;
  bool reporting_ = false;
  bool finished_ = false;
};

}  // namespace glisson
