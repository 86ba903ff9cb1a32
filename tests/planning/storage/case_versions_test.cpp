// What the user says about the patient and accepts, in the case file; files of the version before it, and of before it existed.

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <zlib.h>

#include <cmath>

#include "planning/storage/case_file.h"
#include "planning/storage/case_json.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/storage/run_sql.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;
namespace fs = std::filesystem;

Case smallBallCase() {
  const ImageGeometry g = gridOf({20, 20, 20}, Vec3(1, 1, 1));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(10, 10, 10), 6)}}));
}

const PatientFacts kFacts{170, 70.5, LiverCondition::Injured, TumourType::HepatocellularCarcinoma};

ResectionPlan planAt(double x) { return {"Plan 1", {{"Resection 1", {{Vec3(x, 0, 0), Vec3::UnitX()}}}}, 10}; }

constexpr std::int64_t kNewest = 3;

std::int64_t versionOf(const fs::path& path) {
  sqlite3* handle = nullptr;
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_prepare_v2(handle, "PRAGMA user_version", -1, &statement, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
  const std::int64_t version = sqlite3_column_int64(statement, 0);
  sqlite3_finalize(statement);
  sqlite3_close(handle);
  return version;
}

/// A file as version 1 wrote it: without the patient and without names of edits.
fs::path versionOne(const fs::path& folder) {
  fs::path file = folder / "old.glisson";
  Case made = smallBallCase();
  made.plans = {planAt(10)};
  { CaseFile::create(file, made); }
  runSql(file,
         "DELETE FROM document WHERE key = 'patient'; ALTER TABLE history DROP COLUMN name; "
         "ALTER TABLE history DROP COLUMN patient_before; ALTER TABLE history DROP COLUMN patient_after; "
         "PRAGMA user_version=1");
  return file;
}

/// As somebody would write a document who knows its checksum.
void forgeDocument(const fs::path& path, const char* key, const std::string& from, const std::string& to) {
  sqlite3* handle = nullptr;
  sqlite3_stmt* statement = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  ASSERT_EQ(sqlite3_prepare_v2(handle, "SELECT json FROM document WHERE key = ?", -1, &statement, nullptr), SQLITE_OK);
  sqlite3_bind_text(statement, 1, key, -1, SQLITE_STATIC);
  ASSERT_EQ(sqlite3_step(statement), SQLITE_ROW);
  std::string text = reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
  sqlite3_finalize(statement);
  ASSERT_NE(text.find(from), std::string::npos) << text;
  text.replace(text.find(from), from.size(), to);
  ASSERT_EQ(sqlite3_prepare_v2(handle, "UPDATE document SET json = ?, crc = ? WHERE key = ?", -1, &statement, nullptr), SQLITE_OK);
  sqlite3_bind_text(statement, 1, text.c_str(), -1, SQLITE_STATIC);
  sqlite3_bind_int64(
      statement, 2,
      static_cast<std::int64_t>(crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()))));
  sqlite3_bind_text(statement, 3, key, -1, SQLITE_STATIC);
  EXPECT_EQ(sqlite3_step(statement), SQLITE_DONE);
  sqlite3_finalize(statement);
  sqlite3_close(handle);
}

Case acceptedCase(const Acceptance& acceptance) {
  Case made = smallBallCase();
  auto surface = std::make_shared<Reconstruction>();
  surface->parameters = ReconstructionParameters::defaultsFor(StructureKind::Liver);
  made.model = withStructure(*made.model, withReconstruction(*made.model->find("parenchyma"), surface));
  made.model = withAcceptance(*made.model, {"parenchyma"}, acceptance);
  return made;
}

TEST(CaseAcceptance, ComesBackIsReplacedAndIsMissingInAFileOfBeforeItExisted) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const Acceptance acceptance{"Dr. M\xC3\xBCller \"A\"", "2026-01-31T09:05:00Z"};
  const Case source = acceptedCase(acceptance);
  CaseFile made = CaseFile::create(file, source);
  EXPECT_EQ(CaseFile::open(file).load().model->find("parenchyma")->acceptance, acceptance);
  made.storeModel(*withAcceptance(*source.model, {"parenchyma"}, std::nullopt));
  EXPECT_EQ(CaseFile::open(file).load().model->find("parenchyma")->acceptance, std::nullopt);
  made.storeModel(*source.model);
  forgeDocument(file, "model", R"("acceptance":{)", R"("forgotten":{)");
  EXPECT_EQ(CaseFile::open(file).load().model->find("parenchyma")->acceptance, std::nullopt);
}

TEST(CaseAcceptance, OneThatIsNoneIsRefusedWhereverItComesFrom) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const Case source = acceptedCase({"A", "2026-01-31T09:05:00Z"});
  { CaseFile::create(file, source); }
  auto wrong = std::make_shared<LiverModel>(*source.model);
  wrong->structures.front().acceptance->at = "yesterday";
  EXPECT_THROW(CaseFile::open(file).storeModel(*wrong), PlanningError);
  EXPECT_EQ(CaseFile::open(file).load().model->find("parenchyma")->acceptance->by, "A");
  forgeDocument(file, "model", R"("by":"A")", R"("by":7)");
  EXPECT_THROW(CaseFile::open(file).load(), InputError);
  { CaseFile::create(file, source); }
  forgeDocument(file, "model", "T09:05:00Z", "T09:05");
  EXPECT_THROW(CaseFile::open(file).load(), InputError);
}

TEST(CaseChanges, AreStoredTogetherOrNotAtAll) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const Case source = acceptedCase({"A", "2026-01-31T09:05:00Z"});
  { CaseFile::create(file, source); }
  const std::vector<ResectionPlan> plans{planAt(9)};
  const TerritoryMarks marks{{{"arm", {Vec3(1, 2, 3)}}}, false};
  auto wrong = std::make_shared<LiverModel>(*source.model);
  wrong->structures.front().acceptance->at = "yesterday";
  EXPECT_THROW(CaseFile::open(file).store({.plans = &plans, .patient = &kFacts, .territories = &marks, .model = wrong.get()}),
               PlanningError);
  const Case kept = CaseFile::open(file).load();
  EXPECT_EQ(kept.plans, source.plans);
  EXPECT_EQ(kept.patient, PatientFacts());
  EXPECT_EQ(kept.territories, TerritoryMarks());
  EXPECT_TRUE(CaseFile::open(file).history().empty());
  const std::shared_ptr<const LiverModel> model = withAcceptance(*source.model, {"parenchyma"}, std::nullopt);
  CaseFile::open(file).store(
      {.plans = &plans, .planEdit = "place plane", .patient = &kFacts, .territories = &marks, .model = model.get()});
  const Case stored = CaseFile::open(file).load();
  EXPECT_EQ(stored.plans, plans);
  EXPECT_EQ(stored.patient, kFacts);
  EXPECT_EQ(stored.territories, marks);
  EXPECT_FALSE(stored.model->find("parenchyma")->acceptance);
  ASSERT_EQ(CaseFile::open(file).history().size(), 4U) << "one of each kind";
  EXPECT_EQ(CaseFile::open(file).history()[0].name, "place plane");
}

TEST(CasePatient, ComesBackAsItWasStoredAndEmptiedAgain) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  {
    CaseFile made = CaseFile::create(file, smallBallCase());
    EXPECT_EQ(made.load().patient, PatientFacts());
    made.storePatient(kFacts);
  }
  EXPECT_EQ(CaseFile::open(file).load().patient, kFacts);
  CaseFile::open(file).storePatient({std::nullopt, 0.1, std::nullopt, std::nullopt});
  EXPECT_EQ(CaseFile::open(file).load().patient.weightKg, 0.1);
  EXPECT_FALSE(CaseFile::open(file).load().patient.condition);
  EXPECT_EQ(CaseFile::open(file).history().size(), 2U);
}

TEST(CasePatient, EditsComeBackWithTheirUndoRecordAmongThoseOfThePlans) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const PatientFacts taller{180, std::nullopt, std::nullopt, std::nullopt};
  {
    CaseFile made = CaseFile::create(file, smallBallCase());
    made.storePlans({planAt(9)}, "place plane");
    made.storePatient(kFacts, "change patient facts");
    made.storePatient(kFacts, "change patient facts");
    made.storePlans({planAt(8)}, "move plane");
    made.storePatient(taller);
  }
  const auto check = [&](const std::vector<EditStep>& steps) {
    ASSERT_EQ(steps.size(), 4U) << "equal facts are no edit";
    EXPECT_FALSE(steps[0].patient);
    EXPECT_EQ(steps[1].name, "change patient facts");
    ASSERT_TRUE(steps[1].patient);
    EXPECT_EQ(steps[1].patient->before, PatientFacts());
    EXPECT_EQ(steps[1].patient->after, kFacts);
    EXPECT_EQ(steps[1].after, std::vector<ResectionPlan>{planAt(9)});
    EXPECT_EQ(steps[1].before, steps[1].after);
    EXPECT_EQ(steps[2].name, "move plane");
    EXPECT_FALSE(steps[2].patient);
    ASSERT_TRUE(steps[3].patient);
    EXPECT_EQ(steps[3].patient->before, kFacts);
    EXPECT_EQ(steps[3].patient->after, taller);
  };
  const CaseFile opened = CaseFile::open(file);
  check(opened.history());
  check(CaseFile::create(scratch.path / "b.glisson", opened.load(), opened.history()).history());
}

TEST(CasePatient, FileFromBeforeItsEditsWereRecordedOpensAndRecordsTheNextOne) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  Case source = smallBallCase();
  source.patient = kFacts;
  { CaseFile::create(file, source).storePlans({planAt(9)}, "place plane"); }
  runSql(file,
         "ALTER TABLE history DROP COLUMN patient_before; ALTER TABLE history DROP COLUMN patient_after; PRAGMA user_version=2");
  ASSERT_EQ(CaseFile::open(file).history().size(), 1U);
  EXPECT_EQ(CaseFile::open(file).load().patient, kFacts);
  CaseFile::open(file).storePatient({}, "change patient facts");
  EXPECT_EQ(versionOf(file), kNewest);
  const std::vector<EditStep> steps = CaseFile::open(file).history();
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].name, "place plane");
  ASSERT_TRUE(steps[1].patient);
  EXPECT_EQ(steps[1].patient->before, kFacts);
  EXPECT_EQ(steps[1].before, std::vector<ResectionPlan>{planAt(9)});
}

TEST(CasePatient, RecordThatDoesNotFitIsRefused) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  { CaseFile::create(file, smallBallCase()).storePatient(kFacts); }
  for (const char* wrong : {"{}", "7", "no json", R"({"heightCm":-1,"weightKg":null,"condition":null,"tumourType":null})"}) {
    runSql(file, "UPDATE history SET patient_after = '" + std::string(wrong) + "'");
    EXPECT_THROW((void)CaseFile::open(file).history(), InputError) << wrong;
  }
}

TEST(CasePatient, NumberThatIsNoBodysIsRefusedAndTheFileKeepsWhatItHeld) {
  const Scratch scratch;
  CaseFile made = CaseFile::create(scratch.path / "a.glisson", smallBallCase());
  made.storePatient(kFacts);
  for (const double wrong : {0.0, -170.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    EXPECT_THROW(made.storePatient({wrong, 70, std::nullopt, std::nullopt}), PlanningError);
    EXPECT_THROW(made.storePatient({170, wrong, std::nullopt, std::nullopt}), PlanningError);
  }
  EXPECT_EQ(made.load().patient, kFacts);
}

TEST(CaseVersions, FileOfVersionOneOpensWithoutAPatientAndIsNotTouchedByReading) {
  const Scratch scratch;
  const fs::path file = versionOne(scratch.path);
  const Case read = CaseFile::open(file).load();
  EXPECT_EQ(read.patient, PatientFacts());
  EXPECT_EQ(read.plans[0].resections[0].planes[0].origin[0], 10);
  EXPECT_TRUE(read.plans[0].measures.empty());
  EXPECT_TRUE(read.plans[0].islands.empty());
  EXPECT_EQ(versionOf(file), 1);
}

TEST(CaseVersions, FirstEditBringsAFileOfVersionOneUpToDate) {
  const Scratch scratch;
  const fs::path file = versionOne(scratch.path);
  CaseFile::open(file).storePlans({planAt(10)});
  EXPECT_EQ(versionOf(file), 1) << "equal plans are no edit";
  CaseFile::open(file).storePlans({planAt(9)}, "move plane");
  EXPECT_EQ(versionOf(file), kNewest);
  EXPECT_EQ(CaseFile::open(file).load().plans[0].resections[0].planes[0].origin[0], 9);
  ASSERT_EQ(CaseFile::open(file).history().size(), 1U);
  EXPECT_EQ(CaseFile::open(file).history()[0].name, "move plane");
  EXPECT_EQ(CaseFile::open(file).history()[0].before, std::vector<ResectionPlan>{planAt(10)});
  fs::remove(file);
  const fs::path other = versionOne(scratch.path);
  CaseFile::open(other).storePatient(kFacts);
  EXPECT_EQ(versionOf(other), kNewest);
  EXPECT_EQ(CaseFile::open(other).load().patient, kFacts);
}

TEST(CaseVersions, FileOfThisVersionWithoutItsPatientIsDamaged) {
  const Scratch scratch;
  const fs::path file = versionOne(scratch.path);
  runSql(file, "PRAGMA user_version=2");
  EXPECT_THROW(CaseFile::open(file).load(), InputError);
}

TEST(CaseVersions, MeasuresAndIslandsComeBackBitForBit) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  ResectionPlan plan = planAt(10);
  plan.measures = {{"Distance 1", Vec3(0.1, 1.0 / 3, -7), Vec3(1e-7, 2, 3)}};
  plan.islands = {{Vec3(0.1 + 0.2, 5, 6), PlanSide::Remnant}, {Vec3(1, 2, 3), PlanSide::Resected}};
  CaseFile::create(file, smallBallCase()).storePlans({plan});
  const ResectionPlan read = CaseFile::open(file).load().plans[0];
  ASSERT_EQ(read.measures.size(), 1U);
  EXPECT_EQ(read.measures[0].name, "Distance 1");
  EXPECT_EQ(read.measures[0].from, plan.measures[0].from);
  EXPECT_EQ(read.measures[0].to, plan.measures[0].to);
  ASSERT_EQ(read.islands.size(), 2U);
  EXPECT_EQ(read.islands[0].point, plan.islands[0].point);
  EXPECT_EQ(read.islands[0].to, PlanSide::Remnant);
  EXPECT_EQ(read.islands[1].to, PlanSide::Resected);
}

/// A file as version 2 wrote it: without bent planes.
fs::path versionTwo(const fs::path& folder) {
  fs::path file = folder / "older.glisson";
  Case made = smallBallCase();
  made.plans = {planAt(10)};
  made.patient = kFacts;
  { CaseFile::create(file, made); }
  runSql(file, "PRAGMA user_version=2");
  return file;
}

Bend someBend() {
  Bend bend = flatBend({Vec3::Zero(), Vec3::UnitX()}, 33.3);
  for (std::size_t n = 0; n < 16; ++n) {
    bend.heightsMm[n] = 0.1 * static_cast<double>(n) - 1.0 / 3;
  }
  return bend;
}

TEST(CaseVersions, FileOfVersionTwoKeepsItsVersionUntilItsFirstEdit) {
  const Scratch scratch;
  const fs::path file = versionTwo(scratch.path);
  EXPECT_EQ(CaseFile::open(file).load().patient, kFacts);
  EXPECT_EQ(versionOf(file), 2);
  CaseFile::open(file).storePlans({planAt(9)}, "move plane");
  EXPECT_EQ(versionOf(file), kNewest) << "a program that knows no bent planes refuses what may hold them";
  EXPECT_EQ(CaseFile::open(file).load().patient, kFacts);
  EXPECT_EQ(CaseFile::open(file).history().size(), 1U);
}

TEST(CaseVersions, BendsComeBackBitForBitAlsoFromTheHistory) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  ResectionPlan plan = planAt(10);
  plan.resections[0].planes[0].bend = someBend();
  CaseFile::create(file, smallBallCase()).storePlans({plan}, "bend plane");
  EXPECT_EQ(CaseFile::open(file).load().plans[0], plan);
  EXPECT_EQ(CaseFile::open(file).history().back().after, std::vector<ResectionPlan>{plan});
}

TEST(CaseVersions, BendsThatAreNoneAreRefusedWithASentence) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  ResectionPlan plan = planAt(10);
  plan.resections[0].planes[0].bend = someBend();
  plan.resections[0].planes[0].bend->heightsMm[3] = NAN;
  CaseFile made = CaseFile::create(file, smallBallCase());
  EXPECT_THROW(made.storePlans({plan}), PlanningError);
  plan.resections[0].planes[0].bend = someBend();
  plan.resections[0].planes[0].bend->halfSizeMm = -5;
  EXPECT_THROW(made.storePlans({plan}), PlanningError);
  const auto stored = [](const std::string& bend) {
    return R"([{"name":"Plan 1","safetyMarginMm":10.0,"resections":[{"name":"R","planes":[{"originMm":[10.0,0.0,0.0],)"
           R"("normal":[1.0,0.0,0.0],"bend":)" +
           bend + "}]}]}]";
  };
  const std::string heights = "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]";
  EXPECT_NO_THROW(
      (void)caseJson::toPlans(Json::parse(stored(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0,"heightsMm":)" + heights + "}"))));
  for (const std::string& hostile :
       {R"({"u":[0.0,1.0,0.0],"halfSizeMm":0.0,"heightsMm":)" + heights + "}",
        R"({"u":[0.0,1.0,0.0],"halfSizeMm":null,"heightsMm":)" + heights + "}",
        R"({"u":[1.0,0.0,0.0],"halfSizeMm":50.0,"heightsMm":)" + heights + "}",
        R"({"u":[0.0,1.0],"halfSizeMm":50.0,"heightsMm":)" + heights + "}",
        std::string(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0,"heightsMm":[0,0,0]})"),
        std::string(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0,"heightsMm":7})"),
        std::string(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0,"heightsMm":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1e9]})"),
        std::string(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0,"heightsMm":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,"a"]})"),
        std::string(R"({"u":[0.0,1.0,0.0],"halfSizeMm":50.0})"), std::string("[]"), std::string("3")}) {
    EXPECT_THROW((void)caseJson::toPlans(Json::parse(stored(hostile))), std::exception) << hostile;
  }
}

}  // namespace
}  // namespace glisson
