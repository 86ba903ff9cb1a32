#pragma once
// Purpose: a case in the tables of its database, version 3. Private to storage/.
//   document(key, json, crc)   'case', 'segmentation', 'model', 'plans', 'patient', perhaps 'territories' and 'ct'; crc is CRC-32
//   part(key, data)            'mask/N', 'liver', 'tumour', 'mesh/ID': packing.h; 'ct/N': embedded_ct.h
//   ct_file(name, bytes, sha256)
//   history(step, before, after, name, patient_before, patient_after, territories_before, ..., structures_after)
//     the plans before and after each edit, and what it is called; the others are null but for an edit of the patient, the
//     territories or the structures, whose plans are equal. structures_: the states of those the edit changed
// Version 1 has no 'patient', no names of edits, and plans without islands and measures; version 2 no bent planes. An older version
// is read as it is, and becomes this one in the transaction of its first edit: an older program then refuses it instead of
// dropping what it does not know. A file from before the edits of one kind were recorded gets their two columns with the first of
// them.
// The version goes up only where an older program would show or store something wrong: it takes an edit of the patient for one that
// changes nothing, a structure that was accepted for one that nobody has accepted, territories for not confirmed, and leaves an
// embedded CT alone.

#include <map>

#include "planning/storage/case_file.h"
#include "planning/storage/ct_files.h"
#include "planning/storage/database.h"

namespace glisson::caseTables {

inline constexpr std::int64_t kApplicationId = 0x476C6973;  ///< "Glis"
inline constexpr std::int64_t kVersion = 3;

/// What the meshes in the file were written from, so that an unchanged mesh is not written again.
using StoredMeshes = std::map<std::string, std::shared_ptr<const Reconstruction>>;

/// None of these opens a transaction.
void createTables(const Database& database);
/// What is known of the files at the case's ctSource.
struct KnownCt {
  const Database* earlier = nullptr;  ///< the file the case was in, or null
  const std::optional<std::vector<CtFileHash>>& files;
};
/// The CT's files are hashed only where nothing is known of them.
void writeCase(const Database& database, const Case& source, StoredMeshes& stored, const KnownCt& known);
void writeModel(const Database& database, const LiverModel& model, StoredMeshes& stored);
/// Replaces the plans and appends the edit to the history; false where nothing changed.
bool writePlans(const Database& database, const std::vector<ResectionPlan>& plans, const std::string& name);
/// Replaces what the user said about the patient and appends the edit to the history; false where nothing changed.
bool writePatient(const Database& database, const PatientFacts& facts, const std::string& name);
/// Replaces what the user said about the territories and appends the edit to the history; false where nothing changed.
bool writeTerritories(const Database& database, const TerritoryMarks& marks, const std::string& name);
struct ModelEdit {
  const std::string& name;
  bool goesOn = false;  ///< one edit with the newest of the history, where that is of the same structures
};
/// As writeModel(), and appends what a person has set since to the history. Accepting another surface is no edit of the one before.
void editModel(const Database& database, const LiverModel& model, StoredMeshes& stored, const ModelEdit& edit);
Case readCase(const Database& database, StoredMeshes& stored);
/// What an embedded CT takes from the case: the labels' grid, and the patient.
std::pair<ImageGeometry, PatientIdentity> readLabelGrid(const Database& database);
std::string readCtSource(const Database& database);
std::vector<CtFileHash> readCtFiles(const Database& database);

/// The newest `atMost` edits, oldest first.
std::vector<EditStep> readHistory(const Database& database, std::size_t atMost);

}  // namespace glisson::caseTables
