#pragma once
// Purpose: makes a plan's report without making the window wait: its views are drawn off-screen, one in a turn of the event loop,
// and the PDF is written in a job. UI thread; needs OpenGL, the views stay empty where there is none.

#include <QObject>
#include <memory>
#include <vector>

#include "app/gui/plan_report.h"
#include "app/jobs/job_runner.h"
#include "planning/volumetry/tumour_distance.h"
#include "viewer/model_view.h"

namespace glisson {

class ReportWriter : public QObject {
  Q_OBJECT
 public:
  ReportWriter(JobRunner& jobs, QObject* parent);
  ~ReportWriter() override;

  /// In place of one whose views are still being drawn. `tumours` colours the cut; `ready`: surfaces that need not be made ready
  /// again. Throws PlanningError where an identity is asked for that the case does not hold.
  void write(PlanReport report, const std::shared_ptr<const TumourDistance>& tumours,
             const std::vector<std::shared_ptr<const DisplayMesh>>& ready, const QString& path);

 signals:
  void written(const QString& path);
  void refused(const QString& sentence);  ///< in English

 private:
  void drawNext();
  void writeInJob();

  JobRunner& jobs_;
  std::unique_ptr<ModelView> view_;  ///< while views are left to draw
  PlanReport report_;
  std::size_t drawn_ = 0;
  QString path_;
};

}  // namespace glisson
