#include "planning/storage/case_tables.h"

#include <algorithm>

#include "planning/storage/case_json.h"
#include "planning/storage/embedded_ct.h"
#include "planning/storage/history_table.h"
#include "planning/storage/packing.h"
#include "planning/storage/surface_hash.h"
#include "planning/storage/table_access.h"
#include "reconstruction/errors.h"

namespace glisson::caseTables {

namespace {

Mask getMask(const Database& database, const std::string& key, const Json& box, const Index3& size) {
  return getPart(database, key, [&](std::span<const std::byte> data) { return unpackMask(data, caseJson::toBox(box, size)); });
}

std::string maskKey(std::size_t index) { return "mask/" + std::to_string(index); }
std::string meshKey(const std::string& id) { return "mesh/" + id; }

void writeSegmentation(const Database& database, const Segmentation& segmentation) {
  Json json;
  json["geometry"] = caseJson::fromGeometry(segmentation.geometry);
  json["source"] = segmentation.source;
  json["patientId"] = segmentation.patientId;
  json["frameOfReferenceUid"] = segmentation.frameOfReferenceUid;
  json["notes"] = segmentation.notes;
  json["structures"] = Json::array();
  for (std::size_t n = 0; n < segmentation.structures.size(); ++n) {
    json["structures"].push_back(caseJson::fromLabelled(segmentation.structures[n]));
    if (segmentation.structures[n].mask) {
      putPart(database, maskKey(n), packMask(*segmentation.structures[n].mask));
    }
  }
  putDocument(database, "segmentation", textOf(json));
}

std::shared_ptr<const Segmentation> readSegmentation(const Database& database) {
  const Json json = Json::parse(documentText(database, "segmentation"));
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->geometry = caseJson::toGeometry(json.at("geometry"));
  json.at("source").get_to(segmentation->source);
  json.at("patientId").get_to(segmentation->patientId);
  json.at("frameOfReferenceUid").get_to(segmentation->frameOfReferenceUid);
  segmentation->notes = json.at("notes").get<std::vector<std::string>>();
  for (const Json& item : json.at("structures")) {
    LabelledMask structure = caseJson::toLabelled(item);
    if (!item.at("box").is_null()) {
      structure.mask = std::make_shared<const Mask>(
          getMask(database, maskKey(segmentation->structures.size()), item.at("box"), segmentation->geometry.size));
    }
    segmentation->structures.push_back(std::move(structure));
  }
  return segmentation;
}

std::shared_ptr<const LiverModel> readModel(const Database& database, std::size_t masks, StoredMeshes& stored) {
  const Json json = Json::parse(documentText(database, "model"));
  auto model = std::make_shared<LiverModel>();
  json.at("revision").get_to(model->revision);
  for (const Json& item : json.at("structures")) {
    caseJson::StoredStructure read = caseJson::toStructure(item);
    if (read.structure.sourceIndex >= static_cast<std::int64_t>(masks)) {
      throw std::runtime_error("a structure has no mask");
    }
    if (read.reconstruction) {
      read.reconstruction->mesh = getPart(database, meshKey(read.structure.id), [&](std::span<const std::byte> data) {
        return unpackMesh(data, read.vertices, read.triangles);
      });
      read.structure.reconstruction = read.reconstruction;
      stored[read.structure.id] = read.reconstruction;
    }
    model->structures.push_back(std::move(read.structure));
  }
  return model;
}

void putTerritories(const Database& database, const TerritoryMarks& marks) {
  validate(marks);
  putDocument(database, "territories", textOf(caseJson::fromMarks(marks)));
}

std::string factsText(const PatientFacts& facts) { return textOf(caseJson::fromFacts(facts)); }

std::int64_t versionOf(const Database& database) { return database.number("PRAGMA user_version"); }

void setVersion(const Database& database) { database.execute(("PRAGMA user_version=" + std::to_string(kVersion)).c_str()); }

/// What an edit of an older file has to do first; part of the edit's transaction.
void bringUpToDate(const Database& database) {
  if (versionOf(database) < 2) {
    putDocument(database, "patient", factsText({}));
    database.execute("ALTER TABLE history ADD COLUMN name TEXT NOT NULL DEFAULT ''");
  }
  if (versionOf(database) < kVersion) {
    setVersion(database);
  }
}

std::string formMisfit() { return "a document has not the form of version " + std::to_string(kVersion); }

PatientFacts readPatient(const Database& database) {
  return readOrDamaged(database, "its patient cannot be read", [&] {
    return versionOf(database) > 1 ? caseJson::toFacts(Json::parse(documentText(database, "patient"))) : PatientFacts();
  });
}

TerritoryMarks readTerritories(const Database& database) {
  return readOrDamaged(database, "its territories cannot be read", [&] {
    return hasDocument(database, "territories") ? caseJson::toMarks(Json::parse(documentText(database, "territories")))
                                                : TerritoryMarks();
  });
}

}  // namespace

void createTables(const Database& database) {
  database.execute(
      "CREATE TABLE document(key TEXT PRIMARY KEY, json TEXT NOT NULL, crc INTEGER NOT NULL) STRICT;"
      "CREATE TABLE part(key TEXT PRIMARY KEY, data BLOB NOT NULL) STRICT;"
      "CREATE TABLE ct_file(name TEXT PRIMARY KEY, bytes INTEGER NOT NULL, sha256 TEXT NOT NULL) STRICT;"
      "CREATE TABLE history(step INTEGER PRIMARY KEY, before TEXT NOT NULL, after TEXT NOT NULL, "
      "name TEXT NOT NULL DEFAULT '', patient_before TEXT, patient_after TEXT, territories_before TEXT, territories_after TEXT, "
      "structures_before TEXT, structures_after TEXT) STRICT;");
  database.execute(("PRAGMA application_id=" + std::to_string(kApplicationId)).c_str());
  setVersion(database);
}

namespace {
/// The files' hashes are of the day the case was made: what lies at the path by now may be something else, or nothing.
std::vector<CtFileHash> ctFilesOf(const Case& source, const KnownCt& known) {
  if (known.files) {
    return *known.files;
  }
  if (known.earlier != nullptr) {
    return readCtSource(*known.earlier) == source.ctSource ? readCtFiles(*known.earlier) : std::vector<CtFileHash>();
  }
  return hashCtFiles(source.ctSource);
}
}  // namespace

void writeCase(const Database& database, const Case& source, StoredMeshes& stored, const KnownCt& known) {
  Json json;
  json["code"] = source.code;
  json["identity"] = caseJson::fromIdentity(source.identity);
  json["ctSource"] = source.ctSource;
  json["notes"] = source.notes;
  json["liverBox"] = caseJson::fromBox(source.liver->liver.box());
  json["tumourBox"] = caseJson::fromBox(source.liver->tumour.box());
  json["liverNotes"] = source.liver->notes;
  putDocument(database, "case", textOf(json));
  putPart(database, "liver", packMask(source.liver->liver));
  putPart(database, "tumour", packMask(source.liver->tumour));
  writeSegmentation(database, *source.segmentation);
  writeModel(database, source.model ? *source.model : LiverModel(), stored);
  putDocument(database, "plans", plansText(source.plans));
  validate(source.patient);
  putDocument(database, "patient", factsText(source.patient));
  if (!(source.territories == TerritoryMarks())) {
    putTerritories(database, source.territories);
  }
  if (!source.ctSource.empty()) {
    for (const CtFileHash& file : ctFilesOf(source, known)) {
      Statement(database, "INSERT INTO ct_file(name, bytes, sha256) VALUES(?, ?, ?)")
          .bind(0, std::string_view(file.name))
          .bind(1, file.bytes)
          .bind(2, std::string_view(file.sha256))
          .step();
    }
  }
}

void writeModel(const Database& database, const LiverModel& model, StoredMeshes& stored) {
  Json json;
  json["revision"] = model.revision;
  json["structures"] = Json::array();
  StoredMeshes now;
  for (const Structure& structure : model.structures) {
    json["structures"].push_back(caseJson::fromStructure(structure));
    if (!structure.reconstruction) {
      continue;
    }
    now[structure.id] = structure.reconstruction;
    const auto known = stored.find(structure.id);
    if (known == stored.end() || known->second != structure.reconstruction) {
      putPart(database, meshKey(structure.id), packMesh(structure.reconstruction->mesh));
    }
  }
  for (const auto& [id, mesh] : stored) {
    if (!now.contains(id)) {
      Statement(database, "DELETE FROM part WHERE key = ?").bind(0, std::string_view(meshKey(id))).step();
    }
  }
  putDocument(database, "model", textOf(json));
  stored = std::move(now);
}

bool writePlans(const Database& database, const std::vector<ResectionPlan>& plans, const std::string& name) {
  const std::string after = plansText(plans);
  const std::string before = documentText(database, "plans");
  if (before == after) {
    return false;
  }
  bringUpToDate(database);
  putDocument(database, "plans", after);
  appendPlans(database, before, after, name);
  return true;
}

bool writePatient(const Database& database, const PatientFacts& facts, const std::string& name) {
  validate(facts);
  const PatientFacts before = readPatient(database);
  if (before == facts) {
    return false;
  }
  bringUpToDate(database);
  putDocument(database, "patient", factsText(facts));
  append(database, documentText(database, "plans"), {"patient", factsText(before), factsText(facts)}, name);
  return true;
}

bool writeTerritories(const Database& database, const TerritoryMarks& marks, const std::string& name) {
  const TerritoryMarks before = readTerritories(database);
  if (before == marks) {
    return false;
  }
  bringUpToDate(database);
  putTerritories(database, marks);
  append(database, documentText(database, "plans"),
         {"territories", textOf(caseJson::fromMarks(before)), textOf(caseJson::fromMarks(marks))}, name);
  return true;
}

namespace {
/// `surfaces`: those in the file, as far as they are known already.
bool isStoredSurface(const Database& database, const caseJson::StoredStructure& earlier, const Structure& structure,
                     const StoredMeshes& surfaces) {
  if (const auto known = surfaces.find(structure.id); known != surfaces.end()) {
    return known->second == structure.reconstruction;
  }
  if (!earlier.reconstruction || !structure.reconstruction) {
    return false;
  }
  const SurfaceMesh mesh = getPart(database, meshKey(structure.id), [&](std::span<const std::byte> data) {
    return unpackMesh(data, earlier.vertices, earlier.triangles);
  });
  return surfaceHash(mesh) == surfaceHash(structure.reconstruction->mesh);
}

/// What a person has set since: the states before and after of those structures alone.
Change<std::vector<StructureState>> editOf(const Database& database, const LiverModel& model, const StoredMeshes& surfaces) {
  Change<std::vector<StructureState>> edit;
  const Json json = Json::parse(documentText(database, "model"));
  for (const Json& item : json.at("structures")) {
    const caseJson::StoredStructure earlier = caseJson::toStructure(item);
    const Structure* structure = model.find(earlier.structure.id);
    if (structure == nullptr) {
      continue;
    }
    StructureState before = stateOf(earlier.structure);
    StructureState after = stateOf(*structure);
    if (before.acceptance != after.acceptance) {
      if (isStoredSurface(database, earlier, *structure, surfaces)) {
        before.surface = after.surface = surfaceHash(structure->reconstruction->mesh);
      } else {
        before.acceptance = after.acceptance;
      }
    }
    if (!(before == after)) {
      edit.before.push_back(std::move(before));
      edit.after.push_back(std::move(after));
    }
  }
  return edit;
}
}  // namespace

void editModel(const Database& database, const LiverModel& model, StoredMeshes& stored, const ModelEdit& edit) {
  const Change<std::vector<StructureState>> change =
      readOrDamaged(database, formMisfit(), [&] { return editOf(database, model, stored); });
  writeModel(database, model, stored);
  if (change.after.empty()) {
    return;
  }
  bringUpToDate(database);
  const OtherEdit record{"structures", textOf(caseJson::fromStates(change.before)), textOf(caseJson::fromStates(change.after))};
  if (!edit.goesOn || !goOn(database, record)) {
    append(database, documentText(database, "plans"), record, edit.name);
  }
}

Case readCase(const Database& database, StoredMeshes& stored) {
  return readOrDamaged(database, formMisfit(), [&] {
    Case read;
    const Json json = Json::parse(documentText(database, "case"));
    json.at("code").get_to(read.code);
    read.identity = caseJson::toIdentity(json.at("identity"));
    json.at("ctSource").get_to(read.ctSource);
    read.notes = json.at("notes").get<std::vector<std::string>>();
    read.segmentation = readSegmentation(database);
    auto liver = std::make_shared<LiverVoxels>();
    liver->geometry = read.segmentation->geometry;
    liver->liver = getMask(database, "liver", json.at("liverBox"), liver->geometry.size);
    liver->tumour = getMask(database, "tumour", json.at("tumourBox"), liver->geometry.size);
    liver->functional = differenceOf(liver->liver, liver->tumour);
    liver->notes = json.at("liverNotes").get<std::vector<std::string>>();
    read.liver = std::move(liver);
    read.model = readModel(database, read.segmentation->structures.size(), stored);
    read.plans = caseJson::toPlans(Json::parse(documentText(database, "plans")));
    read.patient = readPatient(database);
    read.territories = readTerritories(database);
    return read;
  });
}

std::pair<ImageGeometry, PatientIdentity> readLabelGrid(const Database& database) {
  return readOrDamaged(database, formMisfit(), [&]() -> std::pair<ImageGeometry, PatientIdentity> {
    return {caseJson::toGeometry(Json::parse(documentText(database, "segmentation")).at("geometry")),
            caseJson::toIdentity(Json::parse(documentText(database, "case")).at("identity"))};
  });
}

std::string readCtSource(const Database& database) {
  try {
    return Json::parse(documentText(database, "case")).at("ctSource").get<std::string>();
  } catch (const Json::exception&) {
    damaged(database, "its case has no CT source");
  }
}

std::vector<CtFileHash> readCtFiles(const Database& database) {
  std::vector<CtFileHash> files;
  Statement statement(database, "SELECT name, bytes, sha256 FROM ct_file ORDER BY name");
  while (statement.step()) {
    files.push_back({statement.text(0), statement.number(1), statement.text(2)});
  }
  return files;
}

std::vector<EditStep> readHistory(const Database& database, std::size_t atMost) {
  return readHistory(database, atMost, versionOf(database) > 1);
}

}  // namespace glisson::caseTables
