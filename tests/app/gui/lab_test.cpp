// The Compare workspace driven as a person drives it. Needs a display.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QXmlStreamReader>
#include <set>

#include "app/gui/error_legend.h"
#include "app/gui/lab_experiment.h"
#include "app/gui/lab_plot.h"
#include "app/gui/lab_side.h"
#include "app/gui/lab_views.h"
#include "app/gui/lab_workspace.h"
#include "app/gui/rating_window.h"
#include "main_window_test.h"
#include "planning/case/structure_mask.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/models_csv.h"

namespace glisson {
namespace {

using test::smallCase;
using test::waitFor;

class LabTest : public test::MainWindowTest {
 protected:
  void SetUp() override {
    MainWindowTest::SetUp();
    openSmall();
    click("workspaceCompare");
  }
  LabWorkspace& lab() { return window->lab(); }
  LabExperiment& experiment() { return lab().experiment(); }
  const Evaluation& evaluation() { return experiment().evaluation(); }

  /// Makes the models of these families and waits for them.
  void compare(const std::set<ModelFamily>& families) {
    for (const ModelFamily family : {ModelFamily::Psr, ModelFamily::Mcsd, ModelFamily::SimplifiedPsr, ModelFamily::Other}) {
      find<QCheckBox>("labFamily_" + QString::fromStdString(std::string(familyId(family))))->setChecked(families.contains(family));
    }
    click("labCompare");
    ASSERT_TRUE(waitFor([this] { return jobs->idle() && !experiment().running(); }, 120000));
  }
  std::size_t placeOf(const ModelRecipe& recipe) {
    const auto place = experiment().placeOf(recipe);
    EXPECT_TRUE(place.has_value()) << modelName(recipe);
    return place.value_or(0);
  }
  void clickModel(const ModelRecipe& recipe, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {}) {
    const auto at = lab().plot().pixelOf(placeOf(recipe));
    ASSERT_TRUE(at.has_value()) << modelName(recipe);
    QTest::mouseClick(&lab().plot(), button, modifiers, at->toPoint());
    ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  }
};

/// Depth 6 is the deepest that the small liver carries.
const ModelRecipe kDepth5{.family = ModelFamily::Psr, .depth = 5};
const ModelRecipe kDepth6{.family = ModelFamily::Psr, .depth = 6};
const ModelRecipe kDepth8{.family = ModelFamily::Psr, .depth = 8};

TEST_F(LabTest, OpensFromTheLineAndSaysWhatCanBeDone) {
  EXPECT_TRUE(lab().isVisible());
  EXPECT_FALSE(find<QWidget>("structureList")->isVisible());
  EXPECT_TRUE(find<QPushButton>("labCompare")->isEnabled());
  for (const char* name : {"labCancel", "labCsv", "labPng", "labSvg"}) {
    EXPECT_FALSE(find<QWidget>(name)->isEnabled()) << name;
    EXPECT_FALSE(find<QWidget>(name)->toolTip().isEmpty()) << name;
  }
  EXPECT_EQ(find<QComboBox>("labStructure")->count(), 3);
  click("workspacePlan");
  EXPECT_FALSE(lab().isVisible());
  EXPECT_TRUE(find<QWidget>("structureList")->isVisible());
}

TEST_F(LabTest, ModelsOfTheChosenFamiliesArriveAndOneThatFailsStopsNoOther) {
  compare({ModelFamily::Psr});
  ASSERT_EQ(evaluation().models.size(), 4U);
  EXPECT_EQ(evaluation().failed(), 2U) << "the label carries no depth 7 and 8";
  EXPECT_TRUE(lab().plot().pixelOf(placeOf(kDepth5)).has_value());
  EXPECT_FALSE(lab().plot().pixelOf(placeOf(kDepth8)).has_value());
  const QAbstractItemModel* table = find<QTableView>("labTableView")->model();
  ASSERT_EQ(table->rowCount(), 4);
  const QString failure = table->index(3, table->columnCount() - 1).data().toString();
  EXPECT_TRUE(failure.startsWith("The label is too small for depth 8")) << failure.toStdString();
  EXPECT_FALSE(find<QPushButton>("labCompare")->isEnabled()) << "every model of PSR is there";
  EXPECT_FALSE(find<QPushButton>("labCompare")->toolTip().isEmpty());

  const double seconds = evaluation().models[placeOf(kDepth6)].seconds.total();
  compare({ModelFamily::Psr, ModelFamily::SimplifiedPsr});
  EXPECT_EQ(evaluation().models.size(), 8U);
  EXPECT_EQ(evaluation().models[placeOf(kDepth6)].seconds.total(), seconds) << "what is there is not made again";
}

TEST_F(LabTest, EveryFamilyTogetherIsTheExperimentOfTheCommandLineAndOnlyThenScored) {
  const auto score = [this](int row) {
    const QAbstractItemModel* table = find<QTableView>("labTableView")->model();
    return table->index(row, table->columnCount() - 2).data().toString();
  };
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  EXPECT_EQ(score(0), "-");
  EXPECT_TRUE(find<QLabel>("labNumbersA")->text().contains("Score\u00A0<b>-</b>"));
  EXPECT_EQ(lab().plot().frontName(), "front so far");
  compare({ModelFamily::Psr, ModelFamily::Mcsd, ModelFamily::SimplifiedPsr, ModelFamily::Other});
  ASSERT_EQ(evaluation().models.size(), allRecipes().size());
  const std::vector<ModelRecipe> order = allRecipes();
  for (std::size_t n = 0; n < order.size(); ++n) {
    EXPECT_EQ(evaluation().models[n].recipe, order[n]);
  }
  EXPECT_TRUE(evaluation().bestPsr && evaluation().bestMcsd && evaluation().mostSimilar);
  EXPECT_NE(score(0), "-");
  EXPECT_FALSE(find<QLabel>("labNumbersA")->text().contains("Score\u00A0<b>-</b>"));
  EXPECT_EQ(lab().plot().frontName(), "front");
}

TEST_F(LabTest, AClickShowsTheModelThatWasMeasured) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  clickModel(kDepth6, Qt::LeftButton, Qt::ShiftModifier);
  for (const auto& [side, recipe] : {std::pair<std::size_t, ModelRecipe>(0, kDepth5), {1, kDepth6}}) {
    ASSERT_EQ(lab().side(side).recipe(), recipe);
    ASSERT_NE(lab().side(side).surface().mesh, nullptr);
    ASSERT_NE(lab().side(side).surface().errors, nullptr);
    const ModelMeasures& measured = *evaluation().models[placeOf(recipe)].measures;
    EXPECT_EQ(lab().side(side).reconstruction()->mesh.triangles.size(), measured.triangles);
    EXPECT_EQ(lab().side(side).p95Mm(), measured.meshToVoxelsMm.p95);
  }
  EXPECT_TRUE(find<QLabel>("labNameA")->text().contains("PSR d=5"));
  EXPECT_TRUE(find<QLabel>("labNameB")->text().contains("PSR d=6"));
  EXPECT_TRUE(find<QLabel>("labNumbersA")->text().contains("Triangles"));
  clickModel(kDepth5, Qt::RightButton);
  EXPECT_EQ(lab().side(1).recipe(), kDepth5) << "the right button is for B, too";
  EXPECT_EQ(lab().side(0).recipe(), kDepth5);
}

TEST_F(LabTest, TheLegendEndsAboveTheWorseOfBoth) {
  compare({ModelFamily::Psr});
  clickModel(kDepth6);
  const double alone = find<ErrorLegend>("errorLegend")->scaleMm();
  EXPECT_GE(alone, *lab().side(0).p95Mm());
  clickModel(kDepth5, Qt::RightButton);
  const double both = find<ErrorLegend>("errorLegend")->scaleMm();
  EXPECT_GE(both, *lab().side(1).p95Mm());
  EXPECT_GE(both, alone);
}

TEST_F(LabTest, BothViewsTurnTogether) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  clickModel(kDepth6, Qt::RightButton);
  SurfaceView& a = lab().views().view(0);
  SurfaceView& b = lab().views().view(1);
  ASSERT_EQ(a.pose(), b.pose());
  const Pose before = a.pose();
  const auto mouse = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
    QMouseEvent event(type, at, a.mapToGlobal(at), button, type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&a, &event);
  };
  mouse(QEvent::MouseButtonPress, {100, 60}, Qt::LeftButton);
  mouse(QEvent::MouseMove, {150, 80}, Qt::NoButton);
  mouse(QEvent::MouseButtonRelease, {150, 80}, Qt::LeftButton);
  EXPECT_NE(a.pose(), before);
  EXPECT_EQ(a.pose(), b.pose());
}

TEST_F(LabTest, SwipeShowsBothInOneViewAndSlicesTheirOutlines) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  clickModel(kDepth6, Qt::RightButton);
  click("labSwipe");
  EXPECT_TRUE(lab().views().view(0).swipes());
  EXPECT_FALSE(lab().views().view(1).isVisible());
  click("labSideBySide");
  EXPECT_FALSE(lab().views().view(0).swipes());
  EXPECT_TRUE(lab().views().view(1).isVisible());
  click("labSlices");
  EXPECT_FALSE(lab().views().view(0).isVisible());
  auto* axial = find<SliceView>("lab_axialView");
  ASSERT_TRUE(axial->isVisible());
  EXPECT_FALSE(find<QCheckBox>("labWireframe")->isEnabled());
  EXPECT_FALSE(find<QCheckBox>("labWireframe")->toolTip().isEmpty());
  int orange = 0;
  int blue = 0;
  ASSERT_TRUE(waitFor([&] {
    orange = 0;
    blue = 0;
    const QImage image = axial->grab().toImage();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        orange += c.red() > 180 && c.blue() < 110 && c.green() > 100 ? 1 : 0;
        blue += c.blue() > 180 && c.red() < 130 ? 1 : 0;
      }
    }
    return orange > 20 && blue > 20;
  })) << orange
      << " and " << blue;
}

TEST_F(LabTest, TheTableSortsByNumbersAndFiltersByText) {
  compare({ModelFamily::Psr, ModelFamily::Mcsd});
  auto* view = find<QTableView>("labTableView");
  const QAbstractItemModel* table = view->model();
  ASSERT_EQ(table->rowCount(), 54);
  view->sortByColumn(1, Qt::AscendingOrder);
  const auto trianglesOf = [&](int row) { return table->index(row, 1).data(Qt::UserRole).toDouble(); };
  for (int row = 0; row + 1 < table->rowCount(); ++row) {
    EXPECT_LE(trianglesOf(row), trianglesOf(row + 1)) << row;
  }
  EXPECT_TRUE(std::isinf(trianglesOf(53))) << "what failed stands last";
  find<QLineEdit>("labFilter")->setText("s=22");
  EXPECT_EQ(table->rowCount(), 10);
  for (int row = 0; row < table->rowCount(); ++row) {
    EXPECT_TRUE(table->index(row, 0).data().toString().contains("s=22"));
  }
  find<QLineEdit>("labFilter")->setText("too small");
  EXPECT_EQ(table->rowCount(), 2) << "defects and failures are searched, too";
  find<QLineEdit>("labFilter")->clear();
  view->sortByColumn(0, Qt::AscendingOrder);
  view->setCurrentIndex(table->index(1, 0));
  QTest::keyClick(view, Qt::Key_Return);
  QTest::keyClick(view, Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(lab().side(0).recipe(), kDepth6);
  EXPECT_EQ(lab().side(1).recipe(), kDepth6);
}

TEST_F(LabTest, ExportsAreTheTableAndThePlot) {
  compare({ModelFamily::Psr});
  const auto bytesOf = [&](const QString& name) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  lab().writeCsv(folder.filePath("models.csv"));
  const Case& content = window->document().content();
  const double voxelMl = volumeMl(content.liver->liver, content.liver->geometry);
  EXPECT_EQ(bytesOf("models.csv").toStdString(), modelsCsv(evaluation(), voxelMl));
  lab().writePng(folder.filePath("plot.png"));
  const QImage picture(folder.filePath("plot.png"));
  EXPECT_EQ(picture.size(), 2 * lab().plot().size());
  lab().writeSvg(folder.filePath("plot.svg"));
  QXmlStreamReader svg(bytesOf("plot.svg"));
  int titles = 0;
  while (!svg.atEnd()) {
    titles += svg.readNext() == QXmlStreamReader::StartElement && svg.name() == QLatin1String("title") ? 1 : 0;
  }
  EXPECT_FALSE(svg.hasError()) << svg.errorString().toStdString();
  EXPECT_EQ(titles, 2) << "one for each model that was measured";
  EXPECT_THROW(lab().writeCsv(folder.filePath("no/such/folder/models.csv")), InputError);
}

TEST_F(LabTest, TheDepthSliderShowsThatModelOnTheChosenSide) {
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  const Case& content = window->document().content();
  const SurfaceMesh expected =
      reconstructPoisson(content.liver->liver, content.liver->geometry, poissonOf(kDepth6, ExperimentOptions{})).mesh;
  EXPECT_EQ(lab().side(0).recipe(), kDepth6);
  EXPECT_EQ(lab().side(0).reconstruction()->mesh.vertices, expected.vertices);
  ASSERT_TRUE(lab().side(0).model() && lab().side(0).model()->measures) << "nobody has measured it before";
  EXPECT_EQ(lab().side(0).model()->measures->triangles, expected.triangles.size());
  EXPECT_FALSE(lab().side(1).recipe().has_value());
  find<QRadioButton>("labDepthB")->setChecked(true);
  find<QSlider>("labDepth")->setValue(5);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_EQ(lab().side(1).recipe(), kDepth5);
  EXPECT_EQ(lab().side(0).recipe(), kDepth6);
  EXPECT_TRUE(evaluation().models.empty()) << "the slider's models are not the experiment's";
}

TEST_F(LabTest, TheSlidersModelHasAnOpenMarkOfItsOwnUntilTheExperimentHasIt) {
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_TRUE(lab().plot().pixelBeside(0).has_value());
  EXPECT_FALSE(lab().plot().pixelBeside(1).has_value());
  compare({ModelFamily::Psr});
  EXPECT_FALSE(lab().plot().pixelBeside(0).has_value()) << "now it is one of the scored models";
  EXPECT_TRUE(lab().plot().pixelOf(placeOf(kDepth6)).has_value());
  find<QSlider>("labDepth")->setValue(9);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_TRUE(lab().plot().pixelBeside(0).has_value());
  EXPECT_EQ(evaluation().models.size(), 4U);
}

TEST_F(LabTest, ADepthThatTheExperimentCouldNotMakeIsMeasuredByTheSliderUnderItsOwnName) {
  compare({ModelFamily::Psr});
  ASSERT_FALSE(evaluation().models[placeOf(kDepth8)].measures);
  find<QSlider>("labDepth")->setValue(8);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  ASSERT_TRUE(lab().side(0).model() && lab().side(0).model()->measures);
  EXPECT_TRUE(find<QLabel>("labNameA")->text().contains("PSR d=6")) << find<QLabel>("labNameA")->text().toStdString();
  EXPECT_FALSE(find<QLabel>("labNumbersA")->text().contains("too small"));
  EXPECT_TRUE(lab().plot().pixelBeside(0).has_value());
}

TEST_F(LabTest, AfterAModelThatWasNotMadeTheSideShowsNothingAndItCanBeAskedForAgain) {
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  ASSERT_NE(lab().side(0).surface().mesh, nullptr);
  find<QSlider>("labDepth")->setValue(5);
  jobs->cancelAll();
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_FALSE(lab().side(0).recipe().has_value());
  EXPECT_TRUE(find<QLabel>("labNameA")->text().contains("click a model"));
  EXPECT_EQ(lab().side(0).surface().mesh, nullptr);
  EXPECT_EQ(lab().side(0).surface().errors, nullptr);
  EXPECT_EQ(lab().side(0).reconstruction(), nullptr);
  EXPECT_FALSE(lab().side(0).model().has_value() || lab().side(0).p95Mm().has_value());
  EXPECT_TRUE(find<QLabel>("labNumbersA")->text().isEmpty());
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_EQ(lab().side(0).recipe(), kDepth6);
}

TEST_F(LabTest, TheSurfaceComesFirstAndSaysThatItsErrorsFollow) {
  bool bare = false;
  QObject::connect(&lab().side(0), &LabSide::changed, window.get(), [&] {
    bare = bare || (lab().side(0).surface().mesh && !lab().side(0).surface().errors && lab().side(0).unfinished() &&
                    find<QLabel>("labNameA")->text().contains("its errors are being measured"));
  });
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_TRUE(bare);
  EXPECT_FALSE(lab().side(0).unfinished());
  EXPECT_NE(lab().side(0).surface().errors, nullptr);
  EXPECT_EQ(find<QLabel>("labNameA")->text().contains("being measured"), false);
}

TEST_F(LabTest, TheBlindRatingIsOfTheStructureThatIsCompared) {
  find<QComboBox>("labStructure")->setCurrentIndex(1);
  find<QComboBox>("labSampling")->setCurrentIndex(1);
  emit find<QComboBox>("labSampling")->activated(1);
  const QString structure = find<QComboBox>("labStructure")->currentText();
  click("labRate");
  ASSERT_TRUE(waitFor([&] { return window->findChild<RatingWindow*>() != nullptr; }));
  auto* rating = window->findChild<RatingWindow*>();
  EXPECT_TRUE(rating->findChild<QPlainTextEdit*>("ratingQuestion")->toPlainText().contains(structure));
  rating->findChild<QLineEdit*>("ratingName")->setText("Anna");
  rating->findChild<QPushButton*>("ratingStart")->click();
  ASSERT_TRUE(rating->session());
  const std::string id = find<QComboBox>("labStructure")->currentData().toString().toStdString();
  for (const RatedModel& model : rating->session()->study.models) {
    EXPECT_NE(model.id.find("/" + id + "/"), std::string::npos) << model.id;
    EXPECT_TRUE(model.id.ends_with("_unbiased")) << model.id;
  }
  EXPECT_TRUE(waitFor([this] { return jobs->idle(); }));
}

TEST_F(LabTest, TheBlindRatingIsOfThePapersGroupsWhereAllPublishedModelsAreThere) {
  compare({ModelFamily::Psr, ModelFamily::Mcsd});
  ASSERT_TRUE(evaluation().publishedComplete);
  EXPECT_TRUE(find<QPushButton>("labRate")->toolTip().contains("best PSR"));
  click("labRate");
  ASSERT_TRUE(waitFor([&] { return window->findChild<RatingWindow*>() != nullptr; }));
  auto* rating = window->findChild<RatingWindow*>();
  rating->findChild<QLineEdit*>("ratingName")->setText("Anna");
  rating->findChild<QPushButton*>("ratingStart")->click();
  ASSERT_TRUE(rating->session());
  std::map<std::string, std::string> ids;
  for (const RatedModel& model : rating->session()->study.models) {
    ids[model.method] = model.id;
  }
  const auto idOf = [&](std::optional<std::size_t> place) { return modelId(evaluation().models[place.value()].recipe); };
  ASSERT_EQ(ids.size(), 3U);
  EXPECT_TRUE(ids["PSR (P_best)"].ends_with("/" + idOf(evaluation().bestPsr) + "_P_best")) << ids["PSR (P_best)"];
  EXPECT_TRUE(ids["MCSD (C_best)"].ends_with("/" + idOf(evaluation().bestMcsd) + "_C_best")) << ids["MCSD (C_best)"];
  EXPECT_TRUE(ids["MCSD (C_sim)"].ends_with("/" + idOf(evaluation().mostSimilar) + "_C_sim")) << ids["MCSD (C_sim)"];
  EXPECT_TRUE(waitFor([this] { return jobs->idle(); }));
}

TEST_F(LabTest, QuickMovesOfTheSliderEndAtTheLast) {
  for (const int depth : {5, 6, 10, 9, 5, 6, 5}) {
    find<QSlider>("labDepth")->setValue(depth);
  }
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_EQ(lab().side(0).recipe(), kDepth5);
  ASSERT_TRUE(lab().side(0).model().has_value());
  EXPECT_EQ(lab().side(0).model()->usedDepth, 5);
}

TEST_F(LabTest, ACancelKeepsWhatIsDoneAndTheNextRunMakesTheRest) {
  click("labCompare");
  EXPECT_TRUE(find<QPushButton>("labCancel")->isEnabled());
  EXPECT_FALSE(find<QPushButton>("labCompare")->isEnabled());
  ASSERT_TRUE(waitFor([this] { return !evaluation().models.empty() || !experiment().running(); }));
  click("labCancel");
  ASSERT_TRUE(waitFor([this] { return jobs->idle() && !experiment().running(); }));
  const std::size_t kept = evaluation().models.size();
  EXPECT_GT(kept, 0U);
  EXPECT_EQ(find<QTableView>("labTableView")->model()->rowCount(), static_cast<int>(kept));
  if (kept < allRecipes().size()) {
    click("labCompare");
    ASSERT_TRUE(waitFor([this] { return jobs->idle() && !experiment().running(); }, 120000));
  }
  EXPECT_EQ(evaluation().models.size(), allRecipes().size());
}

TEST_F(LabTest, AnotherStructureOrSamplingStartsAnew) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  const std::size_t liver = evaluation().models[placeOf(kDepth5)].measures->triangles;
  find<QComboBox>("labStructure")->setCurrentIndex(1);
  EXPECT_TRUE(evaluation().models.empty());
  EXPECT_FALSE(lab().side(0).recipe().has_value());
  EXPECT_EQ(lab().side(0).surface().mesh, nullptr);
  compare({ModelFamily::Psr});
  ASSERT_FALSE(evaluation().models.empty());
  EXPECT_NE(evaluation().models[placeOf(kDepth5)].measures ? evaluation().models[placeOf(kDepth5)].measures->triangles : 0, liver);
}

TEST_F(LabTest, NothingInTheLabChangesTheCase) {
  const Case before = window->document().content();
  const int steps = window->document().undoStack().count();
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  find<QSlider>("labDepth")->setValue(6);
  ASSERT_TRUE(waitFor([this] { return jobs->idle(); }));
  EXPECT_EQ(window->document().content().model, before.model);
  EXPECT_EQ(window->document().content().segmentation, before.segmentation);
  EXPECT_EQ(window->document().undoStack().count(), steps);
}

TEST_F(LabTest, FollowsTheLanguage) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  window->setLanguage("de");
  ASSERT_TRUE(waitFor([this] { return find<QPushButton>("labCompare")->text() == "Verfahren vergleichen"; }));
  EXPECT_TRUE(find<QToolButton>("workspaceCompare")->text().startsWith("Vergleich"));
  EXPECT_TRUE(find<QLabel>("labNumbersA")->text().contains("Dreiecke"));
  const QAbstractItemModel* table = find<QTableView>("labTableView")->model();
  EXPECT_EQ(table->headerData(0, Qt::Horizontal).toString(), "Modell");
  EXPECT_TRUE(table->index(0, 2).data().toString().contains(',')) << table->index(0, 2).data().toString().toStdString();
  EXPECT_EQ(find<QComboBox>("labStructure")->count(), 3);
  EXPECT_EQ(evaluation().models.size(), 4U) << "a language is no other structure";
}

TEST_F(LabTest, FitsTheSmallestWindowInBothLanguages) {
  compare({ModelFamily::Psr});
  clickModel(kDepth5);
  clickModel(kDepth6, Qt::RightButton);
  for (const char* code : {"en", "de"}) {
    window->setLanguage(code);
    QTest::qWait(50);
    EXPECT_LE(window->minimumSizeHint().width(), 1024) << code;
    EXPECT_LE(window->minimumSizeHint().height(), 700) << code;
    EXPECT_EQ(window->size(), QSize(1024, 700)) << code;
    const auto whole = [](const QWidget* part) { return part->width() >= part->minimumSizeHint().width(); };
    for (const QAbstractButton* part : lab().findChildren<QAbstractButton*>()) {
      EXPECT_TRUE(!part->isVisible() || waitFor([&] { return whole(part); }, 5000))
          << code << ", " << part->objectName().toStdString() << ": " << part->width() << " of " << part->minimumSizeHint().width();
    }
    for (const char* name : {"labNumbersA", "labNumbersB"}) {
      const auto* numbers = find<QLabel>(name);
      EXPECT_TRUE(waitFor([&] { return numbers->height() >= numbers->heightForWidth(numbers->width()); }, 5000))
          << code << ", " << name;
    }
  }
}

}  // namespace
}  // namespace glisson
