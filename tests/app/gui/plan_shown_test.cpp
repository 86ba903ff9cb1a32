// What the window shows of a plan: territories in the 3D view, the area of the cut, several resections, where vessels are crossed.

#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTreeWidget>

#include "app/gui/number_text.h"
#include "app/gui/screenshot.h"
#include "app/gui/territory_estimator.h"
#include "app/gui/view_area.h"
#include "main_window_test.h"
#include "pdf_text.h"
#include "planning/report/compare_plans.h"
#include "planning/storage/case_file.h"
#include "reconstruction/sample/volume_writers.h"
#include "tests/planning/territories/fork.h"
#include "tests/viewer/kept_picture.h"

namespace glisson {
namespace {

using test::smallCentre;
using test::waitFor;

class PlanShown : public test::MainWindowTest {
 protected:
  /// Pixels of exactly this colour in one half of the 3D view.
  int pixelsOf(const QColor& colour, bool rightHalf) {
    const QImage image = window->views().modelView().picture();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        count += (x >= image.width() / 2) == rightHalf && image.pixelColor(x, y) == colour ? 1 : 0;
      }
    }
    return count;
  }
  QColor swatch(int row) {
    const QImage icon = find<QTreeWidget>("territoryTable")->topLevelItem(row)->icon(0).pixmap(12, 12).toImage();
    return icon.isNull() ? QColor() : icon.pixelColor(icon.rect().center());
  }
  QTreeWidget* territories() { return find<QTreeWidget>("territoryTable"); }
  QString firstTerritory() { return territories()->topLevelItemCount() > 0 ? territories()->topLevelItem(0)->text(0) : QString(); }
  bool waitForFirst(const QString& name) {
    return waitFor([&] { return firstTerritory() == name && territories()->isEnabled(); });
  }
  /// Opens the case and estimates left and right.
  void openWithTerritories(const Case& content) {
    emit window->opener().opened(content, nullptr, {});
    ASSERT_TRUE(settle());
    find<QPushButton>("estimateTerritories")->click();
    ASSERT_TRUE(waitForFirst("left"));
  }
  /// With this part of the plan panel in sight.
  void keepPicture(const QString& name, const QString& part) {
    window->resize(1400, 1150);
    click("workspacePlan");
    QTest::qWait(300);  // layouts settle in the event loop
    find<QWidget>("planPanel")->findChild<QScrollArea*>()->ensureWidgetVisible(find<QWidget>(part));
    test::kept(pictureOf(*window), name);
  }
};

TEST_F(PlanShown, AMapOfSegmentsIsReadKeptUndoneAndMissedWhenItsFileChanges) {
  const Case fork = test::forkCase(Vec3(2, 2, 2));
  const ImageGeometry& grid = fork.segmentation->geometry;
  const auto file = std::filesystem::path(folder.filePath("segments.nii.gz").toStdString());
  const auto writeMap = [&](std::uint8_t right) {  // the patient's right and left half of the grid
    std::vector<std::uint8_t> values(grid.voxelCount(), 2);
    for (std::size_t n = 0; n < values.size(); ++n) {
      values[n] = static_cast<int>(n) % grid.size[0] < grid.size[0] / 2 ? right : 2;
    }
    sample::writeNifti(file, grid, values);
  };
  writeMap(7);
  ASSERT_NO_FATAL_FAILURE(openWithTerritories(fork));
  auto* table = territories();
  find<QPushButton>("segmentTerritories")->click();
  auto* dialog = find<QFileDialog>("segmentMapDialog");
  emit dialog->fileSelected(QString::fromStdString(file.string()));
  dialog->close();
  ASSERT_TRUE(waitForFirst("segment 2"));
  EXPECT_EQ(table->topLevelItem(1)->text(0), "segment 7");
  EXPECT_FALSE(find<QCheckBox>("showTerritories")->isEnabled());
  EXPECT_FALSE(find<QWidget>("confirmTerritories")->isVisibleTo(window.get()));
  EXPECT_EQ(document().undoStack().undoText(), "choose map of segments");
  ASSERT_TRUE(document().content().territories.segments);
  EXPECT_EQ(document().content().territories.segments->path, file.string());
  keepPicture("territories_segments", "territoryBox");
  document().flush();
  const auto stored = CaseFile::open(document().path()).load();
  EXPECT_EQ(stored.territories, document().content().territories);

  document().undoStack().undo();
  ASSERT_TRUE(waitForFirst("left"));
  document().undoStack().redo();
  ASSERT_TRUE(waitForFirst("segment 2"));
  document().undoStack().undo();
  ASSERT_TRUE(waitForFirst("left"));
  writeMap(8);
  document().undoStack().redo();
  auto* notes = find<QLabel>("territoryNotes");
  ASSERT_TRUE(waitFor([&] { return notes->text().contains("does not say any more what it said") && table->isEnabled(); }));
  EXPECT_EQ(firstTerritory(), "left") << "proposed, and not another map under the old one's name";
  EXPECT_TRUE(document().content().territories.segments) << "what was chosen is not forgotten";
  window->territories().chooseSegments("/nowhere.nii.gz");
  ASSERT_TRUE(waitFor([&] { return jobs->idle() && table->isEnabled(); }));
  EXPECT_EQ(firstTerritory(), "left") << "a wrong choice leaves what was shown";
}

TEST_F(PlanShown, AMapOfSegmentsOffTheGridIsReadWithConsentOnly) {
  const Case fork = test::forkCase(Vec3(2, 2, 2));
  ImageGeometry shifted = fork.segmentation->geometry;
  shifted.origin += Vec3(0.7, 0, 0);
  const auto file = std::filesystem::path(folder.filePath("shifted.nii.gz").toStdString());
  sample::writeNifti(file, shifted, std::vector<std::uint8_t>(shifted.voxelCount(), 4));
  ASSERT_NO_FATAL_FAILURE(openWithTerritories(fork));
  auto* table = territories();
  const auto question = [&] { return window->findChild<QDialog*>("consentDialog"); };
  QSignalSpy refusals(&window->territories(), &TerritoryEstimator::mapRefused);
  for (const bool accepted : {false, true}) {
    window->territories().chooseSegments(QString::fromStdString(file.string()));
    ASSERT_TRUE(waitFor([&] { return question() != nullptr; }));
    EXPECT_EQ(firstTerritory(), "left") << "nothing is read before the answer";
    if (accepted) {
      question()->findChild<QPushButton*>("consentAccept")->click();
    } else {
      question()->reject();
    }
    ASSERT_TRUE(waitFor([&] { return question() == nullptr && jobs->idle() && table->isEnabled(); }));
    EXPECT_EQ(firstTerritory(), accepted ? "segment 4" : "left");
  }
  EXPECT_EQ(refusals.count(), 2) << "an answer is not asked for again";
  EXPECT_TRUE(document().content().territories.segments);
}

TEST_F(PlanShown, ABranchThatIsPickedWhileAnotherChoiceIsWorkedOnIsAddedToThatOne) {
  emit window->opener().opened(test::forkCase(Vec3(2, 2, 2)), nullptr, {});
  ASSERT_TRUE(settle());
  TerritoryEstimator& estimator = window->territories();
  const auto current = [&] { return jobs->idle() && estimator.state() == TerritoryEstimator::State::Current; };
  estimator.estimate();
  ASSERT_TRUE(waitFor(current));
  const Vec3 left(20, -10, 10);
  const Vec3 right(-10, -10, 10);
  estimator.pick(left);
  estimator.pick(right);  // while the first one is divided
  ASSERT_TRUE(waitFor(current));
  EXPECT_EQ(document().content().territories.marks.size(), 2U);
  document().undoStack().undo();
  EXPECT_EQ(estimator.report(), nullptr) << "the case says something else already";
  estimator.pick(right);
  ASSERT_TRUE(waitFor(current));
  EXPECT_EQ(document().content().territories.marks.size(), 1U) << "what was undone does not come back";
}

TEST_F(PlanShown, ProposedLeftAndRightAreSeenInTheColoursOfTheirRowsBeforeTheyAreConfirmed) {
  emit window->opener().opened(test::forkCase(Vec3(2, 2, 2)), nullptr, {});
  ASSERT_TRUE(settle());
  find<QPushButton>("estimateTerritories")->click();
  auto* table = find<QTreeWidget>("territoryTable");
  ASSERT_TRUE(waitFor([&] { return table->topLevelItemCount() == 2 && table->isEnabled(); }));
  EXPECT_EQ(table->topLevelItem(0)->text(0), "left");
  const QColor left = swatch(0);
  const QColor right = swatch(1);
  ASSERT_NE(left, right);
  EXPECT_TRUE(window->territories().isProposal());
  keepPicture("territories_proposed", "territoryBox");
  EXPECT_GT(pixelsOf(left, true), 100) << "the patient's left is on the picture's right";
  EXPECT_EQ(pixelsOf(left, false), 0);
  EXPECT_GT(pixelsOf(right, false), 100);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_FALSE(find<QPushButton>("confirmTerritories")->isEnabled()) << "nobody confirms what is not seen";
  find<QCheckBox>("showTerritories")->click();
  find<QPushButton>("confirmTerritories")->click();
  ASSERT_TRUE(waitFor([&] { return !window->territories().isProposal() && table->isEnabled(); }));
  EXPECT_GT(pixelsOf(left, true), 100);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_EQ(pixelsOf(left, true), 0);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_GT(pixelsOf(left, true), 100);
  openSmall();
  EXPECT_EQ(pixelsOf(left, true), 0) << "another patient's branches";
}

TEST_F(PlanShown, TheAreaOfTheCutStandsWithTheVolumesAndOneResectionHasNoTable) {
  openSmall();
  document().placePlane({smallCentre(), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  const QString area = areaText(document().assessment().resections.at(0).cutAreaMm2);
  EXPECT_TRUE(find<QLabel>("volumeNote")->text().contains("area of the cut " + area));
  EXPECT_FALSE(find<QTreeWidget>("resectionTable")->isVisibleTo(find<QWidget>("planPanel")));
}

TEST_F(PlanShown, EachOfSeveralResectionsHasItsVolumeAndAreaInThePanelAndTheReport) {
  openSmall();
  document().placePlane({smallCentre() + Vec3(10, 0, 0), Vec3::UnitX()});
  document().edit(AddResection{{.name = {}, .planes = {{smallCentre() - Vec3(20, 0, 0), -Vec3::UnitX()}}}});
  ASSERT_TRUE(settle());
  const std::vector<ResectionVolume>& resections = document().assessment().resections;
  ASSERT_EQ(resections.size(), 2U);
  auto* table = find<QTreeWidget>("resectionTable");
  EXPECT_TRUE(table->isVisibleTo(find<QWidget>("planPanel")));
  ASSERT_EQ(table->topLevelItemCount(), 2);
  const QSignalSpy written(window.get(), &MainWindow::reportWritten);
  window->writeReport(folder.filePath("two.pdf"));
  ASSERT_TRUE(waitFor([&] { return written.count() > 0; }));
  const QString text = test::pdfText(folder.filePath("two.pdf")).simplified().replace(QChar(0xA0), ' ');
  for (int n = 0; n < 2; ++n) {
    const ResectionVolume& resection = resections[static_cast<std::size_t>(n)];
    EXPECT_EQ(table->topLevelItem(n)->text(0).toStdString(), resection.name);
    EXPECT_EQ(table->topLevelItem(n)->text(1), mlText(resection.volumeMl));
    EXPECT_EQ(table->topLevelItem(n)->text(2), areaText(resection.cutAreaMm2));
    const QString line =
        QStringLiteral("%1 %2 %3")
            .arg(QString::fromStdString(resection.name), mlText(resection.volumeMl, 1), areaText(resection.cutAreaMm2));
    EXPECT_TRUE(text.contains(QString(line).replace(QChar(0xA0), ' '))) << line.toStdString() << '\n' << text.toStdString();
  }
  const QString whole = areaText(cutAreaMm2(document().assessment())).replace(QChar(0xA0), ' ');
  EXPECT_TRUE(text.contains("Area of the cut " + whole)) << text.toStdString();
  EXPECT_TRUE(find<QLabel>("volumeNote")->text().replace(QChar(0xA0), ' ').contains("area of the cut " + whole));
  keepPicture("two_resections", "resectionTable");
}

TEST_F(PlanShown, ACrossingSaysWhereItIsAndAClickOrEnterShowsItInTheSlices) {
  openSmall();
  click("workspacePlan");
  document().placePlane({smallCentre() + Vec3(5, 0, 0), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  ASSERT_EQ(document().assessment().vesselsCrossed.size(), 1U);
  const Vec3 at = document().assessment().vesselsCrossed.front().positionMm;
  auto* table = find<QTreeWidget>("vesselTable");
  ASSERT_EQ(table->topLevelItemCount(), 1);
  QTreeWidgetItem* row = table->topLevelItem(0);
  const QString place = "L\u00A0" + numberText(at.x(), 1) + ", P\u00A0" + numberText(at.y(), 1) + ", S\u00A0" + mmText(at.z());
  EXPECT_TRUE(row->toolTip(0).contains(place)) << row->toolTip(0).toStdString();
  EXPECT_TRUE(row->toolTip(1).contains(place)) << row->toolTip(1).toStdString();
  ViewArea& views = window->views();
  ASSERT_GT((views.crosshair() - at).norm(), 1);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(row).center());
  EXPECT_LT((views.crosshair() - at).norm(), 1e-9);
  views.setCrosshair(smallCentre());
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_LT((views.crosshair() - at).norm(), 1e-9);
}

}  // namespace
}  // namespace glisson
