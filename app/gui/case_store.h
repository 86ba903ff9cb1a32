#pragma once
// Purpose: keeps the open case on disk without making the window wait: one thread owns the CaseFile; edits reach it in order, each
// a committed transaction of its own, within milliseconds where the window and its views leave a processor free. Models that wait
// behind a newer one are skipped, edits never are. Called on the UI thread; signals are emitted there.

#include <QObject>
#include <QString>
#include <QThread>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planning/storage/case_file.h"

namespace glisson {

/// What a copy of the file takes over that is not in the case.
struct FileRecord {
  std::vector<EditStep> history;
  std::optional<std::vector<CtFileHash>> ctFiles;  ///< nothing: the case is in no file
};

class CaseStore : public QObject {
  Q_OBJECT
 public:
  explicit CaseStore(QObject* parent = nullptr);
  /// Waits until everything handed over is on disk.
  ~CaseStore() override;

  /// A new file at `path`, in place of the one open now.
  void create(const std::filesystem::path& path, const Case& content);
  /// Goes on with a file that was opened elsewhere.
  void adopt(std::shared_ptr<CaseFile> file);
  /// `name`: of the edit, for the undo history.
  void storePlans(const std::vector<ResectionPlan>& plans, const QString& name);
  void storePatient(const PatientFacts& facts, const QString& name);
  void storeTerritories(const TerritoryMarks& marks, const QString& name);
  void storeModel(std::shared_ptr<const LiverModel> model);
  /// What a person has set on the model's structures: never skipped. `goesOn`: one edit with the one before.
  void editModel(std::shared_ptr<const LiverModel> model, const QString& name, bool goesOn);
  /// Hands the undo records of everything given over before, and the SHA-256 of the CT's files, to `then`, later, on the UI thread.
  void withRecord(std::function<void(FileRecord)> then);
  /// Writes the whole case to `path`, with the undo records and the CT of the file it was in, and goes on there.
  void goOnIn(const std::filesystem::path& path, const Case& content);
  /// As goOnIn(), emits saved(), and removes `obsolete` (a recovery file) where it is given.
  void saveAs(const std::filesystem::path& path, const Case& content, const std::filesystem::path& obsolete);
  /// Emits saved() after all that was handed over before is on disk.
  void checkpoint();
  /// Lets go of the file; `discarded` (a recovery file nothing was done in) is removed then.
  void close(const std::filesystem::path& discarded = {});
  /// Blocks until everything handed over is on disk.
  void flush();
  /// Nothing of the file open now has been refused by the disk. Of what was handed over before a flush().
  [[nodiscard]] bool keepsAll() const { return keepsAll_; }

 signals:
  void saved(const QString& path);
  void failed(const QString& message);

 private:
  struct Worker;
  void post(std::function<void(Worker&)> work);
  /// Work that leaves an edit in memory alone where it fails.
  void postEdit(std::function<void(CaseFile&)> work);
  void countModelsAnew();

  QThread thread_;
  std::unique_ptr<Worker> worker_;
  std::atomic<bool> keepsAll_{true};
  /// Models handed over so far since the file was opened or a model edited; a new counter then, so that no file gets or loses
  /// another's model, and no edit the model it changes.
  std::shared_ptr<std::atomic<std::uint64_t>> models_ = std::make_shared<std::atomic<std::uint64_t>>(0);
};

}  // namespace glisson
