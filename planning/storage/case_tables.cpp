#include "planning/storage/case_tables.h"

#include <algorithm>

#include "planning/storage/case_json.h"
#include "planning/storage/embedded_ct.h"
#include "planning/storage/packing.h"
#include "planning/storage/table_access.h"
#include "reconstruction/errors.h"

namespace glisson::caseTables {

namespace {
using caseJson::Json;

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
  segmentation->source = json.at("source");
  segmentation->patientId = json.at("patientId");
  segmentation->frameOfReferenceUid = json.at("frameOfReferenceUid");
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
  model->revision = json.at("revision");
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

/// The plans as text, proven to read back: a number that is not finite would spoil the file.
std::string plansText(const std::vector<ResectionPlan>& plans) {
  std::string text = textOf(caseJson::fromPlans(plans));
  try {
    (void)caseJson::toPlans(Json::parse(text));
  } catch (const std::exception&) {
    throw PlanningError(
        "The plan holds a number that is not finite, a normal that is not of unit length or a bend that is none; place the plane "
        "again.");
  }
  return text;
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

/// What `read` gives; whatever does not fit becomes a sentence about the file.
template <typename Read>
auto readOrDamaged(const Database& database, const std::string& misfit, Read&& read) {
  try {
    return read();
  } catch (const Json::exception&) {
    damaged(database, misfit);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    damaged(database, error.what());
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

bool recordsPatient(const Database& database) {
  return database.number("SELECT count(*) FROM pragma_table_info('history') WHERE name = 'patient_after'") > 0;
}
}  // namespace

void createTables(const Database& database) {
  database.execute(
      "CREATE TABLE document(key TEXT PRIMARY KEY, json TEXT NOT NULL, crc INTEGER NOT NULL) STRICT;"
      "CREATE TABLE part(key TEXT PRIMARY KEY, data BLOB NOT NULL) STRICT;"
      "CREATE TABLE ct_file(name TEXT PRIMARY KEY, bytes INTEGER NOT NULL, sha256 TEXT NOT NULL) STRICT;"
      "CREATE TABLE history(step INTEGER PRIMARY KEY, before TEXT NOT NULL, after TEXT NOT NULL, "
      "name TEXT NOT NULL DEFAULT '', patient_before TEXT, patient_after TEXT) STRICT;");
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

namespace {
void appendStep(const Database& database, const std::string& before, const std::string& after, const std::string& name) {
  Statement(database, "INSERT INTO history(before, after, name) VALUES(?, ?, ?)")
      .bind(0, std::string_view(before))
      .bind(1, std::string_view(after))
      .bind(2, std::string_view(name))
      .step();
}

/// The plans stand in the record as well: to a program that does not know its last columns it is an edit that changes nothing.
void appendPatientStep(const Database& database, const std::string& plans, const PlanStep::Patient& patient,
                       const std::string& name) {
  Statement(database, "INSERT INTO history(before, after, name, patient_before, patient_after) VALUES(?, ?, ?, ?, ?)")
      .bind(0, std::string_view(plans))
      .bind(1, std::string_view(plans))
      .bind(2, std::string_view(name))
      .bind(3, std::string_view(factsText(patient.before)))
      .bind(4, std::string_view(factsText(patient.after)))
      .step();
}
}  // namespace

void writeHistory(const Database& database, const std::vector<PlanStep>& steps) {
  for (const PlanStep& step : steps) {
    if (step.patient) {
      appendPatientStep(database, plansText(step.after), *step.patient, step.name);
    } else {
      appendStep(database, plansText(step.before), plansText(step.after), step.name);
    }
  }
}

bool writePlans(const Database& database, const std::vector<ResectionPlan>& plans, const std::string& name) {
  const std::string after = plansText(plans);
  const std::string before = documentText(database, "plans");
  if (before == after) {
    return false;
  }
  bringUpToDate(database);
  putDocument(database, "plans", after);
  appendStep(database, before, after, name);
  return true;
}

bool writePatient(const Database& database, const PatientFacts& facts, const std::string& name) {
  validate(facts);
  const PatientFacts before = readPatient(database);
  if (before == facts) {
    return false;
  }
  bringUpToDate(database);
  if (!recordsPatient(database)) {
    database.execute("ALTER TABLE history ADD COLUMN patient_before TEXT");
    database.execute("ALTER TABLE history ADD COLUMN patient_after TEXT");
  }
  putDocument(database, "patient", factsText(facts));
  appendPatientStep(database, documentText(database, "plans"), {before, facts}, name);
  return true;
}

bool writeTerritories(const Database& database, const TerritoryMarks& marks) {
  if (readTerritories(database) == marks) {
    return false;
  }
  bringUpToDate(database);
  putTerritories(database, marks);
  return true;
}

Case readCase(const Database& database, StoredMeshes& stored) {
  return readOrDamaged(database, formMisfit(), [&] {
    Case read;
    const Json json = Json::parse(documentText(database, "case"));
    read.code = json.at("code");
    read.identity = caseJson::toIdentity(json.at("identity"));
    read.ctSource = json.at("ctSource");
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
    return Json::parse(documentText(database, "case")).at("ctSource");
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

std::vector<PlanStep> readHistory(const Database& database, std::size_t atMost) {
  std::vector<PlanStep> steps;
  const char* complete = "SELECT before, after, name, patient_before, patient_after FROM history ORDER BY step DESC LIMIT ?";
  const char* named = "SELECT before, after, name, '', '' FROM history ORDER BY step DESC LIMIT ?";
  const char* first = "SELECT before, after, '', '', '' FROM history ORDER BY step DESC LIMIT ?";
  Statement statement(database, recordsPatient(database) ? complete : versionOf(database) > 1 ? named : first);
  statement.bind(0, static_cast<std::int64_t>(atMost));
  return readOrDamaged(database, "its history cannot be read", [&] {
    while (statement.step()) {
      steps.push_back({statement.text(2), caseJson::toPlans(Json::parse(statement.text(0))),
                       caseJson::toPlans(Json::parse(statement.text(1)))});
      if (const std::string facts = statement.text(4); !facts.empty()) {
        steps.back().patient = {caseJson::toFacts(Json::parse(statement.text(3))), caseJson::toFacts(Json::parse(facts))};
      }
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  });
}

}  // namespace glisson::caseTables
