#pragma once
// Purpose: one job per structure; each appears in the document as it finishes. UI thread only.

#include <QObject>
#include <map>
#include <string>

#include "app/gui/document.h"
#include "app/jobs/job_runner.h"

namespace glisson {

class ModelBuilder : public QObject {
  Q_OBJECT
 public:
  ModelBuilder(JobRunner& jobs, Document& document, QObject* parent = nullptr);

  /// Starts a job for every structure without a surface that no job is making. Returns how many were started.
  int buildMissing();
  /// Structures of the model that have no surface.
  [[nodiscard]] int missing() const;
  [[nodiscard]] int total() const;
  [[nodiscard]] bool building() const { return !running_.empty(); }

 signals:
  void structureReady(const QString& name, double seconds);
  /// `message` names the structure.
  void structureFailed(const QString& message);
  /// A job started or ended.
  void changed();

 private:
  void cancelAll();
  void ended(JobId id);

  JobRunner& jobs_;
  Document& document_;
  std::map<std::string, JobId> running_;  ///< by structure id
};

/// The structure's name for people: its kind where the file's name is only an id, else the file's own.
QString structureName(const Structure& structure);
/// Made from voxels, so that it can be reconstructed.
bool isModelled(const Structure& structure);

}  // namespace glisson
