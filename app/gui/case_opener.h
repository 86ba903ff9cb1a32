#pragma once
// Purpose: opens a case in a job and asks what only a person can answer: the segmentation of a CT, the kind of an
// unknown label, consent to a doubtful input.
// Dialogs never block the event loop. With setUnattended() nothing is asked: what would be a question is a refusal.

#include <QObject>
#include <QWidget>
#include <memory>

#include "app/gui/open_inputs.h"
#include "app/jobs/job_runner.h"

namespace glisson {

class CaseOpener : public QObject {
  Q_OBJECT
 public:
  CaseOpener(JobRunner& jobs, QWidget* dialogParent);

  void setUnattended(bool unattended) { unattended_ = unattended; }
  /// The options of the command line hold for every input opened.
  void setOptions(const ReadOptions& options) { options_ = options; }
  void openSample();
  void openPaths(const QStringList& paths);

 signals:
  /// `content` is never empty; `file` is null but for a .glisson file; `noCt`: why its CT is not to be shown, in English.
  void opened(const glisson::Case& content, std::shared_ptr<glisson::CaseFile> file, const QStringList& paths,
              const QString& noCt = {});
  void refused(const QString& sentence);  ///< in English

 private:
  void start(const OpenRequest& request);
  void handle(const OpenRequest& request, OpenedCase result);
  void handleRefusal(const OpenRequest& request, const std::exception& error);
  void askSegmentation(const OpenRequest& request, const QString& ct);
  void askKinds(const OpenRequest& request, const std::vector<LabelledMask>& unknown);

  JobRunner& jobs_;
  QWidget* dialogParent_;
  ReadOptions options_;
  bool unattended_ = false;
  std::optional<JobId> opening_;  ///< what is being read now
  std::vector<std::filesystem::path> openingPaths_;
};

}  // namespace glisson
