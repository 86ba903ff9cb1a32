#pragma once
// Purpose: the line at the bottom: what runs, each with its progress and a Cancel; how many wait; what ended, told quietly; what
// the mouse does; "not for clinical use".

#include <QMap>
#include <QTimer>
#include <QWidget>

#include "app/gui/translated.h"
#include "app/jobs/job_runner.h"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace glisson {

class JobBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit JobBar(JobRunner& jobs, QWidget* parent = nullptr);
  /// Shown for some seconds where no job runs.
  void tell(const QString& text);
  [[nodiscard]] int shownJobs() const { return static_cast<int>(cells_.size()); }

 protected:
  void retranslateUi() override;

 private:
  struct Cell {
    QWidget* box = nullptr;
    QProgressBar* progress = nullptr;
    QPushButton* cancel = nullptr;
  };
  void addCell(JobId id);
  void removeCell(JobId id);
  void refresh();

  JobRunner& jobs_;
  QHBoxLayout* cellRow_;
  QLabel* waiting_;
  QPushButton* cancelAll_;
  QLabel* news_;
  QLabel* mouse_;
  QLabel* notClinical_;
  QTimer newsEnds_;
  QMap<JobId, QString> queued_;  ///< title by id
  QMap<JobId, Cell> cells_;
};

}  // namespace glisson
