#pragma once
// Purpose: the line at the bottom: every job with its progress and a Cancel of its own (those that run in the line, those that wait
// in a list that opens from it); what ended, told quietly; what the mouse does; "not for clinical use".

#include <QMap>
#include <QTimer>
#include <QWidget>

#include "app/gui/translated.h"
#include "app/jobs/job_runner.h"

class QBoxLayout;
class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace glisson {

class JobBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit JobBar(JobRunner& jobs, QWidget* parent = nullptr);
  /// Shown for some seconds where no job runs.
  void tell(const QString& text);
  /// Jobs that run or wait, each with its row.
  [[nodiscard]] int shownJobs() const { return static_cast<int>(rows_.size()); }

 protected:
  void retranslateUi() override;

 private:
  struct Row {
    QWidget* box = nullptr;
    QLabel* name = nullptr;
    QProgressBar* progress = nullptr;
    QPushButton* cancel = nullptr;
    bool running = false;
  };
  void buildWaitingList();
  void addRow(JobId id, const QString& title);
  void showRunning(JobId id);
  void removeRow(JobId id);
  void openWaitingList();
  void fitWaitingList();
  void refresh();
  [[nodiscard]] int waitingCount() const;

  JobRunner& jobs_;
  QBoxLayout* runningRows_;
  QToolButton* waiting_;
  QFrame* waitingList_;
  QWidget* waitingContent_;
  QBoxLayout* waitingRows_;
  QPushButton* cancelAll_;
  QLabel* news_;
  QLabel* mouse_;
  QLabel* notClinical_;
  QTimer newsEnds_;
  QMap<JobId, Row> rows_;
};

}  // namespace glisson
