// What the window says: the headline of the tumours, counts only where they are known, reasons where a number or a picture is
// missing, and words that fit into the smallest window. Needs a display.

#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QScrollBar>
#include <QSemaphore>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include "app/gui/main_window.h"
#include "app/gui/title_line.h"
#include "app/gui/view_area.h"
#include "app/jobs/thread_job_runner.h"
#include "planning/storage/case_file.h"
#include "small_case.h"
#include "viewer/resectogram.h"
#include "wait.h"

namespace glisson {
namespace {

using test::maskWhere;
using test::smallCase;
using test::smallCentre;
using test::smallGrid;
using test::waitFor;

/// The small liver with three tumours in a row from its right to its left, 14 mm apart from surface to surface.
Case threeTumours() {
  const Case small = smallCase();
  auto segmentation = std::make_shared<Segmentation>(*small.segmentation);
  LabelledMask tumour = segmentation->structures[1];
  segmentation->structures.erase(segmentation->structures.begin() + 1);
  for (int n = 0; n < 3; ++n) {
    const Vec3 middle = smallCentre() + Vec3(24.0 * (n - 1), 0, 4);
    tumour.name = "livertumor0" + std::to_string(n + 1);
    tumour.mask = std::make_shared<const Mask>(maskWhere(smallGrid(), [&](const Vec3& p) { return (p - middle).norm() <= 5; }));
    segmentation->structures.push_back(tumour);
  }
  return newCase(small.ct, segmentation);
}

class ShownTextsTest : public testing::Test {
 protected:
  QTemporaryDir folder;
  Language language;
  std::unique_ptr<ThreadJobRunner> jobs = std::make_unique<ThreadJobRunner>(2);
  std::unique_ptr<MainWindow> window;

  void SetUp() override {
    QSettings().remove("cutMap");
    language.use("en");
    showWindow();
  }
  void TearDown() override {
    jobs.reset();
    window.reset();
  }
  void showWindow() {
    window = std::make_unique<MainWindow>(*jobs, language, folder.filePath("recovery").toStdString());
    window->resize(1024, 700);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  template <class T>
  T* find(const QString& name) {
    T* found = window->findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name.toStdString();
    return found;
  }
  std::string text(const QString& label) { return find<QLabel>(label)->text().toStdString(); }
  bool says(const QString& label, const char* part) { return find<QLabel>(label)->text().contains(QString::fromUtf8(part)); }
  Document& document() { return window->document(); }
  bool settle() {
    return waitFor([this] { return jobs->idle() && document().freshness() == Freshness::All; });
  }
  void open(const Case& content) {
    emit window->opener().opened(content, nullptr, {});
    ASSERT_TRUE(settle());
    window->workspaces().setCurrent(Workspace::Plan);
  }
  /// What lies to the patient's left of the plane, `mm` from the liver's middle, is resected.
  void cutAt(double mm) {
    document().placePlane({smallCentre() + Vec3(mm, 0, 0), Vec3::UnitX()});
    ASSERT_TRUE(settle());
  }
  void speakGerman() {
    window->setLanguage("de");
    ASSERT_TRUE(waitFor([&] { return find<QLabel>("notForClinicalUse")->text() != "Not for clinical use"; }));
    QTest::qWait(50);  // layouts settle in the event loop
  }
};

TEST_F(ShownTextsTest, TumoursThatStayAreTheHeadlineAndNotTheWideMarginOfTheOneThatGoes) {
  open(threeTumours());
  cutAt(12);
  EXPECT_EQ(text("marginValue"), "2 of 3");
  EXPECT_EQ(text("marginShare"), "left");
  EXPECT_TRUE(says("marginReason", "in the remnant")) << text("marginReason");
  EXPECT_TRUE(says("marginReason", "\u26A0")) << "not by colour only";
  EXPECT_TRUE(says("marginCaption", "\u00A0mm")) << "the margin of what is removed stays readable: " << text("marginCaption");
  EXPECT_TRUE(find<QWidget>("margin")->toolTip().contains("livertumor02"));

  cutAt(33);
  EXPECT_EQ(text("marginValue"), "3 of 3");
  EXPECT_TRUE(says("marginCaption", "none is removed")) << text("marginCaption");
  EXPECT_FALSE(says("marginCaption", "\u00A0mm")) << "a tumour that is left has no margin: " << text("marginCaption");
}

TEST_F(ShownTextsTest, ACutTumourComesFirstAndTheLeastMarginOnlyWhereAllAreRemoved) {
  open(threeTumours());
  cutAt(0);
  EXPECT_TRUE(says("marginCaption", "livertumor02")) << text("marginCaption");
  EXPECT_TRUE(says("marginValue", "-")) << text("marginValue");
  EXPECT_TRUE(says("marginReason", "is cut, 1 left")) << text("marginReason");

  cutAt(-32);
  EXPECT_TRUE(says("marginCaption", "livertumor01")) << text("marginCaption");
  EXPECT_TRUE(says("marginReason", "below 10")) << text("marginReason");
}

TEST_F(ShownTextsTest, APlaneBesideTheLiverSaysSoAndCountsNoVessels) {
  open(threeTumours());
  EXPECT_FALSE(says("vesselsTitle", "0")) << text("vesselsTitle");
  cutAt(0);
  EXPECT_TRUE(says("vesselsTitle", "Vessels crossed: 1")) << text("vesselsTitle");
  cutAt(900);
  EXPECT_EQ(find<QLabel>("marginValue")->text(), "- mm");
  EXPECT_EQ(text("marginReason"), "the liver is not divided");
  EXPECT_FALSE(says("vesselsTitle", "0")) << text("vesselsTitle");
}

TEST_F(ShownTextsTest, WithoutAPlaneNoUncertaintyOfACutIsShown) {
  open(threeTumours());
  EXPECT_FALSE(says("volumeNote", "uncertainty")) << text("volumeNote");
  cutAt(0);
  EXPECT_TRUE(says("volumeNote", "uncertainty of the cut")) << text("volumeNote");
}

TEST_F(ShownTextsTest, TheTablesOfThePlanCutNoRowInHalfAndNumberedNamesStayReadable) {
  open(threeTumours());
  cutAt(0);
  for (const bool german : {false, true}) {
    if (german) {
      speakGerman();
    }
    QTest::qWait(50);  // layouts settle in the event loop
    for (const char* name : {"tumourTable", "vesselTable"}) {
      auto* table = find<QTreeWidget>(name);
      const int row = table->visualItemRect(table->topLevelItem(0)).height();
      EXPECT_EQ(table->viewport()->height() % row, 0) << name;
    }
    auto* tumours = find<QTreeWidget>("tumourTable");
    EXPECT_FALSE(tumours->verticalScrollBar()->isVisible());
    const QString name = tumours->topLevelItem(0)->text(0);
    const QRect cell = tumours->visualItemRect(tumours->topLevelItem(0));
    const int room = std::min(cell.width(), tumours->columnWidth(0)) - 8;
    const QString shown = tumours->fontMetrics().elidedText(name, Qt::ElideMiddle, room);
    EXPECT_GE(shown.size(), 9) << shown.toStdString();
  }
}

TEST_F(ShownTextsTest, TheMapOfTheCutSaysNothingThatIsCutOffInTheSmallestWindowInGermanToo) {
  open(threeTumours());
  cutAt(0);
  speakGerman();
  auto* map = find<Resectogram>("resectogram");
  ASSERT_TRUE(waitFor([&] { return map->isVisible() && map->texts().size() == 4; }));
  for (const QString& words : map->texts()) {
    EXPECT_LE(map->fontMetrics().horizontalAdvance(words), map->width() - 12) << words.toStdString();
  }
}

TEST_F(ShownTextsTest, TheMapOfTheCutIsFoldedByTheMenuAndStaysSoInTheNextWindow) {
  auto* action = find<QAction>("actionCutMap");
  EXPECT_TRUE(action->isChecked());
  action->trigger();
  EXPECT_FALSE(window->views().modelView().mapShown());
  window.reset();
  showWindow();
  EXPECT_FALSE(window->views().modelView().mapShown());
  EXPECT_FALSE(find<QAction>("actionCutMap")->isChecked());
  window->views().modelView().setMapShown(true);
  EXPECT_TRUE(find<QAction>("actionCutMap")->isChecked());
}

TEST_F(ShownTextsTest, AJobAloneShowsItsWholeTitle) {
  QSemaphore ends;
  JobRequest request{.title = "Making the sample patient"};
  submitFor<int>(
      *jobs, std::move(request),
      [&ends](const ExecutionContext&) {
        ends.acquire();
        return 0;
      },
      [](int) {});
  EXPECT_TRUE(waitFor([&] { return window->findChild<QLabel*>("jobName") != nullptr; }));
  EXPECT_EQ(text("jobName"), "Making the sample patient");
  ends.release();
  EXPECT_TRUE(waitFor([&] { return jobs->idle(); }));
}

TEST_F(ShownTextsTest, AMissingCtIsToldInTheSlicesWithTheWayOut) {
  Case content = smallCase();
  content.ctSource = folder.filePath("gone").toStdString();
  const std::filesystem::path path = folder.filePath("gone.glisson").toStdString();
  { const CaseFile written = CaseFile::create(path, content); }
  window->opener().openPaths({QString::fromStdString(path.string())});
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().noCt().isEmpty(); }));
  EXPECT_TRUE(document().noCt().contains("no longer at"));
  EXPECT_TRUE(document().noCt().contains("put it back"));
  ASSERT_TRUE(settle());
  emit window->opener().opened(smallCase(), nullptr, {});
  EXPECT_TRUE(document().noCt().isEmpty()) << "another case has its own";
  EXPECT_TRUE(settle());
}

TEST_F(ShownTextsTest, APhaseThatIsNotKnownLeavesNoDashBehindTheCtsDate) {
  open(smallCase());
  EXPECT_TRUE(window->titleLine().text().endsWith("2024-05-06")) << window->titleLine().text().toStdString();
}

}  // namespace
}  // namespace glisson
