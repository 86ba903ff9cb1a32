// The document: every change is a named step, a drag is one step, every edit is on disk at once, clean means saved.

#include "app/gui/document.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "app/jobs/inline_job_runner.h"
#include "small_case.h"
#include "wait.h"

namespace glisson {
namespace {

using test::smallCase;
using test::smallCentre;
using test::waitFor;

class DocumentTest : public testing::Test {
 protected:
  QTemporaryDir folder;
  InlineJobRunner jobs;
  std::unique_ptr<Document> document = std::make_unique<Document>(jobs, recovery());

  [[nodiscard]] std::filesystem::path recovery() const { return folder.filePath("recovery").toStdString(); }
  [[nodiscard]] std::filesystem::path named() const { return folder.filePath("case.glisson").toStdString(); }
  void SetUp() override { document->open(smallCase()); }
  [[nodiscard]] bool settle() {
    return waitFor([this] { return jobs.idle() && document->freshness() == Freshness::All; });
  }
  static HalfSpace planeAt(double x) { return {smallCentre() + Vec3(x, 0, 0), Vec3::UnitX()}; }
  [[nodiscard]] ResectionPlan planOnDisk(const std::filesystem::path& path) {
    document->flush();
    return CaseFile::open(path).load().plans.front();
  }
  /// What is on disk now, as the next start opens it; read only here.
  void openAgain(Document& again) {
    document->flush();
    auto file = std::make_shared<CaseFile>(CaseFile::open(document->path()));
    Case read = file->load();
    again.open(std::move(read), std::move(file));
  }
};

TEST_F(DocumentTest, PlacingAPlaneIsOneNamedStepAndUndoTakesItBack) {
  ASSERT_TRUE(settle());
  EXPECT_NEAR(document->assessment().flrPercent, 100.0, 1e-9);
  document->placePlane(planeAt(0));
  ASSERT_TRUE(settle());
  EXPECT_NEAR(document->assessment().resectedMl / document->assessment().totalMl, 0.5, 0.02);
  EXPECT_EQ(document->undoStack().undoText(), "place plane");
  document->undoStack().undo();
  EXPECT_FALSE(document->plane().has_value());
  ASSERT_TRUE(settle());
  EXPECT_EQ(document->assessment().resectedMl, 0.0);
  document->undoStack().redo();
  ASSERT_TRUE(document->plane().has_value());
  EXPECT_EQ(document->plane()->origin, planeAt(0).origin);
}

TEST_F(DocumentTest, ADragOfManyMovesIsOneStep) {
  document->placePlane(planeAt(0));
  const int steps = document->undoStack().count();
  document->beginDrag();
  for (int i = 1; i <= 25; ++i) {
    document->dragTo(planeAt(i));
  }
  document->endDrag(planeAt(25));
  EXPECT_EQ(document->undoStack().count(), steps + 1);
  EXPECT_EQ(document->plane()->origin, planeAt(25).origin);
  document->undoStack().undo();
  EXPECT_EQ(document->plane()->origin, planeAt(0).origin);
}

TEST_F(DocumentTest, AGraspThatMovesNothingIsNoStep) {
  document->placePlane(planeAt(0));
  const int steps = document->undoStack().count();
  document->beginDrag();
  document->endDrag(planeAt(0));
  EXPECT_EQ(document->undoStack().count(), steps);
}

TEST_F(DocumentTest, WhileDraggingAllNumbersFollowInTheFrame) {
  document->setFrameBudgetMs(1e9);
  document->placePlane(planeAt(0));
  ASSERT_TRUE(settle());
  document->beginDrag();
  const PlanAssessor assessor(document->content());
  for (const double x : {18.0, 3.0, 40.0}) {
    document->dragTo(planeAt(x));
    EXPECT_EQ(document->freshness(), Freshness::All);
    EXPECT_EQ(toJson(document->assessment()), toJson(assessor.assessMoving(document->plan())));
  }
  document->endDrag(planeAt(40));
  EXPECT_EQ(document->freshness(), Freshness::All);
  EXPECT_EQ(toJson(document->assessment()), toJson(assessor.assess(document->plan())));
}

TEST_F(DocumentTest, WhereAllNumbersTakeLongerThanAFrameTheVolumesFollowAndTheMarginsAreMarkedOld_H5) {
  document->setFrameBudgetMs(0);
  document->placePlane(planeAt(0));
  ASSERT_TRUE(settle());
  const double before = document->assessment().resectedMl;
  document->beginDrag();
  document->dragTo(planeAt(18));
  EXPECT_LT(document->assessment().resectedMl, before - 10);
  EXPECT_EQ(document->freshness(), Freshness::Volumes);
  EXPECT_EQ(document->assessment().resectedMl + document->assessment().remnantMl, document->assessment().totalMl);
  document->endDrag(planeAt(18));
  ASSERT_TRUE(settle());
  ASSERT_EQ(document->assessment().tumours.size(), 1U);
  EXPECT_EQ(document->assessment().tumours[0].state, TumourState::Cut) << "the tumour is 8 mm about 20 mm";
}

TEST_F(DocumentTest, AnUnsavedEditIsInTheRecoveryFileAtOnce_H6) {
  document->placePlane(planeAt(5));
  EXPECT_TRUE(document->isRecovery());
  EXPECT_FALSE(document->isClean());
  const ResectionPlan stored = planOnDisk(document->path());
  ASSERT_EQ(stored.resections.size(), 1U);
  EXPECT_EQ(stored.resections[0].planes[0].origin, planeAt(5).origin);
}

TEST_F(DocumentTest, ASavedFileReopensWithTheSamePlanAndLooks) {
  document->placePlane(planeAt(7));
  document->setColour("tumour_01", {10, 20, 30});
  document->setOpacity("parenchyma", 0.6);
  document->saveAs(named());
  ASSERT_TRUE(waitFor([this] { return document->isClean(); }));
  EXPECT_FALSE(document->isRecovery());
  document->flush();
  const Case reopened = CaseFile::open(named()).load();
  EXPECT_EQ(reopened.code, document->content().code);
  ASSERT_EQ(reopened.plans.front().resections.size(), 1U);
  EXPECT_EQ(reopened.plans.front().resections[0].planes[0].origin, planeAt(7).origin);
  EXPECT_EQ(reopened.model->find("tumour_01")->colour, (Rgb{10, 20, 30}));
  EXPECT_EQ(reopened.model->find("parenchyma")->opacity, 0.6);
}

TEST_F(DocumentTest, SavingUnderANameRemovesTheRecoveryFile) {
  document->flush();
  const std::filesystem::path recoveryFile = document->path();
  EXPECT_TRUE(std::filesystem::exists(recoveryFile));
  document->saveAs(named());
  ASSERT_TRUE(waitFor([this] { return document->isClean(); }));
  EXPECT_FALSE(std::filesystem::exists(recoveryFile));
  EXPECT_TRUE(std::filesystem::exists(named()));
}

TEST_F(DocumentTest, ACopyWithTheCtIsWrittenWithTheHistoryAndTheCaseStaysWhereItIs) {
  document->placePlane(planeAt(7));
  const std::filesystem::path where = document->path();
  QStringList copies;
  QStringList refusals;
  QObject::connect(document.get(), &Document::copySaved, [&](const QString& path) { copies << path; });
  QObject::connect(document.get(), &Document::storeFailed, [&](const QString& sentence) { refusals << sentence; });
  document->saveCopyWithCt(named());
  ASSERT_TRUE(waitFor([&] { return !copies.isEmpty() || !refusals.isEmpty(); }));
  ASSERT_TRUE(refusals.isEmpty()) << refusals.front().toStdString();
  EXPECT_EQ(document->path(), where);
  EXPECT_TRUE(document->isRecovery());
  const CaseFile copy = CaseFile::open(named());
  ASSERT_TRUE(copy.hasEmbeddedCt());
  EXPECT_EQ(copy.embeddedCt()->hounsfield, document->content().ct->hounsfield);
  ASSERT_EQ(copy.history().size(), 1U);
  EXPECT_EQ(copy.history()[0].name, "place plane");
  document->flush();
  document->saveCopyWithCt(where);
  ASSERT_EQ(refusals.size(), 1);
  EXPECT_TRUE(refusals.front().contains("is the file this case is kept in"));
}

TEST_F(DocumentTest, ACopyWithTheCtVouchesForTheImagesTheCaseWasMadeFromAndNotForWhatLiesThereNow_H2) {
  const std::filesystem::path image = folder.filePath("ct.nii.gz").toStdString();
  std::ofstream(image) << "the images";
  Case content = smallCase();
  content.ctSource = image.string();
  const std::filesystem::path sent = folder.filePath("sent.glisson").toStdString();
  { const CaseFile written = CaseFile::create(sent, content, {}, {.embed = true}); }
  std::ofstream(image) << "another patient";
  auto file = std::make_shared<CaseFile>(CaseFile::open(sent));
  const std::vector<CtFileHash> known = file->ctFiles();
  Case read = file->load();
  read.ct = file->embeddedCt();
  document->open(std::move(read), std::move(file));
  bool done = false;
  QObject::connect(document.get(), &Document::copySaved, [&] { done = true; });
  document->saveCopyWithCt(named());
  ASSERT_TRUE(waitFor([&] { return done; }));
  const CaseFile copy = CaseFile::open(named());
  EXPECT_TRUE(copy.hasEmbeddedCt());
  EXPECT_EQ(copy.ctFiles(), known);
  EXPECT_FALSE(copy.ctUnchanged());
}

TEST_F(DocumentTest, ACaseThatCameWithItsCtKeepsItUnderAnotherName) {
  Case content = smallCase();
  content.ctSource = "/nowhere/ct.nii.gz";
  const std::filesystem::path sent = folder.filePath("sent.glisson").toStdString();
  { const CaseFile written = CaseFile::create(sent, content, {}, {.embed = true}); }
  auto file = std::make_shared<CaseFile>(CaseFile::open(sent));
  Case read = file->load();
  read.ct = file->embeddedCt();
  document->open(std::move(read), std::move(file));
  document->saveAs(named());
  ASSERT_TRUE(waitFor([this] { return document->isClean() && document->path() == named(); }));
  document->flush();
  ASSERT_TRUE(CaseFile::open(named()).hasEmbeddedCt());
  EXPECT_EQ(CaseFile::open(named()).embeddedCt()->hounsfield, content.ct->hounsfield);
}

TEST_F(DocumentTest, CleanMeansSaved) {
  document->placePlane(planeAt(0));
  document->saveAs(named());
  ASSERT_TRUE(waitFor([this] { return document->isClean(); }));
  document->movePlane(planeAt(3));
  EXPECT_FALSE(document->isClean());
  document->undoStack().undo();
  EXPECT_TRUE(document->isClean());
  document->undoStack().redo();
  document->save();
  ASSERT_TRUE(waitFor([this] { return document->isClean(); }));
  EXPECT_EQ(planOnDisk(named()).resections[0].planes[0].origin, planeAt(3).origin);
}

TEST_F(DocumentTest, LooksAreNamedStepsAndASlideIsOne) {
  const Rgb before = document->content().model->find("portal_vein")->colour;
  const auto slide = [this](const char* id) {
    for (int i = 1; i <= 9; ++i) {
      document->setOpacity(id, 0.1 * i);
    }
  };
  document->setColour("portal_vein", {1, 2, 3});
  slide("parenchyma");
  document->setVisible("tumour_01", false);
  document->setVisible("tumour_01", false);
  slide("parenchyma");
  slide("portal_vein");
  QUndoStack& stack = document->undoStack();
  ASSERT_EQ(stack.count(), 5) << "another structure is another slide";
  stack.undo();
  stack.undo();
  EXPECT_EQ(stack.undoText(), "hide tumour 1");
  EXPECT_EQ(document->content().model->find("parenchyma")->opacity, 0.9);
  stack.undo();
  EXPECT_TRUE(document->content().model->find("tumour_01")->visible);
  EXPECT_EQ(stack.undoText(), "change opacity");
  stack.undo();
  EXPECT_EQ(document->content().model->find("parenchyma")->opacity, 0.35);
  stack.undo();
  EXPECT_EQ(document->content().model->find("portal_vein")->colour, before);
}

TEST_F(DocumentTest, AReconstructionThatFinishesLateKeepsTheColourSetMeanwhile) {
  const Case content = document->content();
  const Structure built = buildStructure(content, *content.model->find("tumour_01"));
  document->setColour("tumour_01", {9, 8, 7});
  document->setReconstruction("tumour_01", built.reconstruction);
  EXPECT_EQ(document->content().model->find("tumour_01")->colour, (Rgb{9, 8, 7}));
  EXPECT_FALSE(document->content().model->find("tumour_01")->reconstruction->mesh.empty());
}

TEST_F(DocumentTest, AnAcceptanceIsANamedStepOnDiskAtOnceAndEndsWithItsSurface_H5) {
  const Case content = document->content();
  const auto now = [this](const char* id) { return document->content().model->find(id)->acceptance; };
  document->accept({"portal_vein"}, "Dr. A");
  EXPECT_EQ(document->undoStack().count(), 0) << "there is no surface to look at";
  document->setReconstruction("portal_vein", buildStructure(content, *content.model->find("portal_vein")).reconstruction);
  document->setReconstruction("tumour_01", buildStructure(content, *content.model->find("tumour_01")).reconstruction);
  document->accept({"portal_vein"}, "Dr. A");
  EXPECT_EQ(document->undoStack().undoText(), "accept portal vein");
  ASSERT_TRUE(now("portal_vein"));
  document->flush();
  EXPECT_EQ(CaseFile::open(document->path()).load().model->find("portal_vein")->acceptance, now("portal_vein"));
  document->setColour("portal_vein", {1, 2, 3});
  EXPECT_TRUE(now("portal_vein")) << "a colour is no other surface";
  document->undoStack().undo();
  document->accept({"portal_vein", "tumour_01", "parenchyma"}, "B");
  EXPECT_EQ(document->undoStack().undoText(), "accept structures");
  EXPECT_EQ(now("tumour_01")->by, "B");
  document->undoStack().undo();
  EXPECT_EQ(now("portal_vein")->by, "Dr. A");
  EXPECT_FALSE(now("tumour_01"));
  document->withdrawAcceptance("portal_vein");
  EXPECT_EQ(document->undoStack().undoText(), "withdraw the acceptance of portal vein");
  EXPECT_FALSE(now("portal_vein"));
  document->undoStack().undo();
  EXPECT_TRUE(now("portal_vein"));
  document->setReconstruction("portal_vein", buildStructure(content, *content.model->find("portal_vein")).reconstruction);
  EXPECT_FALSE(now("portal_vein"));
  document->undoStack().undo();
  document->undoStack().redo();
  EXPECT_FALSE(now("portal_vein")) << "nobody has looked at the new surface";
  document->flush();
  EXPECT_FALSE(CaseFile::open(document->path()).load().model->find("portal_vein")->acceptance);
}

TEST_F(DocumentTest, ACaseThatWasOnlyLookedAtLeavesNothingBehindAndAnEditedOneStays_H6) {
  document->flush();
  const std::filesystem::path first = document->path();
  document->open(smallCase());
  document->flush();
  EXPECT_FALSE(std::filesystem::exists(first));
  const std::filesystem::path second = document->path();
  document->placePlane(planeAt(0));
  document.reset();
  EXPECT_TRUE(std::filesystem::exists(second));
}

TEST_F(DocumentTest, AnAssessmentThatEndsDuringADragIsNotShownAsCurrent_H5) {
  document->setFrameBudgetMs(0);
  ASSERT_TRUE(settle());
  document->placePlane(planeAt(0));  // its assessment is queued
  document->beginDrag();
  document->dragTo(planeAt(10));
  ASSERT_TRUE(waitFor([this] { return jobs.idle(); }));
  EXPECT_EQ(document->freshness(), Freshness::Volumes);
  document->endDrag(planeAt(10));
  EXPECT_TRUE(settle());
}

TEST_F(DocumentTest, AReopenedCaseHasItsUndoHistoryWithNamesWithoutWhatWasUndone) {
  document->placePlane(planeAt(0));
  document->movePlane(planeAt(5));
  document->movePlane(planeAt(9));
  document->undoStack().undo();
  document->edit(SetSafetyMargin{4});
  document->saveAs(named());
  document->flush();
  document->close();
  auto file = std::make_shared<CaseFile>(CaseFile::open(named()));
  Case read = file->load();
  Document again(jobs, recovery());
  again.open(std::move(read), std::move(file));
  QUndoStack& stack = again.undoStack();
  EXPECT_TRUE(again.isClean());
  ASSERT_EQ(stack.count(), 3);
  EXPECT_EQ(stack.undoText(), "change safety margin");
  stack.undo();
  EXPECT_EQ(again.plan().safetyMarginMm, 10);
  again.flush();
}

TEST_F(DocumentTest, H6ACaseThatMayOnlyBeReadIsEditedInACopyThatIsKept) {
  document->placePlane(planeAt(0));
  document->saveAs(named());
  ASSERT_TRUE(waitFor([&] { return document->isClean(); }));
  const std::string code = document->content().code;
  {
    Document other(jobs, recovery());  // while the first one still writes it
    openAgain(other);
    ASSERT_TRUE(other.isReadOnly());
    EXPECT_EQ(other.path(), named());
    other.movePlane(planeAt(7));
    PatientFacts tall;
    tall.heightCm = 170;
    other.setPatient(tall);
    EXPECT_FALSE(other.isReadOnly());
    EXPECT_TRUE(other.isRecovery());
    EXPECT_FALSE(other.isClean());
    EXPECT_EQ(other.path().parent_path(), recovery());
    other.flush();
    EXPECT_TRUE(other.keepsAll());
  }
  EXPECT_EQ(planOnDisk(named()).resections[0].planes[0].origin, planeAt(0).origin);
  const Case copy = CaseFile::open(recovery() / (code + ".glisson")).load();
  EXPECT_EQ(copy.plans[0].resections[0].planes[0].origin, planeAt(7).origin);
  EXPECT_EQ(copy.patient.heightCm, 170);
  EXPECT_EQ(CaseFile::open(recovery() / (code + ".glisson")).history().size(), 3U);
}

TEST_F(DocumentTest, H6AnEditThatIsInNoFileIsKnown) {
  document->flush();
  ASSERT_TRUE(document->keepsAll());
  std::filesystem::remove_all(recovery());
  std::ofstream(recovery()) << "a file where the folder was";
  Document homeless(jobs, recovery());
  homeless.open(smallCase());
  homeless.placePlane(planeAt(3));
  homeless.flush();
  EXPECT_FALSE(homeless.keepsAll());
  homeless.saveAs(named());
  homeless.flush();
  EXPECT_TRUE(homeless.keepsAll());
  EXPECT_EQ(planOnDisk(named()).resections[0].planes[0].origin, planeAt(3).origin);
}

TEST_F(DocumentTest, ACrashLosesNoEditOfThePatientNorItsPlaceInTheHistory_H6) {
  const PatientFacts tall{190, 80, LiverCondition::Normal, std::nullopt};
  const PatientFacts small{160, 80, LiverCondition::Injured, std::nullopt};
  document->setPatient(tall);
  document->placePlane(planeAt(0));
  document->setPatient(small);
  document->setPatient(tall);
  document->undoStack().undo();
  document->undoStack().undo();
  document->undoStack().redo();
  Document again(jobs, recovery());
  openAgain(again);
  QUndoStack& stack = again.undoStack();
  ASSERT_EQ(stack.count(), 3);
  EXPECT_EQ(again.content().patient, small);
  EXPECT_EQ(stack.undoText(), "change patient facts");
  stack.undo();
  EXPECT_EQ(again.content().patient, tall);
  EXPECT_TRUE(again.plane().has_value());
  stack.undo();
  EXPECT_FALSE(again.plane().has_value());
  EXPECT_EQ(again.content().patient, tall);
  stack.undo();
  EXPECT_EQ(again.content().patient, PatientFacts());
  stack.redo();
  EXPECT_EQ(again.content().patient, tall);
}

TEST_F(DocumentTest, ACrashLosesNeitherTheLastEditNorItsHistory_H6) {
  document->placePlane(planeAt(0));
  document->movePlane(planeAt(5));
  document->movePlane(planeAt(9));
  document->undoStack().undo();
  document->edit(SetSafetyMargin{4});
  Document again(jobs, recovery());
  openAgain(again);
  QUndoStack& stack = again.undoStack();
  ASSERT_EQ(stack.count(), 3);
  EXPECT_EQ(stack.undoText(), "change safety margin");
  stack.undo();
  EXPECT_EQ(stack.undoText(), "move plane");
  EXPECT_EQ(again.plan().safetyMarginMm, 10);
  EXPECT_EQ(again.plane()->origin, planeAt(5).origin);
  stack.undo();
  EXPECT_EQ(again.plane()->origin, planeAt(0).origin);
  stack.undo();
  EXPECT_FALSE(again.plane().has_value());
}

TEST_F(DocumentTest, ACrashLosesNoEditOfAnyKindNorItsPlaceInTheHistory_H6) {
  const Case content = document->content();
  const TerritoryMarks arm{{{"arm", {Vec3(1, 2, 3)}}}, false};
  const TerritoryMarks confirmed{{{"left", {Vec3(4, 5, 6)}}, {"right", {Vec3(7, 8, 9)}}}, true};
  document->setReconstruction("tumour_01", buildStructure(content, *content.model->find("tumour_01")).reconstruction);
  document->setColour("portal_vein", {1, 2, 3});
  document->setTerritories(confirmed, "confirm territories");
  document->placePlane(planeAt(0));
  document->accept({"tumour_01"}, "Dr. A");
  for (int i = 1; i <= 120; ++i) {
    document->setOpacity("parenchyma", 0.005 * i);
  }
  document->setVisible("tumour_01", false);
  document->setTerritories(arm, "pick territory");
  document->undoStack().undo();
  document->undoStack().undo();
  document->undoStack().redo();
  const QUndoStack& left = document->undoStack();
  QStringList names;
  for (int n = 0; n < left.index(); ++n) {
    names << left.text(n);
  }
  Document again(jobs, recovery());
  openAgain(again);
  QUndoStack& stack = again.undoStack();
  QStringList restored;
  for (int n = 0; n < stack.count(); ++n) {
    restored << stack.text(n);
  }
  EXPECT_EQ(restored, names) << restored.join(", ").toStdString();
  ASSERT_EQ(stack.count(), 6);
  const auto now = [&](const char* id) { return *again.content().model->find(id); };
  EXPECT_FALSE(now("tumour_01").visible);
  EXPECT_EQ(again.content().territories, confirmed);
  stack.undo();
  EXPECT_TRUE(now("tumour_01").visible);
  stack.undo();
  EXPECT_EQ(now("parenchyma").opacity, 0.35) << "the slide is one step";
  stack.undo();
  EXPECT_FALSE(now("tumour_01").acceptance);
  stack.redo();
  EXPECT_EQ(now("tumour_01").acceptance->by, "Dr. A") << "it is the surface that was looked at";
  stack.undo();
  stack.undo();
  stack.undo();
  EXPECT_EQ(again.content().territories, TerritoryMarks());
  stack.undo();
  EXPECT_EQ(now("portal_vein").colour, content.model->find("portal_vein")->colour);
  stack.redo();
  EXPECT_EQ(now("portal_vein").colour, (Rgb{1, 2, 3}));
}

TEST_F(DocumentTest, AnAcceptanceOfAnEarlierSessionIsNotDoneAgainOnAnotherSurface_H5) {
  const Case content = document->content();
  document->setReconstruction("tumour_01", buildStructure(content, *content.model->find("tumour_01")).reconstruction);
  document->accept({"tumour_01"}, "Dr. A");
  auto other = std::make_shared<Reconstruction>(*buildStructure(content, *content.model->find("tumour_01")).reconstruction);
  other->mesh.vertices.front() += Vec3(0.1, 0, 0);
  document->setReconstruction("tumour_01", other);
  Document again(jobs, recovery());
  openAgain(again);
  ASSERT_EQ(again.undoStack().undoText(), "accept tumour 1");
  again.undoStack().undo();
  again.undoStack().redo();
  EXPECT_FALSE(again.content().model->find("tumour_01")->acceptance);
}

}  // namespace
}  // namespace glisson
