// The blind rating as raters go through it: names, keys, pauses, a crash between; and that nothing on the way tells the method.

#include "app/gui/rating_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "app/gui/language.h"
#include "main_window_test.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/rating_csv.h"
#include "reconstruction/evaluation/rating_tests_csv.h"
#include "tests/viewer/bodies.h"
#include "tests/viewer/kept_picture.h"

namespace glisson {
namespace {

using test::sphere;
using test::waitFor;

/// Two patients, of each two models by two methods whose names are found wherever they are shown.
std::vector<RatedSurface> eightSurfaces() {
  std::vector<RatedSurface> surfaces;
  for (const char* subject : {"Pat1", "Pat2"}) {
    for (const char* method : {"Alpha", "Beta"}) {
      for (const int rings : {10, 14}) {
        surfaces.push_back(ratedSurface({std::string(subject) + method + std::to_string(rings), method, subject},
                                        sphere(Vec3(20, -30, 400), Vec3(60, 45, 40), rings)));
      }
    }
  }
  return surfaces;
}

Structure structureOf(StructureKind kind, const std::string& name) {
  Structure made;
  made.kind = kind;
  made.name = name;
  return made;
}

constexpr int kShowings = 14;  // eight models, six of them twice

class RatingWindowTest : public test::DrivenWindow<RatingWindow> {
 protected:
  QTemporaryDir folder;
  Language language;
  Structure rated = structureOf(StructureKind::Liver, "");

  void SetUp() override {
    language.use("en");
    open(eightSurfaces());
  }
  void open(std::vector<RatedSurface> surfaces, const QString& place = {}) {
    window.reset();
    window =
        std::make_unique<RatingWindow>(std::move(surfaces), rated, place.isEmpty() ? folder.filePath("ratings") : place, nullptr);
    window->setAttribute(Qt::WA_DeleteOnClose, false);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  void enter(const QString& rater) {
    find<QLineEdit>("ratingName")->setText(rater);
    click("ratingStart");
  }
  /// To the widget that has the focus, as a keyboard does.
  void press(int value) { QTest::keyClick(window->focusWidget(), static_cast<Qt::Key>(Qt::Key_0 + value)); }
  void rateAll(const QString& rater, const std::function<int(const RatedModel&)>& valueOf) {
    enter(rater);
    while (const std::optional<Showing> showing = window->session()->next()) {
      press(valueOf(window->session()->study.models[showing->model]));
    }
  }
  RatingSession kept() {
    QFile file(window->path());
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << window->path().toStdString();
    return ratingSessionOfCsv(file.readAll().toStdString(), "kept");
  }
  QString progress() { return find<QLabel>("ratingProgress")->text(); }
};

int alphaIsBetter(const RatedModel& model) { return model.method == "Alpha" ? (model.subject == "Pat1" ? 5 : 4) : 2; }

TEST_F(RatingWindowTest, AWholeSessionGoesByKeysAndIsKeptAfterEveryRating) {
  EXPECT_EQ(find<QPlainTextEdit>("ratingQuestion")->toPlainText(),
            "Evaluate the quality of the virtual models (parenchyma) for their use in resection planning and surgery guidance.");
  EXPECT_FALSE(find<QPushButton>("ratingStart")->isEnabled());
  enter("  Anna   B. ");
  for (int n = 0; n < kShowings; ++n) {
    EXPECT_EQ(progress(), QString("Model %1 of %2").arg(n + 1).arg(kShowings));
    EXPECT_EQ(kept().raters.front().ratings.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(kept(), window->session());
    press(1 + n % 5);
  }
  const RatingSession session = kept();
  EXPECT_EQ(session, window->session());
  EXPECT_TRUE(session.finished(0));
  EXPECT_EQ(session.raters.front().name, "Anna B.");
  for (int n = 0; n < kShowings; ++n) {
    EXPECT_EQ(session.raters.front().ratings[static_cast<std::size_t>(n)].value, 1 + n % 5);
  }
  EXPECT_EQ(find<QLabel>("ratingHeading")->text(), "Thank you, Anna B.: all ratings are kept.");
  EXPECT_TRUE(find<QPushButton>("ratingShowResults")->isEnabled());
  EXPECT_EQ(find<QPushButton>("ratingStart")->text(), "Next rater");
}

TEST_F(RatingWindowTest, ButtonsAndTheKeypadRateHeldKeysAndOthersDoNot) {
  enter("A");
  auto* view = find<ModelView>("ratingView");
  EXPECT_EQ(window->focusWidget(), view);
  click("rate4");
  QTest::keyClick(view, Qt::Key_2, Qt::KeypadModifier);
  QKeyEvent held(QEvent::KeyPress, Qt::Key_3, Qt::NoModifier, "3", true);
  QCoreApplication::sendEvent(view, &held);
  QTest::keyClick(view, Qt::Key_3, Qt::ControlModifier);
  for (const Qt::Key key : {Qt::Key_0, Qt::Key_6, Qt::Key_9, Qt::Key_Space, Qt::Key_Return, Qt::Key_P}) {
    QTest::keyClick(view, key);
  }
  find<QPushButton>("rate1")->setFocus();
  press(5);
  std::vector<int> values;
  for (const Rating& rating : window->session()->raters.front().ratings) {
    values.push_back(rating.value);
  }
  EXPECT_EQ(values, (std::vector<int>{4, 2, 5}));
}

TEST_F(RatingWindowTest, NothingThatIsShownTellsTheMethodOrTheTriangles) {
  std::set<QString> secrets{"Alpha", "Beta", "Pat1", "Pat2", "csv", QString::number(2 * 20 * 9), QString::number(2 * 28 * 13)};
  enter("A");
  for (int n = 0; n < kShowings; ++n) {
    QStringList shown{window->windowTitle()};
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
      shown << widget->toolTip() << widget->statusTip() << widget->whatsThis() << widget->accessibleName()
            << widget->accessibleDescription() << widget->windowTitle();
      const auto* label = qobject_cast<const QLabel*>(widget);
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      if (widget->isVisible()) {
        shown << (label != nullptr ? label->text() : button != nullptr ? button->text() : QString());
      }
    }
    for (const QString& secret : secrets) {
      EXPECT_FALSE(shown.join('\n').contains(secret)) << secret.toStdString();
    }
    press(3);
  }
}

TEST_F(RatingWindowTest, EqualSurfacesOfTwoMethodsGiveTheSamePictureWhateverWasTurnedBefore) {
  const SurfaceMesh mesh = sphere(Vec3(20, -30, 400), Vec3(60, 45, 40), 12);
  const auto tumour = [](StructureKind kind, bool visible) {
    Structure structure = test::structure("tumour_01", kind, {200, 30, 20}, 0.3, sphere(Vec3(20, -75, 400), Vec3(9, 9, 9)));
    structure.visible = visible;
    return structure;
  };
  const RatedSurroundings around = surroundingsOf({.structures = {tumour(StructureKind::Tumour, false)}});
  open({ratedSurface({"a", "Alpha", "P"}, mesh, around), ratedSurface({"b", "Beta", "P"}, mesh, around)});
  enter("A");
  auto* view = find<ModelView>("ratingView");
  const QImage first = view->picture();
  ASSERT_FALSE(first.isNull());
  const Pose pose = view->pose();
  view->setStandardView(ModelView::StandardView::Superior);
  EXPECT_NE(view->picture(), first);
  press(3);
  EXPECT_EQ(view->pose(), pose);
  EXPECT_EQ(view->picture(), first);
  EXPECT_TRUE(surroundingsOf({.structures = {tumour(StructureKind::Liver, true)}}).structures.empty());
  EXPECT_NE(test::kept(first, "rating_surroundings").pixelColor(first.width() / 2, first.height() / 2).red(),
            first.pixelColor(first.width() / 2, first.height() / 2).blue())
      << "the tumour before the grey surface is seen";
}

TEST_F(RatingWindowTest, APauseStopsTheTimeAndComesBackToTheSameModel) {
  QElapsedTimer whole;
  whole.start();
  enter("A");
  press(3);
  click("ratingPause");
  EXPECT_TRUE(find<QWidget>("ratingHeading")->isVisible());
  EXPECT_FALSE(find<QWidget>("ratingView")->isVisible());
  EXPECT_EQ(find<QLabel>("ratingHeading")->text(), "A goes on with model 2 of 14.");
  QElapsedTimer paused;
  paused.start();
  QTest::qWait(200);
  const double pauseSeconds = static_cast<double>(paused.elapsed()) / 1000;
  click("ratingStart");
  EXPECT_EQ(progress(), "Model 2 of 14");
  press(4);
  const double wholeSeconds = static_cast<double>(whole.elapsed() + 1) / 1000;
  const std::vector<Rating>& ratings = window->session()->raters.front().ratings;
  ASSERT_EQ(ratings.size(), 2U);
  EXPECT_GE(ratings[1].seconds, 0);
  EXPECT_LE(ratings[0].seconds + ratings[1].seconds, wholeSeconds - pauseSeconds);
}

TEST_F(RatingWindowTest, AKilledSessionGoesOnAtTheModelWhereItStopped) {
  find<QPlainTextEdit>("ratingQuestion")->setPlainText("How good\nis it?");
  rateAll("Anna", alphaIsBetter);
  enter("Ben");
  press(2);
  press(3);
  const QString path = window->path();
  const std::optional<RatingSession> before = window->session();
  open(eightSurfaces());
  click("ratingResume");
  auto* dialog = find<QFileDialog>("ratingOpenDialog");
  emit dialog->fileSelected(path);
  dialog->reject();
  EXPECT_EQ(window->session(), before);
  EXPECT_EQ(find<QLabel>("ratingHeading")->text(), "Ben goes on with model 3 of 14.");
  EXPECT_EQ(find<QLineEdit>("ratingName")->text(), "Ben");
  EXPECT_TRUE(find<QLineEdit>("ratingName")->isReadOnly());
  click("ratingStart");
  EXPECT_EQ(progress(), "Model 3 of 14");
  EXPECT_EQ(find<QLabel>("ratingQuestionShown")->text(), "How good is it?");
  press(5);
  EXPECT_EQ(window->path(), path);
  EXPECT_EQ(kept().raters.back().ratings.size(), 3U);
}

TEST_F(RatingWindowTest, ASessionOfOtherModelsAndWhatIsNoneIsRefusedAndNothingIsLost) {
  rateAll("Anna", alphaIsBetter);
  const QString path = window->path();
  const std::string kept = ratingCsv(*window->session());
  std::vector<RatedSurface> others = eightSurfaces();
  others.pop_back();
  open(others);
  EXPECT_THROW(window->resume(path), InputError);
  EXPECT_THROW(window->resume(folder.filePath("none.csv")), InputError);
  QFile(folder.filePath("text.csv")).open(QIODevice::WriteOnly);
  click("ratingResume");
  auto* dialog = find<QFileDialog>("ratingOpenDialog");
  emit dialog->fileSelected(folder.filePath("text.csv"));
  dialog->reject();
  EXPECT_TRUE(find<QLabel>("ratingNotice")->isVisible());
  EXPECT_TRUE(find<QLabel>("ratingNotice")->text().contains("is no session of a blind rating (line 1 does not name its columns)"));
  language.use("de");
  EXPECT_TRUE(waitFor([&] { return find<QLabel>("ratingNotice")->text().contains("(Zeile 1 nennt die Spalten nicht)"); }));
  EXPECT_FALSE(window->session());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().toStdString(), kept);
}

TEST_F(RatingWindowTest, WhereTheSessionCannotBeKeptItDoesNotBegin) {
  QFile file(folder.filePath("file"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  open(eightSurfaces(), folder.filePath("file/ratings"));
  enter("Anna");
  EXPECT_FALSE(window->session());
  EXPECT_TRUE(find<QLabel>("ratingNotice")->text().contains("cannot be written (Not a directory)"));
  EXPECT_FALSE(find<QWidget>("ratingView")->isVisible());
}

TEST_F(RatingWindowTest, ARatingThatCannotBeWrittenStaysAndIsKeptWithTheNext) {
  enter("Anna");
  ASSERT_TRUE(QFile::remove(window->path()));
  ASSERT_TRUE(QDir().mkpath(window->path() + "/in the way"));
  press(2);
  EXPECT_TRUE(find<QLabel>("ratingNotice")->isVisible());
  EXPECT_EQ(progress(), "Model 2 of 14");
  ASSERT_TRUE(QDir(window->path()).removeRecursively());
  press(4);
  EXPECT_FALSE(find<QLabel>("ratingNotice")->isVisible());
  EXPECT_EQ(kept().raters.front().ratings.size(), 2U);
}

TEST_F(RatingWindowTest, EachRaterHasANameAndAnOrderOfHisOwn) {
  rateAll("Anna", alphaIsBetter);
  find<QLineEdit>("ratingName")->setText("Anna");
  click("ratingStart");
  EXPECT_TRUE(find<QLabel>("ratingNotice")->text().contains("There is a rater \"Anna\" already"));
  EXPECT_TRUE(find<QPlainTextEdit>("ratingQuestion")->isReadOnly());
  rateAll("Ben", alphaIsBetter);
  EXPECT_FALSE(find<QLabel>("ratingNotice")->isVisible());
  EXPECT_EQ(kept().raters.size(), 2U);
  EXPECT_EQ(kept().study, window->session()->study);
}

TEST_F(RatingWindowTest, NobodySeesResultsBeforeHeHasFinishedAndOneWhoLeavesMakesRoomForAnother) {
  rateAll("Anna", alphaIsBetter);
  enter("Ben");
  press(1);
  click("ratingPause");
  EXPECT_FALSE(find<QPushButton>("ratingShowResults")->isEnabled());
  EXPECT_EQ(find<QPushButton>("ratingShowResults")->toolTip(), "Results are shown after the last model.");
  click("ratingAnother");
  EXPECT_EQ(find<QLabel>("ratingHeading")->text(), "Ben has not finished and takes no part in the results.");
  EXPECT_TRUE(find<QPushButton>("ratingShowResults")->isEnabled());
  enter("Carla");
  EXPECT_EQ(progress(), "Model 1 of 14");
  press(5);
  ASSERT_EQ(kept().raters.size(), 3U);
  EXPECT_EQ(kept().raters[1].ratings.size(), 1U);
  EXPECT_EQ(kept().raters[2].ratings, window->session()->raters[2].ratings);
  EXPECT_EQ(kept().raters[2].ratings.at(0).value, 5);
}

TEST_F(RatingWindowTest, ResultsTellBothTestsWithNumbersInTheLanguageAndAreSaved) {
  rateAll("Anna", alphaIsBetter);
  rateAll("Ben", [](const RatedModel& model) { return model.method == "Alpha" ? 3 : 2; });
  click("ratingShowResults");
  auto* text = find<QLabel>("ratingResultsText");
  // Alpha: 5 5 4 4 3 3 3 3, Beta: 2 throughout; means of the raters differ by 2.5 and 1
  EXPECT_TRUE(text->text().contains("Alpha less Beta"));
  EXPECT_TRUE(text->text().contains("3.750"));
  EXPECT_TRUE(text->text().contains(">3.5<")) << "the median of an even number";
  EXPECT_TRUE(text->text().contains("Welch&#39;s t-test of all ratings: difference 1.750, t = 5.584, df = 7.0, p = 0.000830") ||
              text->text().contains("Welch's t-test of all ratings: difference 1.750, t = 5.584, df = 7.0, p = 0.000830"))
      << text->text().toStdString();
  EXPECT_TRUE(text->text().contains("difference 1.750, t = 2.333, df = 1.0, p = 0.258")) << text->text().toStdString();
  EXPECT_TRUE(text->text().contains("by Anna alone: difference 2.500, t = 5.000, df = 1.0, p = 0.126"));
  EXPECT_TRUE(text->text().contains("by Ben alone: no test: nothing varies"));
  language.use("de");
  ASSERT_TRUE(waitFor([&] { return text->text().contains("1,750"); }));
  click("ratingSave");
  auto* dialog = find<QFileDialog>("ratingSaveDialog");
  emit dialog->fileSelected(folder.filePath("copy.csv"));
  dialog->reject();
  QFile copy(folder.filePath("copy.csv"));
  ASSERT_TRUE(copy.open(QIODevice::ReadOnly));
  EXPECT_EQ(ratingSessionOfCsv(copy.readAll().toStdString(), "copy"), *window->session());
  QFile tests(folder.filePath("copy-tests.csv"));
  ASSERT_TRUE(tests.open(QIODevice::ReadOnly));
  EXPECT_EQ(tests.readAll().toStdString(), ratingTestsCsv(ratingResults(*window->session())));
}

TEST_F(RatingWindowTest, TheQuestionNamesTheStructure) {
  rated = structureOf(StructureKind::PortalVein, "portalvein");
  open(eightSurfaces(), folder.filePath("vein"));
  EXPECT_EQ(find<QPlainTextEdit>("ratingQuestion")->toPlainText(),
            "Evaluate the quality of the virtual models (portalvein) for their use in resection planning and surgery guidance.");
}

TEST_F(RatingWindowTest, NoTextIsCutOffInAnyLanguageAtTheLeastSize) {
  window->resize(window->minimumSize());
  const auto check = [&](const QString& page, const char* code) {
    QTest::qWait(50);  // layouts settle in the event loop
    test::kept(window->grab().toImage(), QString("rating_%1_%2").arg(page, code));
    EXPECT_EQ(window->size(), window->minimumSize());
    for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
      if (button->isVisible() && !button->text().isEmpty()) {
        EXPECT_TRUE(waitFor([&] { return button->width() >= button->minimumSizeHint().width(); }, 5000))
            << code << ' ' << button->text().toStdString();
      }
    }
    for (const QLabel* label : window->findChildren<QLabel*>()) {
      if (label->isVisible() && !label->text().isEmpty()) {
        const auto fits = [label] {
          const int height = label->hasHeightForWidth() ? label->heightForWidth(label->width()) : label->sizeHint().height();
          return label->width() >= (label->wordWrap() ? 0 : label->sizeHint().width()) && label->height() >= height;
        };
        EXPECT_TRUE(waitFor(fits, 5000)) << code << ' ' << label->text().toStdString();
      }
    }
  };
  for (const char* code : {"en", "de"}) {
    open(eightSurfaces());
    window->resize(window->minimumSize());
    language.use(code);
    check("start", code);
    enter(QString("Anna ") + code);
    check("model", code);
    click("ratingPause");
    check("pause", code);
    rateAll(QString("Anna ") + code, alphaIsBetter);
    rateAll("Ben", [](const RatedModel& model) { return model.method == "Alpha" ? 3 : 2; });
    check("next", code);
    click("ratingShowResults");
    check("results", code);
  }
}

TEST_F(RatingWindowTest, TheMenuOffersModelsOfBothMethodsOfTheOpenCase) {
  ThreadJobRunner jobs(2);
  MainWindow main(jobs, language, folder.filePath("data/recovery").toStdString());
  main.show();
  EXPECT_FALSE(main.findChild<QAction*>("actionRating")->isEnabled());
  emit main.opener().opened(test::smallCase(), nullptr, {});
  ASSERT_TRUE(waitFor([&] { return jobs.idle(); }));
  main.findChild<QAction*>("actionRating")->trigger();
  ASSERT_TRUE(waitFor([&] { return main.findChild<RatingWindow*>() != nullptr; }));
  auto* rating = main.findChild<RatingWindow*>();
  rating->findChild<QLineEdit*>("ratingName")->setText("Anna");
  rating->findChild<QPushButton*>("ratingStart")->click();
  ASSERT_TRUE(rating->session());
  EXPECT_TRUE(rating->path().startsWith(folder.filePath("data/ratings/"))) << rating->path().toStdString();
  std::map<std::string, int> methods;
  for (const RatedModel& model : rating->session()->study.models) {
    ++methods[model.method];
  }
  EXPECT_EQ(methods["MCSD"], 4);
  EXPECT_GE(methods["PSR"], 1);
  EXPECT_EQ(methods.size(), 2U);
  EXPECT_TRUE(waitFor([&] { return jobs.idle(); }));

  const QString path = rating->path();
  const auto withoutGrades = [&] {  // as an earlier version wrote it
    RatingSession session = *rating->session();
    for (RatedModel& model : session.study.models) {
      model.grade.clear();
    }
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(ratingCsv(session)));
  };
  withoutGrades();
  rating->resume(path);
  rating->findChild<QPushButton*>("ratingStart")->click();
  while (const std::optional<Showing> showing = rating->session()->next()) {
    const RatedModel& model = rating->session()->study.models[showing->model];
    EXPECT_TRUE(QString::fromStdString(model.grade).contains(" / MCSD")) << model.grade;
    const int value = model.method == "MCSD" ? 2 : QString::fromStdString(model.id).endsWith("d6") ? 5 : 3;
    QTest::keyClick(rating->focusWidget(), static_cast<Qt::Key>(Qt::Key_0 + value));
  }
  rating->findChild<QPushButton*>("ratingShowResults")->click();
  const QString text = rating->findChild<QLabel*>("ratingResultsText")->text();
  EXPECT_TRUE(text.contains("Paired t-test over the grades by Anna alone: difference -2.000, t = -2.000, df = 1.0"))
      << text.toStdString();
  EXPECT_TRUE(text.contains("Models of one grade are paired: PSR d=5 / MCSD s=90 e=80 %; PSR d=6 / MCSD s=67 e=60 %"))
      << text.toStdString();
}

}  // namespace
}  // namespace glisson
