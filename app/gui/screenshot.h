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
  struct What {
    QString picture{};          ///< path of a PNG; this or the next may be empty
    QString report{};           ///< path of a PDF
    QString plan{};             ///< name of the plan; empty: the first
    bool placePlane = false;    ///< puts the first plane where the plan is empty (the sample patient's picture)
    bool withIdentity = false;  ///< the report names the patient
  };
  /// Territories that a person has confirmed are estimated for both.
  ScreenshotTaker(MainWindow& window, JobRunner& jobs, What what);

 signals:
  /// 0: written. 2: the case has no such plan. 3: an input was refused or the file cannot be written. 4: a structure could not be
  /// made. `message` is empty for 0.
  void done(int exitCode, const QString& message);

 private:
  void proceed();
  /// Chooses the plan, or ends where there is none of that name.
  void choosePlan();
  void write();
  void finish(int exitCode, const QString& message);
  MainWindow& window_;
  JobRunner& jobs_;
  What what_;
  bool estimated_ = false;  ///< or tried to
  bool reporting_ = false;
  bool finished_ = false;
};

}  // namespace glisson
