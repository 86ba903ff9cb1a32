#pragma once
// Purpose: the .glisson case file: one SQLite database (design.md 3.5). synchronous=FULL, rollback journal, one transaction per
// edit, one writer (a second opener reads only). Versioned; a newer version is refused with a sentence.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planning/case/case.h"
#include "planning/storage/ct_files.h"
#include "planning/storage/edit_step.h"

namespace glisson {

class CaseFile;

/// What a new file gets of the CT beside its path and SHA-256.
struct CtStorage {
  bool embed = false;                 ///< the voxels of source.ct
  const CaseFile* earlier = nullptr;  ///< the file the case was in: its embedded CT and the SHA-256 it knows go over
  /// Of the files at source.ctSource, where they are known and `earlier` is not at hand. Hashed are the files only of a case that
  /// was in no file yet: what lies at the path later may be something else.
  std::optional<std::vector<CtFileHash>> known{};
};

/// What one edit replaces; null is what stays.
struct CaseChanges {
  const std::vector<ResectionPlan>* plans = nullptr;
  std::string planEdit{};  ///< names of the undo records
  const PatientFacts* patient = nullptr;
  std::string patientEdit{};
  const TerritoryMarks* territories = nullptr;
  std::string territoryEdit{};
  const LiverModel* model = nullptr;
  std::string modelEdit{};
  bool modelGoesOn = false;  ///< the newest record is of the same structures, and goes on: a slide that moves is one edit
};

class CaseFile {
 public:
  /// Creates a new file holding `source` (masks and meshes compressed, the CT by path and SHA-256). Written beside and renamed: an
  /// existing file is replaced only by a complete one, and not while somebody edits it. `history`: of the file it is saved from.
  /// Throws InputError, PlanningError where there is no CT to embed, Cancelled (polled while a CT is embedded).
  static CaseFile create(const std::filesystem::path& path, const Case& source, const std::vector<EditStep>& history = {},
                         const CtStorage& ct = {}, const ExecutionContext& context = {});
  /// Opens for reading and, where no other process writes, for writing. Throws InputError: not a case, newer version, damaged.
  static CaseFile open(const std::filesystem::path& path);
  ~CaseFile();
  CaseFile(CaseFile&&) noexcept;
  CaseFile& operator=(CaseFile&&) noexcept;

  /// The whole case. The CT is not read (its path is in ctSource; see embeddedCt()); `ct` is null.
  [[nodiscard]] Case load() const;
  /// All of `changes` in one committed transaction, or nothing of it; each as the function of its own below.
  void store(const CaseChanges& changes);
  /// Replaces the plans in one committed transaction, together with its undo record; equal plans are no edit. Throws InputError
  /// where the file is read-only or the disk is full, PlanningError where a plane is not finite; the file then holds what it held.
  void storePlans(const std::vector<ResectionPlan>& plans, const std::string& name = {});
  /// Replaces what the user said about the patient in one committed transaction, together with its undo record; equal facts are no
  /// edit. Throws as storePlans().
  void storePatient(const PatientFacts& facts, const std::string& name = {});
  /// Replaces what the user said about the territories in one committed transaction, together with its undo record; equal marks are
  /// no edit. Throws InputError as storePlans(), PlanningError where a mark is not valid.
  void storeTerritories(const TerritoryMarks& marks, const std::string& name = {});
  /// Replaces the model (structures, colours, meshes, who accepts them) in one committed transaction, together with the undo record
  /// of what a person has set. A surface that was made, and an acceptance that ended with the one before, are no edit.
  void storeModel(const LiverModel& model, const std::string& name = {});
  /// The undo records of the newest `atMost` edits, oldest first: also those made before the program was last closed.
  [[nodiscard]] std::vector<EditStep> history(std::size_t atMost = 100) const;
  /// The files at ctSource are those the case was made from, by SHA-256. False where they are gone, other ones, or
  /// may not be read.
  [[nodiscard]] bool ctUnchanged() const;
  /// The files the case was made from; none where they could not be read then.
  [[nodiscard]] std::vector<CtFileHash> ctFiles() const;
  [[nodiscard]] bool hasEmbeddedCt() const;
  /// The CT in the file, proven by its SHA-256; null where it has none. Throws InputError where it is damaged: the rest of the case
  /// is not concerned. Throws Cancelled.
  [[nodiscard]] std::shared_ptr<const CtVolume> embeddedCt(const ExecutionContext& context = {}) const;
  [[nodiscard]] bool readOnly() const;
  [[nodiscard]] const std::filesystem::path& path() const;

 private:
  struct Impl;
  explicit CaseFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
