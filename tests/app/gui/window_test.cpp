// The window driven as a person drives it: clicks, keys, drops. Needs a display.

#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSemaphore>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeWidget>
#include <array>

#include "app/gui/compare_window.h"
#include "app/gui/export_panel.h"
#include "app/gui/job_bar.h"
#include "app/gui/label_dialog.h"
#include "app/gui/message_bar.h"
#include "app/gui/plane_placer.h"
#include "app/gui/title_line.h"
#include "app/gui/view_area.h"
#include "cube_file.h"
#include "main_window_test.h"
#include "pdf_text.h"
#include "planning/exchange/package.h"
#include "planning/storage/case_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson {
namespace {

using test::smallCase;
using test::smallCentre;
using test::waitFor;

class WindowTest : public test::MainWindowTest {
 protected:
  /// Qt posts the change to every window: it has arrived when the menu speaks the language.
  void changeLanguage(const QString& code) {
    window->setLanguage(code);
    const QString file = code == "de" ? "&Datei" : "&File";
    ASSERT_TRUE(waitFor([&] { return find<QMenu>("menuFile")->menuAction()->text() == file; }));
    QTest::qWait(50);  // layouts settle in the event loop
  }
  bool writeReport(const QString& path, bool named = false) {
    const QSignalSpy written(window.get(), &MainWindow::reportWritten);
    const QSignalSpy failed(window.get(), &MainWindow::failed);
    window->writeReport(path, named);
    return waitFor([&] { return written.count() + failed.count() > 0; }) && failed.isEmpty();
  }
  /// The package's folder; empty where it failed.
  QString exportPackage() {
    const QSignalSpy exported(&window->exportPanel(), &ExportPanel::exported);
    const QSignalSpy failed(window.get(), &MainWindow::failed);
    window->exportPanel().exportTo(folder.path());
    if (auto* accept = window->findChild<QPushButton*>("deviationAccept")) {
      accept->click();
    }
    EXPECT_TRUE(waitFor([&] { return exported.count() + failed.count() > 0; }));
    EXPECT_TRUE(failed.isEmpty()) << failed.front().front().toString().toStdString();
    return exported.isEmpty() ? QString() : exported.front().front().toString();
  }
  void openSmallWithPlane() {
    openSmall();
    click("workspacePlan");
    click("placePlane");
    ASSERT_TRUE(settle());
    ASSERT_TRUE(document().plane().has_value());
  }
};

TEST_F(WindowTest, TheEmptyWindowOffersTheSamplePatientOneClickAway) {
  EXPECT_TRUE(find<QPushButton>("openSample")->isVisible());
  EXPECT_TRUE(find<QPushButton>("openSample")->isEnabled());
  EXPECT_FALSE(find<QWidget>("structureList")->isVisible());
}

TEST_F(WindowTest, EveryStructureAppearsWithItsVolumeFromVoxels) {
  openSmall();
  auto* tree = find<QTreeWidget>("structureTree");
  ASSERT_EQ(tree->topLevelItemCount(), 3);
  EXPECT_EQ(tree->topLevelItem(0)->text(0), "liver");
  EXPECT_TRUE(tree->topLevelItem(0)->text(1).startsWith("18")) << tree->topLevelItem(0)->text(1).toStdString();
  EXPECT_TRUE(tree->topLevelItem(0)->toolTip(0).contains("PSR")) << tree->topLevelItem(0)->toolTip(0).toStdString();
  EXPECT_EQ(find<QToolButton>("workspaceModel")->text(), "Model\n3 of 3 made");
}

TEST_F(WindowTest, APlanePlacedByTheButtonHalvesTheLiverAndShowsTheNumbers) {
  openSmallWithPlane();
  EXPECT_NEAR(document().assessment().resectedMl / document().assessment().totalMl, 0.5, 0.02);
  EXPECT_TRUE(find<QLabel>("flrShare")->text().contains('%'));
  EXPECT_EQ(find<QTreeWidget>("tumourTable")->topLevelItemCount(), 1);
  EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(WindowTest, AnOriginTypedInMovesThePlaneAndUndoNamesTheStep) {
  openSmallWithPlane();
  auto* field = find<QDoubleSpinBox>("originX");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "-30.5");
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_TRUE(document().plane().has_value());
  EXPECT_EQ(document().plane()->origin.x(), -30.5);
  auto* undo = find<QAction>("actionUndo");
  EXPECT_EQ(undo->text(), "Undo: move plane");
  undo->trigger();
  EXPECT_NE(document().plane()->origin.x(), -30.5);
  EXPECT_EQ(undo->text(), "Undo: place plane");
}

TEST_F(WindowTest, TheKeyOfUndoTakesTheStepBackWhileTheNumberFieldStillHasTheFocus) {
  openSmallWithPlane();
  window->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  const ResectionPlane placed = *document().plane();
  auto* field = find<QDoubleSpinBox>("originX");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "-30.5");
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);  // what is typed and not taken over is the field's to undo
  EXPECT_EQ(*document().plane(), placed);
  EXPECT_EQ(document().undoStack().count(), 1);
  field->selectAll();
  QTest::keyClicks(field, "-30.5");
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_EQ(document().plane()->origin.x(), -30.5);
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(*document().plane(), placed);
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().plane()->origin.x(), -30.5);
}

TEST_F(WindowTest, H6TheCaseThatIsOpenIsNotOpenedOnceMoreReadOnly) {
  openSmallWithPlane();
  const QString path = folder.filePath("mine.glisson");
  document().saveAs(path.toStdString());
  ASSERT_TRUE(waitFor([&] { return document().isClean(); }));
  window->opener().openPaths({path});
  window->opener().openPaths({path});  // as a double click does
  ASSERT_TRUE(settle());
  EXPECT_FALSE(document().isReadOnly());
  EXPECT_TRUE(find<MessageBar>("messageBar")->messages().isEmpty());
  click("placePlane");
  document().flush();
  EXPECT_EQ(CaseFile::open(path.toStdString()).load().plans.front().resections.front().planes.front(), *document().plane());
}

TEST_F(WindowTest, ADoubleClickOnALastCaseOpensItOnceAndForWriting) {
  const QString path = folder.filePath("mine.glisson");
  CaseFile::create(path.toStdString(), smallCase());
  for (int n = 0; n < 3; ++n) {
    window->opener().openPaths({path});
  }
  ASSERT_TRUE(settle());
  EXPECT_TRUE(document().isOpen());
  EXPECT_FALSE(document().isReadOnly());
}

TEST_F(WindowTest, VolumesThatWereCancelledAreStartedAgainByPlacingAPlane) {
  emit window->opener().opened(smallCase(), nullptr, {});
  jobs->cancelAll();
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  ASSERT_FALSE(document().liverCentre().has_value());
  click("workspacePlan");
  auto* place = find<QPushButton>("placePlane");
  ASSERT_TRUE(place->isEnabled());
  click("placePlane");
  ASSERT_TRUE(waitFor([this] { return document().liverCentre().has_value(); }));
  click("placePlane");
  EXPECT_TRUE(document().plane().has_value());
}

TEST_F(WindowTest, ACaseWithoutANameIsListedFirstAndAsNotSaved) {
  CaseFile::create(folder.filePath("named.glisson").toStdString(), smallCase());
  window->opener().openPaths({folder.filePath("named.glisson")});
  ASSERT_TRUE(settle());
  std::filesystem::create_directories(folder.filePath("recovery").toStdString());
  CaseFile::create(folder.filePath("recovery/G-1.glisson").toStdString(), smallCase());
  MainWindow next(*jobs, language, folder.filePath("recovery").toStdString());
  auto* list = next.findChild<QListWidget*>("recentList");
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->count(), 2);
  EXPECT_TRUE(list->item(0)->text().startsWith("Not saved under a name: G-1, last changed "))
      << list->item(0)->text().toStdString();
  EXPECT_TRUE(list->item(1)->text().startsWith("named.glisson"));
}

TEST_F(WindowTest, AWholeNewNormalCanBeTypedFieldByField) {
  openSmallWithPlane();  // its normal is (1, 0, 0): the first field alone would leave no direction
  for (const auto& [name, text] : {std::pair("normalX", "0"), std::pair("normalY", "0"), std::pair("normalZ", "1")}) {
    auto* field = find<QDoubleSpinBox>(name);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
  }
  QTest::keyClick(find<QDoubleSpinBox>("normalZ"), Qt::Key_Return);
  EXPECT_NEAR((document().plane()->normal - Vec3::UnitZ()).norm(), 0, 1e-9);
  EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(WindowTest, ANormalWithoutDirectionIsRefusedAndSaysSo) {
  openSmallWithPlane();
  const Vec3 before = document().plane()->normal;
  auto* field = find<QDoubleSpinBox>("normalX");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "0");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(document().plane()->normal, before);
  EXPECT_EQ(window->messages().messages().size(), 1);
}

TEST_F(WindowTest, StepsAlongTheNormalAndTiltsDoExactlyTheirAmount) {
  openSmallWithPlane();
  const HalfSpace before = *document().plane();
  find<QDoubleSpinBox>("moveStep")->setValue(3);
  click("moveForward");
  EXPECT_NEAR((document().plane()->origin - before.origin).dot(before.normal), 3, 1e-9);
  find<QDoubleSpinBox>("tiltStep")->setValue(10);
  click("tiltLeft");
  EXPECT_NEAR(document().plane()->normal.dot(before.normal), std::cos(10 * 3.14159265358979 / 180), 1e-9);
  click("flipPlane");
  EXPECT_LT(document().plane()->normal.dot(before.normal), 0);
  click("removePlane");
  EXPECT_FALSE(document().plane().has_value());
  EXPECT_FALSE(find<QToolButton>("moveForward")->isEnabled());
}

TEST_F(WindowTest, ADragInTheViewIsOneStepAndTheVolumeFollows) {
  openSmallWithPlane();
  ModelView& view = window->views().modelView();
  const HalfSpace from = *document().plane();
  const double before = document().assessment().resectedMl;
  emit view.planeDragStarted();
  for (int i = 1; i <= 10; ++i) {
    emit view.planeDragged({from.origin + i * from.normal, from.normal});
    EXPECT_LT(document().assessment().resectedMl, before);
  }
  emit view.planeDragFinished({from.origin + 10 * from.normal, from.normal});
  EXPECT_EQ(document().undoStack().count(), 2);
  find<QAction>("actionUndo")->trigger();
  EXPECT_EQ(document().plane()->origin, from.origin);
}

TEST_F(WindowTest, ABentPlaneIsOneStepADragAndFlatAgain) {
  openSmallWithPlane();
  ModelView& view = window->views().modelView();
  const double flat = document().assessment().resectedMl;
  const HalfSpace plane = *document().plane();
  EXPECT_FALSE(find<QPushButton>("flattenPlane")->isEnabled());
  click("bendPlane");
  ASSERT_TRUE(settle());
  ASSERT_TRUE(document().plane()->bend);
  EXPECT_NEAR(document().assessment().resectedMl, flat, 1e-6) << "it begins as the plane";
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: bend plane");
  EXPECT_NEAR((document().plane()->origin - plane.origin).dot(plane.normal), 0, 1e-9);
  // The inner points, dragged to the remnant's side, take more.
  find<QComboBox>("bendMoves")->setCurrentIndex(1);
  emit find<QComboBox>("bendMoves")->activated(1);
  const int steps = document().undoStack().count();
  const Pixel at = view.camera().toPixel(controlPoint(*document().plane(), 5));
  const Pixel towards = view.camera().toPixel(controlPoint(*document().plane(), 5) - 8 * plane.normal);
  const auto post = [&](QEvent::Type type, const Pixel& where, Qt::MouseButton button) {
    const QPointF pixel(where.x(), where.y());
    QMouseEvent event(type, pixel, view.mapToGlobal(pixel), button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  post(QEvent::MouseButtonPress, at, Qt::LeftButton);
  post(QEvent::MouseMove, 0.5 * (at + towards), Qt::NoButton);
  post(QEvent::MouseMove, towards, Qt::NoButton);
  EXPECT_GT(document().assessment().resectedMl, flat) << "the numbers follow the drag";
  post(QEvent::MouseButtonRelease, towards, Qt::LeftButton);
  ASSERT_TRUE(settle());
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: bend plane");
  const Bend bent = *document().plane()->bend;
  const QString report = folder.filePath("bent.pdf");
  ASSERT_TRUE(writeReport(report));
  const QString text = test::pdfText(report).simplified();
  EXPECT_TRUE(text.contains("v = normal x u along")) << text.toStdString();
  EXPECT_TRUE(text.contains("u running fastest")) << text.toStdString();
  click("moveForward");
  EXPECT_EQ(document().plane()->bend, bent) << "a moved plane keeps its bend";
  click("flipPlane");
  EXPECT_NEAR(document().assessment().remnantMl + document().assessment().resectedMl, document().assessment().totalMl, 1e-9);
  ASSERT_TRUE(document().plane()->bend);
  click("flattenPlane");
  EXPECT_FALSE(document().plane()->bend);
  EXPECT_FALSE(find<QPushButton>("bendPlane")->isChecked());
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: flatten plane");
  find<QAction>("actionUndo")->trigger();
  EXPECT_TRUE(document().plane()->bend);
  click("placePlane");
  EXPECT_FALSE(document().plane()->bend) << "placed anew it is flat";
}

TEST_F(WindowTest, AControlPointsHeightIsTypedInOneStep) {
  openSmallWithPlane();
  auto* point = find<QSpinBox>("controlPoint");
  auto* height = find<QDoubleSpinBox>("controlHeight");
  EXPECT_FALSE(height->isEnabled()) << "the plane is flat";
  click("bendPlane");
  ASSERT_TRUE(settle());
  ASSERT_TRUE(height->isEnabled());
  const int steps = document().undoStack().count();
  point->setValue(6);
  height->setValue(-7.5);
  emit height->editingFinished();
  std::array<double, 16> heights{};
  heights[5] = -7.5;
  EXPECT_EQ(document().plane()->bend->heightsMm, heights);
  EXPECT_EQ(document().undoStack().count(), steps + 1);
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: bend plane");
  emit height->editingFinished();
  EXPECT_EQ(document().undoStack().count(), steps + 1) << "nothing was typed";
  point->setValue(1);
  EXPECT_EQ(height->value(), 0);
  emit window->views().modelView().controlPointChosen(5);
  EXPECT_EQ(point->value(), 6) << "a click on it chooses it";
  EXPECT_EQ(height->value(), -7.5);
  // With its group: the four inner points go along.
  find<QComboBox>("bendMoves")->setCurrentIndex(1);
  emit find<QComboBox>("bendMoves")->activated(1);
  height->setValue(-5);
  emit height->editingFinished();
  for (const std::size_t inner : {6U, 9U, 10U}) {
    heights[inner] = 2.5;
  }
  heights[5] = -5;
  EXPECT_EQ(document().plane()->bend->heightsMm, heights);
  find<QAction>("actionUndo")->trigger();
  EXPECT_EQ(height->value(), -7.5);
}

TEST_F(WindowTest, TheCheckboxHidesAStructureInTheModel) {
  openSmall();
  auto* tree = find<QTreeWidget>("structureTree");
  tree->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  int hidden = 0;
  for (const Structure& structure : document().content().model->structures) {
    hidden += structure.visible ? 0 : 1;
  }
  EXPECT_EQ(hidden, 1);
}

TEST_F(WindowTest, AStructureIsAcceptedByAPersonWhoIsAskedForTheNameOnce) {
  QSettings().remove("reviewer");
  openSmallWithPlane();
  auto* tree = find<QTreeWidget>("structureTree");
  EXPECT_TRUE(tree->topLevelItem(2)->text(2).isEmpty());
  EXPECT_TRUE(find<QLabel>("exportNotAccepted")->text().contains("liver, tumour 1, portal vein"));
  tree->setCurrentItem(tree->topLevelItem(2));
  click("acceptButton");
  auto* dialog = find<QInputDialog>("reviewerDialog");
  dialog->setTextValue("  Dr. A  ");
  dialog->accept();
  EXPECT_EQ(tree->topLevelItem(2)->text(2), "\u2713");
  EXPECT_TRUE(tree->topLevelItem(2)->toolTip(2).startsWith("Accepted by Dr. A, 20"))
      << tree->topLevelItem(2)->toolTip(2).toStdString();
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: accept portal vein");
  EXPECT_EQ(find<QPushButton>("acceptButton")->text(), "Withdraw acceptance");
  EXPECT_TRUE(find<QLabel>("exportNotAccepted")->text().endsWith("liver, tumour 1"));
  tree->setCurrentItem(tree->topLevelItem(1));
  click("acceptButton");
  EXPECT_EQ(document().content().model->find("tumour_01")->acceptance->by, "Dr. A") << "the name is remembered";
  const QString report = folder.filePath("report.pdf");
  ASSERT_TRUE(settle());
  ASSERT_TRUE(writeReport(report));
  const QString text = test::pdfText(report).simplified();
  EXPECT_TRUE(text.contains("Not accepted by anybody: liver.")) << text.toStdString();
  EXPECT_EQ(text.count("Dr. A, 20"), 2) << text.toStdString();
  find<QAction>("actionAcceptAll")->trigger();
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: accept liver");
  EXPECT_FALSE(find<QLabel>("exportNotAccepted")->isVisibleTo(find<QWidget>("exportPanel")));
  click("acceptButton");
  EXPECT_FALSE(document().content().model->find("tumour_01")->acceptance);
  changeLanguage("de");
  EXPECT_EQ(find<QAction>("actionUndo")->text(), QString("Rückgängig: Freigabe zurücknehmen: Tumor 1"));
  changeLanguage("en");
}

TEST_F(WindowTest, ARunningJobShowsItselfAndItsCancelIsObeyedAtOnce) {
  QSemaphore mayEnd;
  jobs->submit({.title = "Long work", .process = [&](const ExecutionContext&) { mayEnd.acquire(); }});
  auto* bar = find<JobBar>("jobBar");
  const int idleHeight = bar->minimumHeight();
  ASSERT_TRUE(waitFor([&] { return bar->shownJobs() == 1; }));
  EXPECT_LE(bar->sizeHint().height(), idleHeight) << "the views change their size with every job";
  click("cancelJob");
  EXPECT_EQ(bar->shownJobs(), 0);
  mayEnd.release();
  EXPECT_TRUE(waitFor([&] { return jobs->idle(); }));
}

TEST_F(WindowTest, AJobThatWaitsHasARowAndACancelOfItsOwn) {
  QSemaphore mayEnd;
  QStringList done;
  for (const QString& title : {QString("First"), QString("Second"), QString("Third"), QString("Fourth")}) {
    jobs->submit({.title = title,
                  .heavy = true,
                  .process = [&](const ExecutionContext&) { mayEnd.acquire(); },
                  .finish = [&done, title] { done << title; }});
  }
  auto* bar = find<JobBar>("jobBar");
  EXPECT_EQ(bar->shownJobs(), 4);
  EXPECT_EQ(find<QToolButton>("waitingJobs")->text(), "2 waiting");
  EXPECT_EQ(bar->findChildren<QPushButton*>("cancelJob").size(), 4);
  click("waitingJobs");
  auto* list = find<QFrame>("waitingList");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(list));
  const QList<QPushButton*> cancels = list->findChildren<QPushButton*>("cancelJob");
  ASSERT_EQ(cancels.size(), 2);
  EXPECT_EQ(list->findChildren<QProgressBar*>().size(), 2);
  QTest::mouseClick(cancels.front(), Qt::LeftButton);
  EXPECT_EQ(bar->shownJobs(), 3);
  EXPECT_EQ(find<QToolButton>("waitingJobs")->text(), "1 waiting");
  list->close();
  mayEnd.release(4);
  ASSERT_TRUE(waitFor([&] { return jobs->idle(); }));
  done.sort();
  EXPECT_EQ(done, QStringList({"First", "Fourth", "Second"})) << "only the third was cancelled";
  EXPECT_FALSE(find<QToolButton>("waitingJobs")->isVisible());
}

TEST_F(WindowTest, CancelledStructuresAreMissingAndOneClickMakesThem) {
  emit window->opener().opened(smallCase(), nullptr, {});
  jobs->cancelAll();
  ASSERT_TRUE(waitFor([&] { return jobs->idle(); }));
  EXPECT_EQ(window->builder().missing(), 3);
  click("workspaceModel");
  EXPECT_TRUE(find<QPushButton>("reconstructModel")->isEnabled());
  click("reconstructModel");
  ASSERT_TRUE(waitFor([&] { return jobs->idle(); }));
  EXPECT_EQ(window->builder().missing(), 0);
}

TEST_F(WindowTest, AnErrorStaysUntilItIsRead) {
  window->opener().openPaths({folder.filePath("nothing.nii")});
  ASSERT_TRUE(waitFor([&] { return find<QWidget>("messageBar")->isVisible(); }));
  EXPECT_TRUE(find<QLabel>("messageText")->text().contains("nothing.nii"));
  click("messageDismiss");
  EXPECT_FALSE(find<QWidget>("messageBar")->isVisible());
}

TEST_F(WindowTest, ACaseThatIsDroppedOpensWithItsPlan) {
  openSmallWithPlane();
  const Vec3 origin = document().plane()->origin;
  const QString path = folder.filePath("dropped case.glisson");
  document().saveAs(path.toStdString());
  ASSERT_TRUE(waitFor([&] { return document().isClean(); }));
  document().close();
  EXPECT_TRUE(find<QPushButton>("openSample")->isVisible());
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &drop);
  ASSERT_TRUE(waitFor([&] { return document().isOpen(); }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(document().plane()->origin, origin);
  EXPECT_EQ(window->builder().missing(), 0);
  EXPECT_TRUE(document().isClean());
}

TEST_F(WindowTest, H2ACtThatIsNotToBeShownIsNotRead) {
  Case replaced = smallCase();
  replaced.ct.reset();
  replaced.ctSource = kSampleSource;
  const QString why = "The CT at ct.nii is not the one this case was made from.";
  emit window->opener().opened(replaced, nullptr, {}, why);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(document().content().ct);
  EXPECT_EQ(document().noCt(), why);
  EXPECT_EQ(document().content().ctSource, kSampleSource);
}

TEST_F(WindowTest, ACopyWithTheCtSaysItsSizeBeforeItAsksForTheFile) {
  EXPECT_FALSE(find<QAction>("actionSaveCopyWithCt")->isEnabled());
  openSmall();
  find<QAction>("actionSaveCopyWithCt")->trigger();
  auto* box = find<QMessageBox>("embedDialog");
  EXPECT_TRUE(box->text().contains("56 x 48 x 40 voxels")) << box->text().toStdString();
  EXPECT_TRUE(box->text().contains(" MB")) << box->text().toStdString();
  EXPECT_TRUE(box->informativeText().contains("birth date"));
  click("embedAccept");
  auto* dialog = find<QFileDialog>("saveCopyDialog");
  dialog->reject();
  QSignalSpy saved(&document(), &Document::copySaved);
  document().saveCopyWithCt(folder.filePath("copy.glisson").toStdString());
  ASSERT_TRUE(waitFor([&] { return saved.count() == 1; }));
  EXPECT_TRUE(CaseFile::open(folder.filePath("copy.glisson").toStdString()).hasEmbeddedCt());
}

TEST_F(WindowTest, ACtThatIsOpenedAloneAsksForItsSegmentation) {
  const QString ct = folder.filePath("ct.nrrd");
  const QString labels = folder.filePath("labels.seg.nrrd");
  test::writeCube<std::int16_t>(ct.toStdString(), 100, -50);
  test::writeCube<std::uint8_t>(labels.toStdString(), 1, 0,
                                "Segment0_ID:=a\nSegment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n");
  window->opener().openPaths({ct});
  ASSERT_TRUE(waitFor([&] { return window->findChild<QMessageBox*>("segmentationDialog") != nullptr; }));
  EXPECT_EQ(find<QMessageBox>("segmentationDialog")->informativeText(), ct);
  click("segmentationFile");
  auto* dialog = find<QFileDialog>("segmentationChoice");
  emit dialog->fileSelected(labels);
  dialog->reject();
  ASSERT_TRUE(waitFor([&] { return document().isOpen(); }));
  ASSERT_TRUE(settle());
  EXPECT_TRUE(document().content().ct);
  EXPECT_EQ(document().content().model->structures.size(), 1U);
}

TEST_F(WindowTest, TheViewsOfAReportKeepTheirAspect) {
  openSmallWithPlane();
  const QString report = folder.filePath("report.pdf");
  ASSERT_TRUE(writeReport(report));
  const QStringList rows = test::outputOf("pdfimages", {"-list", report}).split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(rows.size(), 2 + 3);
  for (const QString& row : rows.mid(2)) {
    const QStringList cells = row.simplified().split(' ');
    EXPECT_NEAR(cells[12].toInt(), cells[13].toInt(), 5) << "pixels per inch: " << row.toStdString();
  }
}

TEST_F(WindowTest, AReportSaysEveryConsentAndHandsNoNameOn_H8) {
  Case doubtful = smallCase();
  doubtful.notes = {"Resampled to a regular grid with consent: the gantry was tilted by 4.0 degrees.",
                    "Left out: series 4, head of Small."};
  doubtful.plans.front().name = "Small, plan A";
  emit window->opener().opened(doubtful, nullptr, {});
  ASSERT_TRUE(settle());
  for (const bool named : {false, true}) {
    const QString report = folder.filePath("report.pdf");
    ASSERT_TRUE(writeReport(report, named));
    const QString text = test::pdfText(report).simplified();
    EXPECT_TRUE(text.contains("Resampled to a regular grid with consent")) << text.toStdString();
    EXPECT_EQ(text.contains("Small"), named) << text.toStdString();
  }
}

TEST_F(WindowTest, AReportThatNamesThePatientIsOfferedOnlyWhereTheCaseKnowsOne_H8) {
  EXPECT_FALSE(find<QAction>("actionReportIdentity")->isEnabled());
  openSmallWithPlane();
  EXPECT_TRUE(find<QAction>("actionReportIdentity")->isEnabled());
  for (const bool named : {false, true}) {
    const QString report = folder.filePath("report.pdf");
    ASSERT_TRUE(writeReport(report, named));
    const QString text = test::pdfText(report).simplified();
    for (const char* part : {"Small, Patient", "id SP-17", "born 1961-02-03"}) {
      EXPECT_EQ(text.contains(part), named) << part << text.toStdString();
    }
  }
  Case nameless = smallCase();
  nameless.identity = {};
  emit window->opener().opened(nameless, nullptr, {});
  ASSERT_TRUE(settle());
  EXPECT_FALSE(find<QAction>("actionReportIdentity")->isEnabled());
  EXPECT_THROW(window->writeReport(folder.filePath("none.pdf"), true), PlanningError);
  EXPECT_FALSE(QFile::exists(folder.filePath("none.pdf")));
}

TEST_F(WindowTest, ThePackageIsExportedAndSound) {
  openSmallWithPlane();
  click("workspaceExport");
  EXPECT_TRUE(find<QPushButton>("exportPackage")->isEnabled());
  const QString package = exportPackage();
  ASSERT_FALSE(package.isEmpty());
  const std::vector<std::string> problems = verifyPackage(package.toStdString());
  EXPECT_TRUE(problems.empty()) << problems.front();
  EXPECT_EQ(find<QToolButton>("workspaceExport")->text(), "Export\nexported");
  window->placer().moveBy(1);
  EXPECT_EQ(find<QToolButton>("workspaceExport")->text(), "Export\nout of date") << "H5";
}

TEST_F(WindowTest, H7ThePackageIsOfThePlanWorkedOn) {
  openSmallWithPlane();
  document().duplicatePlan();
  ASSERT_TRUE(settle());
  window->placer().moveBy(5);
  ASSERT_TRUE(settle());
  const Vec3 origin = document().plane()->origin;
  click("workspaceExport");
  EXPECT_TRUE(find<QLabel>("exportPlan")->text().contains("Plan 1 copy")) << find<QLabel>("exportPlan")->text().toStdString();
  const QString package = exportPackage();
  ASSERT_FALSE(package.isEmpty());
  QFile file(package + "/plan.json");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QJsonArray written = QJsonDocument::fromJson(file.readAll())["resections"][0]["planes"][0]["originMm"].toArray();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(written[axis].toDouble(), origin[axis]);
  }
}

TEST_F(WindowTest, TheTitleLineNamesThePatientAndTheSwitchHidesThePerson_H2_H8) {
  openSmall();
  const QString code = QString::fromStdString(document().content().code);
  for (const char* text : {"Small, Patient", "SP-17", "1961-02-03", "2024-05-06"}) {
    EXPECT_TRUE(window->titleLine().text().contains(text)) << window->titleLine().text().toStdString();
  }
  click("hideIdentity");
  for (const char* text : {"Small", "SP-17", "1961", "2024"}) {
    EXPECT_FALSE(window->titleLine().text().contains(text)) << window->titleLine().text().toStdString();
  }
  EXPECT_TRUE(window->titleLine().text().contains(code));
}

TEST_F(WindowTest, TheLanguageChangesAtRunTimeWithItsNumbers) {
  openSmallWithPlane();
  changeLanguage("de");
  EXPECT_EQ(find<QPushButton>("placePlane")->text(), QString("Ebene auf die Leber setzen"));
  EXPECT_EQ(find<QAction>("actionUndo")->text(), QString("Rückgängig: Ebene setzen"));
  EXPECT_TRUE(find<QTreeWidget>("structureTree")->topLevelItem(0)->text(1).contains(','));
  EXPECT_TRUE(find<QDoubleSpinBox>("originX")->text().contains(','));
  changeLanguage("en");
  EXPECT_EQ(find<QPushButton>("placePlane")->text(), "Place plane on the liver");
  EXPECT_TRUE(find<QDoubleSpinBox>("originX")->text().contains('.'));
}

TEST_F(WindowTest, NothingIsCutOffInTheSmallestWindowInAnyLanguage) {
  openSmallWithPlane();
  for (const char* code : {"en", "de"}) {
    changeLanguage(code);
    for (const char* workspace : {"workspaceCase", "workspaceModel", "workspacePlan", "workspaceExport"}) {
      click(workspace);
      QTest::qWait(50);  // layouts settle in the event loop
      EXPECT_LE(window->width(), 1024);
      EXPECT_LE(window->height(), 700);
      for (QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
        if (button->isVisible() && !button->text().isEmpty()) {
          EXPECT_GE(button->width(), button->minimumSizeHint().width()) << code << ' ' << button->text().toStdString();
        }
      }
      for (QLabel* label : window->findChildren<QLabel*>()) {
        const bool elidable = label->objectName() == "jobNews";
        if (label->isVisible() && !label->wordWrap() && !elidable && !label->text().isEmpty()) {
          EXPECT_GE(label->width(), label->sizeHint().width()) << code << ' ' << label->text().toStdString();
        }
      }
    }
  }
}

TEST_F(WindowTest, ALongTumourNameThatIsCutPushesNoNumberOutOfThePanel) {
  Case content = smallCase();
  auto renamed = std::make_shared<Segmentation>(*content.segmentation);
  renamed->structures[1].name = "livertumor01_segment_VIII of the second phase";
  emit window->opener().opened(newCase(content.ct, renamed), nullptr, {});
  ASSERT_TRUE(settle());
  changeLanguage("de");
  click("workspacePlan");
  document().placePlane({smallCentre() + Vec3(20, 0, 0), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  QTest::qWait(50);  // layouts settle in the event loop
  EXPECT_EQ(document().assessment().tumours.front().state, TumourState::Cut);
  const auto* panel = find<QWidget>("planPanel");
  for (const char* name : {"flrShare", "resectedShare", "marginShare", "marginReason", "remnantShare"}) {
    const auto* number = find<QLabel>(name);
    EXPECT_LE(number->mapTo(panel, QPoint(number->width(), 0)).x(), panel->width()) << name;
  }
}

TEST_F(WindowTest, NoControlIsGreyWithoutAReason) {
  // a reason, not what the control would do: greyed and usable, the same control says different things
  std::map<const QWidget*, QString> whileGrey;
  const auto check = [&] {
    for (QWidget* control : window->findChildren<QWidget*>()) {
      const bool acts = qobject_cast<QAbstractButton*>(control) != nullptr || qobject_cast<QAbstractSpinBox*>(control) != nullptr ||
                        qobject_cast<QAbstractSlider*>(control) != nullptr || qobject_cast<QComboBox*>(control) != nullptr;
      if (!acts || !control->isVisible() || qobject_cast<QScrollBar*>(control) != nullptr) {
        continue;
      }
      const std::string name = control->parent()->objectName().toStdString() + '/' + control->objectName().toStdString();
      if (!control->isEnabled()) {
        EXPECT_FALSE(control->toolTip().isEmpty()) << name;
        whileGrey[control] = control->toolTip();
      } else if (whileGrey.contains(control)) {
        EXPECT_NE(control->toolTip(), whileGrey[control]) << name;
      }
    }
  };
  check();
  openSmall();
  for (const char* workspace : {"workspaceCase", "workspaceModel", "workspacePlan", "workspaceExport"}) {
    click(workspace);
    check();
  }
  click("workspacePlan");
  click("placePlane");
  ASSERT_TRUE(settle());
  check();
  EXPECT_GE(whileGrey.size(), 12U) << "the plane's fields, steps and buttons were grey before";
}

TEST_F(WindowTest, UnknownLabelsAreAskedForAndNeverGuessed) {
  LabelledMask label;
  label.name = "label 64";
  LabelDialog dialog({label, label}, test::smallGrid());
  auto* accept = dialog.findChild<QPushButton*>("labelAccept");
  EXPECT_FALSE(accept->isEnabled());
  dialog.findChild<QComboBox*>("labelKind0")->setCurrentIndex(2);
  EXPECT_FALSE(accept->isEnabled());
  dialog.findChild<QComboBox*>("labelKind1")->setCurrentIndex(3);
  EXPECT_TRUE(accept->isEnabled());
  EXPECT_EQ(dialog.chosen(), (std::vector{StructureKind::PortalVein, StructureKind::HepaticVein})) << "both are named label 64";
}

TEST_F(WindowTest, LabelsOfAPublishedTableAreChosenAtOnceAndTheOthersLeftOut) {
  LabelledMask liver;
  liver.name = "label 5";
  liver.label = 5;
  LabelledMask portal;
  portal.name = "label 64";
  portal.label = 64;
  LabelDialog dialog({liver, portal}, test::smallGrid());
  auto* accept = dialog.findChild<QPushButton*>("labelAccept");
  auto* table = dialog.findChild<QComboBox*>("labelTable");
  EXPECT_EQ(dialog.table(), "") << "nothing is guessed";
  table->setCurrentIndex(1);
  EXPECT_TRUE(accept->isEnabled());
  EXPECT_EQ(dialog.table(), "totalsegmentator");
  EXPECT_EQ(dialog.chosen(), (std::vector{StructureKind::Liver, StructureKind::PortalVein}));
  EXPECT_FALSE(dialog.findChild<QComboBox*>("labelKind0")->isEnabled());
  table->setCurrentIndex(0);
  EXPECT_FALSE(accept->isEnabled());
  dialog.findChild<QComboBox*>("labelKind0")->setCurrentIndex(1);
  dialog.findChild<QPushButton*>("labelOthers")->click();
  EXPECT_EQ(dialog.chosen(), (std::vector{StructureKind::Liver, StructureKind::Other}));
  EXPECT_TRUE(accept->isEnabled());
}

TEST_F(WindowTest, ADoubleClickMaximisesAViewAndRestores) {
  openSmall();
  auto* axial = find<SliceView>("axialView");
  const int before = axial->width();
  emit axial->maximiseRequested();
  EXPECT_FALSE(window->views().modelView().isVisible());
  QTest::qWait(20);
  EXPECT_GT(axial->width(), before * 3 / 2);
  emit axial->maximiseRequested();
  EXPECT_TRUE(window->views().modelView().isVisible());
}

TEST_F(WindowTest, APlanIsDuplicatedEditedAndUndoneWithItsOwnNumbers) {
  openSmallWithPlane();
  const double first = document().assessment().resectedMl;
  find<QAction>("actionDuplicatePlan")->trigger();
  ASSERT_TRUE(settle());
  ASSERT_EQ(document().content().plans.size(), 2U);
  EXPECT_EQ(document().chosen().plan, 1U);
  EXPECT_EQ(find<QComboBox>("planChoice")->currentText(), "Plan 1 copy");
  window->placer().moveBy(5);
  ASSERT_TRUE(settle());
  EXPECT_LT(document().assessment().resectedMl, first);
  document().choose({0, 0, 0});
  ASSERT_TRUE(settle());
  EXPECT_EQ(document().assessment().resectedMl, first);
  document().undoStack().undo();  // shows the plan whose plane it moves back
  EXPECT_EQ(document().chosen().plan, 1U);
  ASSERT_TRUE(settle());
  EXPECT_EQ(document().assessment().resectedMl, first);
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: duplicate plan");
}

TEST_F(WindowTest, AWedgeOfTwoPlanesTakesLessThanEachAndBothCanBeChosen) {
  openSmallWithPlane();
  const double half = document().assessment().resectedMl;
  window->views().modelView().setStandardView(ModelView::StandardView::Left);
  find<QAction>("actionAddPlane")->trigger();
  ASSERT_TRUE(settle());
  ASSERT_EQ(document().plan().resections.front().planes.size(), 2U);
  EXPECT_EQ(document().chosen(), (ChosenPlane{0, 0, 1}));
  EXPECT_NEAR(document().assessment().resectedMl, half / 2, 0.1 * half);
  auto* planes = find<QComboBox>("planeChoice");
  ASSERT_EQ(planes->count(), 2);
  EXPECT_EQ(planes->itemText(1), "Resection 1, plane 2");
  EXPECT_EQ(find<QAction>("actionUndo")->text(), "Undo: add plane");
  document().choose({0, 0, 0});
  EXPECT_EQ(document().plane()->normal, document().plan().resections[0].planes[0].normal);
  document().removePlane();
  EXPECT_EQ(document().plan().resections.front().planes.size(), 1U);
}

TEST_F(WindowTest, APlaneIsPlacedAlongASliceThroughTheCrosshair) {
  openSmall();
  window->views().setCrosshair(smallCentre() + Vec3(0, 0, 3));
  find<QAction>("placeAxial")->trigger();
  ASSERT_TRUE(document().plane().has_value());
  EXPECT_NEAR(std::abs(document().plane()->normal.z()), 1, 1e-12);
  EXPECT_NEAR(document().plane()->origin.z(), smallCentre().z() + 3, 1e-9);
}

TEST_F(WindowTest, ALineDrawnUpwardsInTheViewResectsTheRightOfThePicture) {
  openSmall();
  find<QAction>("placeAlongLine")->trigger();
  ModelView& view = window->views().modelView();
  ASSERT_TRUE(view.picking());
  const QPoint middle = view.rect().center();
  QTest::mousePress(&view, Qt::LeftButton, {}, middle + QPoint(0, 80));
  QTest::mouseMove(&view, middle);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, middle - QPoint(0, 80));
  EXPECT_FALSE(view.picking());
  ASSERT_TRUE(document().plane().has_value());
  // from anterior the patient's left is on the picture's right
  EXPECT_GT(document().plane()->normal.x(), 0.99);
  ASSERT_TRUE(settle());
  EXPECT_NEAR(document().assessment().resectedMl / document().assessment().totalMl, 0.5, 0.1);
}

TEST_F(WindowTest, ThreeClicksOnTheModelGiveThePlaneThroughThemAndEscapeGivesUp) {
  openSmall();
  ModelView& view = window->views().modelView();
  find<QAction>("placeThroughPoints")->trigger();
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_FALSE(view.picking());
  EXPECT_FALSE(document().plane().has_value());
  find<QAction>("placeThroughPoints")->trigger();
  const QPoint middle = view.rect().center();
  std::vector<Vec3> points;
  for (const QPoint& at : {middle, middle + QPoint(15, 0), middle + QPoint(0, 15)}) {
    const std::optional<Vec3> point = view.surfaceAt({at.x(), at.y()});
    ASSERT_TRUE(point.has_value());
    points.push_back(*point);
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
  }
  ASSERT_TRUE(document().plane().has_value());
  for (const Vec3& point : points) {
    EXPECT_NEAR(document().plane()->normal.dot(point - document().plane()->origin), 0, 0.2);
  }
}

TEST_F(WindowTest, ADistanceBetweenTwoClicksIsKeptInThePlanRemovedAndUndone) {
  openSmall();
  ModelView& view = window->views().modelView();
  auto* list = find<QTreeWidget>("measureList");
  EXPECT_FALSE(find<QWidget>("removeMeasureButton")->isEnabled());
  find<QPushButton>("measureButton")->click();
  ASSERT_TRUE(view.picking());
  const QPoint middle = view.rect().center();
  std::vector<Vec3> points;
  for (const QPoint& at : {middle, middle + QPoint(20, 10)}) {
    const std::optional<Vec3> point = view.surfaceAt({at.x(), at.y()});
    ASSERT_TRUE(point.has_value());
    points.push_back(*point);
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
  }
  EXPECT_FALSE(view.picking());
  EXPECT_FALSE(document().plane().has_value());  // no plane is placed by it
  ASSERT_EQ(document().plan().measures.size(), 1U);
  EXPECT_NEAR(document().plan().measures.front().mm(), (points[1] - points[0]).norm(), 0.2);
  ASSERT_EQ(list->topLevelItemCount(), 1);
  EXPECT_TRUE(list->topLevelItem(0)->text(1).contains("mm"));
  list->setCurrentItem(list->topLevelItem(0));
  find<QPushButton>("removeMeasureButton")->click();
  EXPECT_TRUE(document().plan().measures.empty());
  document().undoStack().undo();
  EXPECT_EQ(document().plan().measures.size(), 1U);
  EXPECT_EQ(list->topLevelItemCount(), 1);
}

TEST_F(WindowTest, TerritoriesAreEstimatedWhenAskedForFollowThePlanAndTakePickedBranches) {
  openSmall();
  EXPECT_FALSE(find<QWidget>("pickTerritory")->isVisibleTo(window.get()));
  auto* sizes = find<QTreeWidget>("tumourMeasures");
  ASSERT_TRUE(waitFor([&] { return sizes->topLevelItemCount() == 1; }));
  const auto place = [&] { return sizes->topLevelItem(0)->child(2)->text(0); };
  EXPECT_EQ(sizes->topLevelItem(0)->text(0), "tumour 1");
  EXPECT_TRUE(sizes->topLevelItem(0)->child(1)->text(0).startsWith("Nearest vessel: portal vein, ")) << "4.10";
  EXPECT_TRUE(place().startsWith("Territory: not known")) << place().toStdString();
  find<QPushButton>("estimateTerritories")->click();
  auto* table = find<QTreeWidget>("territoryTable");
  auto* text = find<QLabel>("perfusionText");
  ASSERT_TRUE(waitFor([&] { return !text->text().isEmpty() && text->isEnabled(); }));
  EXPECT_EQ(table->topLevelItemCount(), 0);  // one straight vessel does not divide
  EXPECT_FALSE(find<QLabel>("territoryNotes")->text().isEmpty());
  EXPECT_FALSE(find<QWidget>("confirmTerritories")->isVisibleTo(window.get()));

  find<QPushButton>("pickTerritory")->click();
  ModelView& view = window->views().modelView();
  ASSERT_TRUE(view.picking());
  const QPoint middle = view.rect().center();
  QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
  EXPECT_FALSE(document().plane().has_value());  // no plane is placed by it
  ASSERT_TRUE(waitFor([&] { return table->topLevelItemCount() == 1 && table->isEnabled(); }));
  EXPECT_EQ(table->topLevelItem(0)->text(0), "Territory 1");
  EXPECT_TRUE(place().startsWith("Lies in: Territory 1 ")) << place().toStdString();
  EXPECT_TRUE(place().contains("(100")) << place().toStdString();
  const auto number = [](const QString& ml) { return ml.split(' ').front().split(QChar(0xA0)).front().toDouble(); };
  EXPECT_EQ(number(table->topLevelItem(0)->text(2)), 0);
  document().placePlane({smallCentre(), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(waitFor([&] { return number(table->topLevelItem(0)->text(2)) > 0 && table->isEnabled(); }));
  EXPECT_NEAR(number(table->topLevelItem(0)->text(2)), document().assessment().resectedMl, 0.6);
  EXPECT_NEAR(number(table->topLevelItem(0)->text(1)), document().assessment().totalMl, 0.6);
  // while the plane is dragged they are out of date; when it rests they are its own
  document().beginDrag();
  for (int mm = 1; mm <= 9; ++mm) {
    document().dragTo({smallCentre() + Vec3(mm, 0, 0), Vec3::UnitX()});
    EXPECT_FALSE(table->isEnabled());
    EXPECT_FALSE(place().contains("out of date")) << "a plane that moves changes no territory";
  }
  document().endDrag({smallCentre() + Vec3(9, 0, 0), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(waitFor([&] { return table->isEnabled(); }));
  EXPECT_NEAR(number(table->topLevelItem(0)->text(2)), document().assessment().resectedMl, 0.6);
  document().choose(document().chosen());
  EXPECT_TRUE(table->isEnabled());
  ASSERT_EQ(document().content().territories.marks.size(), 1U);
  find<QPushButton>("proposeTerritories")->click();
  ASSERT_TRUE(waitFor([&] { return table->topLevelItemCount() == 0; }));
  EXPECT_TRUE(place().startsWith("Territory: not known")) << place().toStdString();
  EXPECT_TRUE(document().content().territories.marks.empty());
  EXPECT_EQ(document().undoStack().undoText(), "propose territories");
  document().undoStack().undo();
  ASSERT_TRUE(waitFor([&] { return table->topLevelItemCount() == 1 && table->isEnabled(); }));
  EXPECT_EQ(table->topLevelItem(0)->text(0), "Territory 1");
  // a file that is opened again still has them
  document().flush();
  const Case stored = CaseFile::open(document().path()).load();
  EXPECT_EQ(stored.territories, document().content().territories);
}

TEST_F(WindowTest, ASeparatedPieceIsGivenToTheOtherSideAndBack) {
  // two legs on a bar: a plane across both leaves two pieces above it
  const Vec3 c = smallCentre();
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->geometry = test::smallGrid();
  LabelledMask liver;
  liver.name = "liver";
  liver.label = 1;
  liver.kind = StructureKind::Liver;
  liver.mask = std::make_shared<const Mask>(test::maskWhere(segmentation->geometry, [c](const Vec3& p) {
    const Vec3 d = p - c;
    const bool bar = std::abs(d.x()) < 40 && d.z() < -10;
    const bool legs = (d.x() < -20 && d.x() > -40) || (d.x() > 28 && d.x() < 40);
    return std::abs(d.y()) < 15 && std::abs(d.z()) < 30 && (bar || legs);
  }));
  segmentation->structures.push_back(liver);
  emit window->opener().opened(newCase(nullptr, segmentation), nullptr, {});
  window->workspaces().setCurrent(Workspace::Plan);
  auto* list = find<QTreeWidget>("islandList");
  EXPECT_FALSE(find<QWidget>("islandBox")->isVisible());
  document().placePlane({c, Vec3::UnitZ()});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(waitFor([&] { return list->topLevelItemCount() == 1; }));
  EXPECT_TRUE(find<QWidget>("islandBox")->isVisible());
  const double island = document().assessment().islands.front().volumeMl;
  const double resected = document().assessment().resectedMl;
  list->topLevelItem(0)->setCheckState(0, Qt::Checked);
  ASSERT_TRUE(waitFor([&] { return document().plan().islands.size() == 1U; }));
  ASSERT_TRUE(settle());
  EXPECT_NEAR(document().assessment().resectedMl, resected - island, 1e-9);
  EXPECT_EQ(list->topLevelItem(0)->checkState(0), Qt::Checked);
  list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  ASSERT_TRUE(waitFor([&] { return document().plan().islands.empty(); }));
  ASSERT_TRUE(settle());
  EXPECT_NEAR(document().assessment().resectedMl, resected, 1e-9);
  EXPECT_TRUE(document().plan().islands.empty());
}

TEST_F(WindowTest, TheWheelScrollsThePlanPanelAndChangesNoNumber) {
  openSmall();
  document().placePlane({smallCentre(), Vec3::UnitX()});
  ASSERT_TRUE(settle());
  find<QWidget>("modelView")->setFocus();
  const double margin = document().plan().safetyMarginMm;
  const int steps = document().undoStack().count();
  for (QWidget* field : find<QWidget>("planPanel")->findChildren<QWidget*>()) {
    if (qobject_cast<QAbstractSpinBox*>(field) == nullptr && qobject_cast<QComboBox*>(field) == nullptr) {
      continue;
    }
    const QPointF at = field->rect().center();
    QWheelEvent wheel(at, field->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(field, &wheel);
  }
  EXPECT_EQ(document().plan().safetyMarginMm, margin);
  EXPECT_EQ(document().undoStack().count(), steps);
}

TEST_F(WindowTest, ThePlanPanelCutsNoTextOff) {
  openSmall();
  window->workspaces().setCurrent(Workspace::Plan);
  QTest::qWait(50);
  ASSERT_TRUE(find<QWidget>("planPanel")->isVisible());
  const auto* inside = find<QWidget>("planeEditor")->parentWidget();
  EXPECT_LE(inside->minimumSizeHint().width(), inside->width()) << "nothing is wider than the panel";
  for (const QLabel* label : find<QWidget>("planPanel")->findChildren<QLabel*>()) {
    if (label->isVisible() && label->wordWrap() && !label->text().isEmpty()) {
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
    }
  }
}

TEST_F(WindowTest, ThePlaneAroundATumourKeepsTheMarginAndSaysWhatItIgnores) {
  openSmall();
  find<QDoubleSpinBox>("safetyMargin")->setValue(3);
  EXPECT_EQ(document().plan().safetyMarginMm, 3);
  auto* tumours = find<QMenu>("placeAroundTumour");
  ASSERT_EQ(tumours->actions().size(), 1);
  tumours->actions().front()->trigger();
  ASSERT_TRUE(waitFor([&] { return document().plane().has_value(); }));
  ASSERT_TRUE(settle());
  ASSERT_EQ(document().assessment().tumours.size(), 1U);
  EXPECT_EQ(document().assessment().tumours.front().state, TumourState::Removed);
  EXPECT_GE(document().assessment().tumours.front().marginAtLeastMm.value(), 3.0);
  ASSERT_FALSE(window->messages().messages().isEmpty());
  EXPECT_NE(window->messages().messages().last().indexOf("ignores inflow"), -1);
}

TEST_F(WindowTest, TheFlrCardShowsAThresholdOnlyWithAllFactsAndUndoTakesThemBack) {
  openSmallWithPlane();
  auto* text = find<QLabel>("flrCardText");
  EXPECT_FALSE(text->text().contains("Kishi"));
  find<QDoubleSpinBox>("patientHeight")->setValue(175);
  find<QDoubleSpinBox>("patientWeight")->setValue(75);
  EXPECT_FALSE(text->text().contains("Kishi"));
  auto* condition = find<QComboBox>("liverCondition");
  condition->setCurrentIndex(1);
  emit condition->activated(1);
  EXPECT_TRUE(text->text().contains("Kishi 2009: 20"));
  EXPECT_EQ(document().content().patient.heightCm, 175);
  document().undoStack().undo();
  EXPECT_FALSE(text->text().contains("Kishi"));
  EXPECT_EQ(condition->currentIndex(), 0);
  document().flush();
  EXPECT_EQ(CaseFile::open(document().path()).load().patient.weightKg, 75);
}

TEST_F(WindowTest, TwoPlansStandSideBySideWithLinkedCamerasAndMarkedValues) {
  openSmallWithPlane();
  EXPECT_FALSE(find<QAction>("actionComparePlans")->isEnabled());
  find<QAction>("actionDuplicatePlan")->trigger();
  window->placer().moveBy(5);
  ASSERT_TRUE(settle());
  find<QAction>("actionComparePlans")->trigger();
  auto* compare = find<CompareWindow>("compareWindow");
  auto* table = find<QTreeWidget>("comparedTable");
  ASSERT_TRUE(waitFor([&] { return table->isEnabled() && table->topLevelItemCount() > 0; }));
  const QList<QTreeWidgetItem*> resected = table->findItems("Resected", Qt::MatchExactly);
  ASSERT_EQ(resected.size(), 1);
  EXPECT_TRUE(resected.front()->text(1).contains("largest"));
  EXPECT_TRUE(resected.front()->text(2).contains("smallest"));
  EXPECT_TRUE(find<QLabel>("comparedDifferences")->text().contains("5.0 mm from where it was placed"));
  ASSERT_EQ(compare->views().size(), 2U);
  compare->views()[0]->setStandardView(ModelView::StandardView::Left);
  EXPECT_TRUE(waitFor([&] { return compare->views()[1]->viewDirection().x() < -0.99; }));
  compare->close();
}

TEST_F(WindowTest, AComparisonThatIsBeingClosedBearsAnotherLanguageAndACaseWithFewerPlans) {
  openSmallWithPlane();
  find<QAction>("actionDuplicatePlan")->trigger();
  ASSERT_TRUE(settle());
  find<QAction>("actionComparePlans")->trigger();
  const QPointer<CompareWindow> compare = find<CompareWindow>("compareWindow");
  compare->close();
  document().undoStack().undo();
  ASSERT_EQ(document().content().plans.size(), 1U);
  ASSERT_NE(compare, nullptr);  // deleted by the next turn of the event loop
  window->setLanguage("de");
  QEvent change(QEvent::LanguageChange);
  QCoreApplication::sendEvent(compare, &change);
  EXPECT_FALSE(compare->isVisible());
}

}  // namespace
}  // namespace glisson
