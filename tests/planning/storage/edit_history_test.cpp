// Edits of every kind in the case file: their undo records come back, are copied, and survive what they do not know.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "planning/storage/case_file.h"
#include "planning/storage/surface_hash.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/storage/run_sql.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;
namespace fs = std::filesystem;

const PatientFacts kTall{190, 80, LiverCondition::Normal, std::nullopt};
const TerritoryMarks kArm{{{"arm", {Vec3(1.0 / 3, 2, 3)}}}, false};
const Acceptance kByA{"Dr. A", "2026-01-31T09:05:00Z"};

std::vector<ResectionPlan> plansAt(double x) { return {{"Plan 1", {{"Resection 1", {{Vec3(x, 0, 0), Vec3::UnitX()}}}}, 10}}; }

std::shared_ptr<Reconstruction> surfaceOf(double size) {
  auto made = std::make_shared<Reconstruction>();
  made->parameters = ReconstructionParameters::defaultsFor(StructureKind::Liver);
  made->mesh.vertices = {Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(0, size, 0), Vec3(0, 0, size)};
  made->mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return made;
}

Case builtCase() {
  const ImageGeometry g = gridOf({20, 20, 20}, Vec3(1, 1, 1));
  Case made = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(10, 10, 10), 6)},
                                                  {"tumour", StructureKind::Tumour, ball(Vec3(10, 10, 10), 2)}}));
  made.model = withStructure(*made.model, withReconstruction(*made.model->find("parenchyma"), surfaceOf(3)));
  return made;
}

std::shared_ptr<const LiverModel> with(const LiverModel& model, const std::string& id,
                                       const std::function<void(Structure&)>& change) {
  Structure structure = *model.find(id);
  change(structure);
  return withStructure(model, structure);
}

class EditHistoryTest : public testing::Test {
 protected:
  Scratch scratch;
  Case source = builtCase();
  [[nodiscard]] fs::path file() const { return scratch.path / "a.glisson"; }

  /// One edit of each kind, and one that takes the last back.
  void editAll() const {
    CaseFile made = CaseFile::create(file(), source);
    made.storePlans(plansAt(9), "place plane");
    made.storePatient(kTall, "change patient facts");
    made.storeTerritories(kArm, "pick territory");
    const auto red = with(*source.model, "tumour_01", [](Structure& s) { s.colour = {200, 1, 2}; });
    made.storeModel(*red, "change colour");
    const auto accepted = withAcceptance(*red, {"parenchyma"}, kByA);
    made.storeModel(*accepted, "accept liver");
    made.storeModel(*with(*accepted, "tumour_01", [](Structure& s) { s.visible = false; }), "hide tumour");
    made.storeModel(*accepted);
  }
};

TEST_F(EditHistoryTest, EveryKindOfEditComesBackWithItsRecordAlsoFromACopy) {
  editAll();
  const CaseFile opened = CaseFile::open(file());
  const std::vector<EditStep> steps = opened.history();
  ASSERT_EQ(steps.size(), 7U);
  EXPECT_EQ(steps[0].after, plansAt(9));
  ASSERT_TRUE(steps[1].patient);
  EXPECT_EQ(steps[1].patient->after, kTall);
  ASSERT_TRUE(steps[2].territories);
  EXPECT_EQ(steps[2].name, "pick territory");
  EXPECT_EQ(steps[2].territories->before, TerritoryMarks());
  EXPECT_EQ(steps[2].territories->after, kArm) << "bit for bit";
  ASSERT_TRUE(steps[3].structures);
  ASSERT_EQ(steps[3].structures->after.size(), 1U) << "of the structure that was changed";
  EXPECT_EQ(steps[3].structures->before[0], stateOf(*source.model->find("tumour_01")));
  EXPECT_EQ(steps[3].structures->after[0].colour, (Rgb{200, 1, 2}));
  EXPECT_EQ(steps[3].structures->after[0].surface, "");
  ASSERT_TRUE(steps[4].structures);
  EXPECT_EQ(steps[4].structures->before[0].acceptance, std::nullopt);
  EXPECT_EQ(steps[4].structures->after[0].acceptance, kByA);
  EXPECT_EQ(steps[4].structures->after[0].surface, surfaceHash(source.model->find("parenchyma")->reconstruction->mesh));
  EXPECT_FALSE(steps[5].structures->after[0].visible);
  for (const EditStep& step : steps) {
    EXPECT_EQ(&step == &steps[0], step.before != step.after) << step.name << ": an older program takes it for no edit";
  }
  const std::vector<EditStep> standing = standingEdits(steps);
  ASSERT_EQ(standing.size(), 5U) << "what was hidden is shown again";
  EXPECT_EQ(standing.back().name, "accept liver");
  EXPECT_EQ(CaseFile::create(scratch.path / "b.glisson", opened.load(), steps).history(), steps);
}

TEST_F(EditHistoryTest, ASurfaceThatIsMadeIsNoEditNorIsTheAcceptanceThatEndsWithIt) {
  editAll();
  CaseFile opened = CaseFile::open(file());
  const std::size_t before = opened.history().size();
  const Case read = opened.load();
  opened.storeModel(*withStructure(*read.model, withReconstruction(*read.model->find("parenchyma"), surfaceOf(5))), "nothing");
  EXPECT_EQ(opened.history().size(), before);
  EXPECT_FALSE(CaseFile::open(file()).load().model->find("parenchyma")->acceptance);
}

TEST_F(EditHistoryTest, AcceptanceOfTheStoredSurfaceIsAnEditAlsoWhereTheCaseWasReadFromAnotherFile) {
  editAll();
  const Case read = CaseFile::open(file()).load();
  CaseFile::open(file()).storeModel(*withAcceptance(*read.model, {"parenchyma"}, std::nullopt), "withdraw");
  const EditStep last = CaseFile::open(file()).history().back();
  EXPECT_EQ(last.name, "withdraw");
  ASSERT_TRUE(last.structures);
  EXPECT_EQ(last.structures->before[0].acceptance, kByA);
}

TEST_F(EditHistoryTest, WhatGoesOnIsOneRecord) {
  CaseFile made = CaseFile::create(file(), source);
  std::shared_ptr<const LiverModel> model = source.model;
  for (const double opacity : {0.4, 0.5, 0.6}) {
    model = with(*model, "parenchyma", [&](Structure& s) { s.opacity = opacity; });
    made.store({.model = model.get(), .modelEdit = "change opacity", .modelGoesOn = opacity > 0.4});
  }
  ASSERT_EQ(made.history().size(), 1U);
  EXPECT_EQ(made.history()[0].structures->before[0].opacity, 0.35);
  EXPECT_EQ(made.history()[0].structures->after[0].opacity, 0.6);
  made.storePlans(plansAt(9), "place plane");
  model = with(*model, "parenchyma", [](Structure& s) { s.opacity = 0.7; });
  made.store({.model = model.get(), .modelEdit = "change opacity", .modelGoesOn = true});
  EXPECT_EQ(made.history().size(), 3U) << "another edit lies between";
}

TEST_F(EditHistoryTest, FileFromBeforeTheseEditsWereRecordedOpensAndRecordsTheNextOnes) {
  editAll();
  const Case read = CaseFile::open(file()).load();
  runSql(file(),
         "ALTER TABLE history DROP COLUMN territories_before; ALTER TABLE history DROP COLUMN territories_after;"
         "ALTER TABLE history DROP COLUMN structures_before; ALTER TABLE history DROP COLUMN structures_after;");
  CaseFile opened = CaseFile::open(file());
  EXPECT_EQ(standingEdits(opened.history()).size(), 2U) << "those of the plans and the patient";
  EXPECT_EQ(opened.load().territories, kArm);
  opened.storeTerritories({}, "propose territories");
  opened.storeModel(*with(*read.model, "tumour_01", [](Structure& s) { s.opacity = 0.5; }), "change opacity");
  const std::vector<EditStep> steps = standingEdits(opened.history());
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[2].territories->before, kArm);
  EXPECT_EQ(steps[3].structures->after[0].opacity, 0.5);
}

TEST_F(EditHistoryTest, RecordsThatDoNotFitAreRefusedWithASentence) {
  for (const char* column : {"territories_after", "structures_after"}) {
    for (const char* wrong : {"{}", "7", "no json", "[{\"id\":7}]", "[]", "{\"proposed\":true,\"marks\":[{\"name\":\"\"}]}"}) {
      fs::remove(file());
      editAll();
      runSql(file(), "UPDATE history SET " + std::string(column) + " = '" + wrong + "' WHERE " + column + " IS NOT NULL");
      EXPECT_THROW((void)CaseFile::open(file()).history(), InputError) << column << " " << wrong;
    }
  }
}

TEST_F(EditHistoryTest, KilledAtAnyInstantStateAndRecordAreOfTheSameEdit_H6) {
  { CaseFile::create(file(), source); }
  for (int n = 0; n < 30; ++n) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      CaseFile opened = CaseFile::open(file());
      std::shared_ptr<const LiverModel> model = opened.load().model;
      for (int step = 1;; ++step) {
        model = with(*model, "tumour_01", [&](Structure& s) { s.opacity = 1.0 / (1 + 1000 * n + step); });
        opened.storeModel(*model, "change opacity");
        opened.storeTerritories({{{std::to_string(1000 * n + step), {Vec3(1, 2, 3)}}}, false}, "pick territory");
        (void)!::write(pipe[1], &step, sizeof(step));
      }
    }
    ::close(pipe[1]);
    int told = 0;
    while (told < 2) {
      ASSERT_EQ(::read(pipe[0], &told, sizeof(told)), static_cast<ssize_t>(sizeof(told)));
    }
    ::usleep(static_cast<useconds_t>(397 * n));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(pipe[0]);
    const CaseFile opened = CaseFile::open(file());
    const Case read = opened.load();
    const std::vector<EditStep> steps = opened.history(2);
    ASSERT_EQ(steps.size(), 2U);
    for (const EditStep& step : steps) {
      if (step.structures) {
        EXPECT_EQ(step.structures->after[0], stateOf(*read.model->find("tumour_01")));
      } else {
        ASSERT_TRUE(step.territories);
        EXPECT_EQ(step.territories->after, read.territories);
      }
    }
  }
}

TEST(StandingEdits, AnUndoTakesBackItsOwnKindOnly) {
  EditStep plans{"place plane", plansAt(1), plansAt(2)};
  EditStep patient{"change patient facts", plansAt(2), plansAt(2)};
  patient.patient = {PatientFacts(), kTall};
  EditStep back{"", plansAt(2), plansAt(2)};
  back.patient = {kTall, PatientFacts()};
  EXPECT_EQ(standingEdits({plans, patient, back}), std::vector<EditStep>{plans});
  EditStep territories{"", plansAt(2), plansAt(2)};
  territories.territories = {kArm, TerritoryMarks()};
  EXPECT_EQ(standingEdits({plans, patient, territories}).size(), 3U) << "an edit without a name that leads nowhere back";
  EXPECT_TRUE(standingEdits({EditStep{"unknown", plansAt(2), plansAt(2)}}).empty());
}

TEST(WithState, ChangesWhatDiffersAndLeavesTheRest) {
  const Case source = builtCase();
  StructureState from = stateOf(*source.model->find("tumour_01"));
  StructureState to = from;
  to.opacity = 0.25;
  const auto moved = with(*source.model, "tumour_01", [](Structure& s) { s.colour = {1, 2, 3}; });
  const auto changed = withState(*moved, from, to);
  EXPECT_EQ(changed->find("tumour_01")->opacity, 0.25);
  EXPECT_EQ(changed->find("tumour_01")->colour, (Rgb{1, 2, 3}));
  EXPECT_GT(changed->revision, moved->revision);
  to.acceptance = kByA;
  EXPECT_THROW((void)withState(*moved, from, to), PlanningError) << "it has no surface";
  to.id = "tumour_09";
  EXPECT_THROW((void)withState(*moved, from, to), PlanningError);
}

}  // namespace
}  // namespace glisson
