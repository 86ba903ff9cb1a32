// The libraries' sentences in the window: each has a row in the catalogue, the rows name no flag of the command line, and what the
// libraries really say comes out in German with its names and numbers.

#include "app/gui/sentences.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTranslator>
#include <fstream>
#include <regex>

#include "app/gui/language.h"
#include "app/gui/main_window.h"
#include "app/gui/message_bar.h"
#include "app/gui/sentence_table.h"
#include "app/jobs/thread_job_runner.h"
#include "planning/storage/case_file.h"
#include "reconstruction/mesh/surface_mesh.h"
#include "small_case.h"
#include "source_sentences.h"
#include "tests/reconstruction/io/fixtures.h"
#include "tests/support/paths.h"
#include "wait.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;
using fixtures::DicomOptions;
using fixtures::TemporaryFolder;

const fs::path kSources = test::sourceFolder();

// ---- the catalogue and the sources

/// Translates every row to its places alone: a letter that is left in a shown text came from no row.
class PlacesOnly : public QTranslator {
 public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/, int /*n*/) const override {
    if (qstrcmp(context, "Sentence") != 0) {
      return {};
    }
    QString places("_");
    for (const char* at = source; *at != '\0'; ++at) {
      if (*at == '%' && at[1] >= '1' && at[1] <= '9') {
        places += QString('%') + QChar(at[1]);
      }
    }
    return places;
  }
};

/// What no window shows. A new entry needs a reason as good as these.
struct NeverShown {
  const char* file;  ///< part of the path; empty: any
  const char* text;  ///< a pattern for the whole text, or the callee with "()" behind
  const char* why;
};
constexpr auto kNeverShown = std::to_array<NeverShown>({
    {"", "invalid_argument()", "a fault of the program"},
    {"", "logic_error()", "a fault of the program"},
    {"", "length_error()", "a fault of the program"},
    {"", "static_assert()", "told by the compiler"},
    {"", "starts_with()", "compared with, not said"},
    {"", "find()", "compared with, not said"},
    {"planning/storage/", "(PRAGMA|SELECT|INSERT|DELETE|CREATE|ALTER|BEGIN|UPDATE) .*|execute\\(\\)", "SQL"},
    {"reconstruction/sample/dicom_series.cpp", ".*", "the sample patient's files, written by glisson-cli"},
    {"reconstruction/sample/volume_writers.cpp", ".*", "the sample patient's files, written by glisson-cli"},
    {"reconstruction/sample/write_sample.cpp", ".*", "the sample patient's files, written by glisson-cli"},
    {"reconstruction/sample/gzip_file.cpp", ".*could not be written.*", "the sample patient's files, written by glisson-cli"},
    {"reconstruction/sample/sample_patient.cpp", "Synthetic .*", "the series' name in the patient's own data"},
    {"planning/exchange/mesh_writers.cpp", "(Glisson|ply|# Glisson|<DataArray|<.xml) .*|<.xml.*", "text of a mesh file"},
    {"planning/exchange/mesh_writers.cpp", ".*<DataArray.*", "text of a mesh file"},
    {"planning/exchange/", "Glisson 7|resection surface|Not for clinical use", "text of the package's files"},
    {"planning/resection/bend.h", ".*i along u, j along v", "text of the package's files"},
    {"reconstruction/io/import/nrrd.cpp", "(un)?signed .*|(short|long|unsigned) .*", "NRRD's names of types"},
    {"reconstruction/io/import/nrrd.cpp", "(7 )?(list|domain)|.*(data file|line skip|kinds):.*|data file|space (directions|origin)",
     "fields of a NRRD header"},
    {"reconstruction/io/import/dicom_slice.cpp", "no (DICOM|image)", "told apart by it, not said"},
    {"reconstruction/io/import/main.cpp", "glisson-import is started by Glisson itself.*", "said on a terminal"},
    {"reconstruction/methods/", "[A-Z]\\. .*, 20[0-9][0-9]\\.", "a publication, cited as it is named"},
    {"reconstruction/io/options.cpp", "--(labels|accept) 7 .*", "refused before there is a window"},
    {"reconstruction/io/import/meta_image.cpp", "ObjectType = .*|7 ElementType = .*", "fields of a MetaImage header"},
    {"app/gui/", "(tr|QT_TR_NOOP|setStyleSheet|setShortcut|translate)\\(\\)",
     "the window's own texts, translated where they stand"},
});

bool isNeverShown(const std::string& file, const test::SourceSentence& sentence) {
  return std::ranges::any_of(kNeverShown, [&](const NeverShown& entry) {
    const std::regex pattern(entry.text);
    const std::string byCallee = sentence.callee + "()";
    return file.find(entry.file) != std::string::npos &&
           (std::regex_match(sentence.text, pattern) || std::regex_match(byCallee, pattern) || entry.text == byCallee);
  });
}

bool isCovered(const std::string& sentence) {
  const QString text = QString::fromStdString(sentence);
  const auto holdsNoWord = [](const QString& shown) {
    static const QRegularExpression kWord("[A-Za-z]{2}");
    return !kWord.match(shown).hasMatch();
  };
  // by itself, as a name, or as part of a larger sentence
  return holdsNoWord(shownSentence(text)) || holdsNoWord(shownName(text)) || holdsNoWord(shownSentence("Left out: " + text + "."));
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* room : {"reconstruction", "planning"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSources / room)) {
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") {
        files.push_back(entry.path());
      }
    }
  }
  for (const char* file : {"open_inputs.cpp", "document.cpp", "case_opener.cpp", "model_builder.cpp", "main_window.cpp",
                           "export_panel.cpp", "case_store.cpp"}) {
    files.push_back(kSources / "app/gui" / file);
  }
  files.push_back(kSources / "app/jobs/job_runner.cpp");
  return files;
}

TEST(SentenceCatalogueTest, EverySentenceOfTheSourcesHasARow) {
  PlacesOnly placesOnly;
  QCoreApplication::installTranslator(&placesOnly);
  std::size_t seen = 0;
  for (const fs::path& file : sources()) {
    const std::string name = fs::relative(file, kSources).string();
    for (const test::SourceSentence& sentence : test::sentencesOf(file)) {
      if (!isNeverShown(name, sentence)) {
        ++seen;
        EXPECT_TRUE(isCovered(sentence.text))
            << name << ":" << sentence.line << ": \"" << sentence.text
            << "\" has no row in app/gui/sentences_*.cpp (7 stands for what is put in); add one, and its German text.";
      }
    }
  }
  QCoreApplication::removeTranslator(&placesOnly);
  EXPECT_GT(seen, 400U) << "the sentences of the sources are not found any more";
}

TEST(SentenceCatalogueTest, NoTextForTheWindowNamesAFlagAndEveryPlaceHasItsLetter) {
  for (const auto& table : {dicomSentences(), readingSentences(), modelSentences(), planningSentences(), planSentences(),
                            windowSentences(), knownNames()}) {
    for (const SentenceRow& row : table) {
      const QString text = QString::fromUtf8(row.text);
      const QString shown = row.shown != nullptr ? QString::fromUtf8(row.shown) : text;
      EXPECT_FALSE(shown.contains("--")) << row.text;
      EXPECT_TRUE(QRegularExpression("^\\.?[fnsk]*$").match(row.places).hasMatch()) << row.text;
      const auto letters = static_cast<int>(QString(row.places).remove('.').size());
      EXPECT_TRUE(letters == 0 ||
                  (text.contains('%' + QString::number(letters)) && !text.contains('%' + QString::number(letters + 1))))
          << row.text;
    }
  }
}

TEST(SentenceCatalogueTest, TheReaderOfTheSourcesFindsChoicesConstantsAndJoinedParts) {
  const TemporaryFolder folder;
  const fs::path file = folder / "a.cpp";
  std::ofstream(file) << R"x(
// throw "no sentence here";
constexpr const char* kAgain = ": try it again.";
void f(int n) {
  const std::string which = n == 1 ? " of one" : "";
  throw InputError(name + " holds " + std::to_string(n) + (n == 1 ? " thing" : " things") + which + kAgain);
  notes.push_back("a \"quoted\" word" " joined");
  text += " at the end";
  refuse(file, "is not " + word);
})x";
  std::set<std::string> texts;
  for (const test::SourceSentence& sentence : test::sentencesOf(file)) {
    texts.insert(sentence.callee + "|" + sentence.text);
  }
  EXPECT_EQ(texts, (std::set<std::string>{
                       "InputError|7 holds 7 thing of one: try it again.", "InputError|7 holds 7 thing: try it again.",
                       "InputError|7 holds 7 things of one: try it again.", "InputError|7 holds 7 things: try it again.",
                       "push_back|a \"quoted\" word joined", "|7 at the end", "refuse|is not 7"}));
}

// ---- what the libraries really say

class ShownSentenceTest : public testing::Test {
 protected:
  Language language;
  TemporaryFolder folder;
  void SetUp() override { language.use("de"); }
  void TearDown() override { language.use("en"); }

  template <class Act>
  static QString shown(Act&& act) {
    try {
      act();
    } catch (const Error& error) {
      return shownSentence(std::string(error.what()));
    }
    return "nothing was refused";
  }
  [[nodiscard]] QString name(const std::string& file) const { return QString::fromStdString((folder / file).string()); }
};

std::shared_ptr<const Segmentation> segmentationOf(const Case& content) { return content.segmentation; }

TEST_F(ShownSentenceTest, ATruncatedFileIsRefusedInGermanWithItsName) {
  const ImageGeometry grid = fixtures::permutedGrid(0, 0);
  fixtures::Bytes file = fixtures::nifti(grid, fixtures::asymmetricBody(grid));
  file.resize(file.size() - 100);
  fixtures::writeFile(folder / "cut off and more.nii", file);
  const QString text = shown([&] { readSegmentation(folder / "cut off and more.nii", {}); });
  EXPECT_TRUE(text.startsWith(name("cut off and more.nii") + " ist abgeschnitten: Enthalten sind ")) << text.toStdString();
  EXPECT_TRUE(text.contains("404 der 504 Byte Voxel")) << text.toStdString();
}

TEST_F(ShownSentenceTest, ATiltIsToldWithItsDegreesAndWithoutTheFlag) {
  const double tilt = 10 * 3.14159265358979 / 180;
  for (int k = 0; k < 4; ++k) {
    DicomOptions options;
    options.column = Vec3(0, std::cos(tilt), -std::sin(tilt));
    options.position = Vec3(0, 0, 3.0 * k);
    options.instance = k;
    fixtures::writeFile(
        folder / ("slice " + std::to_string(k) + ".dcm"),
        fixtures::dicomSlice(options, fixtures::bytesOf(std::vector<std::int16_t>(72, static_cast<std::int16_t>(k)))));
  }
  EXPECT_EQ(shown([&] { readCt(folder.path(), {}); }),
            QString::fromStdString(folder.path().string()) +
                " ist kein gleichmäßiges Volumen: die Gantry war um 10,0 Grad gekippt; wählen Sie eine andere Serie oder lesen "
                "Sie diese trotzdem, umgerechnet auf ein gleichmäßiges Gitter.");
}

TEST_F(ShownSentenceTest, TwoFramesThatDisagreeAreToldWithoutTheFlag) {
  const ImageGeometry grid = fixtures::permutedGrid(0, 0);
  fixtures::NiftiOptions options;
  options.qform = true;
  options.sformShiftMm = 5;
  fixtures::writeFile(folder / "two.nii", fixtures::nifti(grid, fixtures::asymmetricBody(grid), options));
  const QString text = shown([&] { readSegmentation(folder / "two.nii", {}); });
  EXPECT_EQ(text, name("two.nii") + " liegt an zwei Orten: sform und qform sind 5,00 mm auseinander; wählen Sie sform oder qform.");
}

TEST_F(ShownSentenceTest, AMissingSliceIsToldInsideTheSentenceAboutItsSeries) {
  fixtures::writeCtSeries(folder.path(), {0, 2, 4, 8, 10});
  const QString text = shown([&] { readCt(folder.path(), {}); });
  EXPECT_TRUE(text.contains(" liegen 4,000 mm statt 2,000 mm (eine fehlende oder ungleiche Schicht); wählen Sie"))
      << text.toStdString();
}

TEST_F(ShownSentenceTest, LabelsOffTheGridNameBothGrids) {
  const Case small = test::smallCase();
  Segmentation labels = *segmentationOf(small);
  labels.geometry.origin += Vec3(1, 0, 0);
  const QString text = shown([&] { matchToCt(labels, *small.ct, {}); });
  EXPECT_TRUE(text.contains("(Labels: 56x48x40 Voxel zu 2")) << text.toStdString();
  EXPECT_TRUE(text.endsWith("wählen Sie die richtigen Dateien oder lesen Sie diese trotzdem.")) << text.toStdString();
}

TEST_F(ShownSentenceTest, APlaneThatMissesTheLiverWarnsOfEachResection) {
  const Case small = test::smallCase();
  ResectionPlan plan;
  plan.resections = {{.name = "Resection 1", .planes = {{Vec3(900, 0, 0), Vec3::UnitX()}}},
                     {.name = "left lobe", .planes = {{Vec3(-900, 0, 0), Vec3::UnitX()}}}};
  EXPECT_EQ(shownSentence(PlanAssessor(small).volumes(plan).warning),
            "Resektion 1 teilt die Leber nicht: Nichts wird reseziert. left lobe teilt die Leber nicht: Sie wird ganz reseziert.");
}

TEST_F(ShownSentenceTest, NotesDeviationsDefectsAndParametersOfAStructureAreGerman) {
  EXPECT_EQ(shownSentence(std::string("volume +2.4 % against the voxels")), "Volumen +2,4 % gegenüber den Voxeln");
  EXPECT_EQ(shownSentence(std::string("2 pieces of 5 lost: 12, 7 voxels")), "2 Teile von 5 verloren: 12, 7 Voxel");
  EXPECT_EQ(shownSentence(std::string("1 piece lost: 1 voxel")), "1 Teil verloren: 1 Voxel");
  MeshDefects defects;
  defects.openEdges = 3;
  defects.nonManifoldVertices = 1;
  EXPECT_EQ(shownSentence(defects.names().at(0)), "offen: 3 Kanten");
  EXPECT_EQ(shownSentence(defects.names().at(1)), "Punkt: 1 Punkt ist nicht mannigfaltig");
  ReconstructionParameters parameters;
  parameters.method = Method::Mcsd;
  parameters.mcsd.smoothing = 20;
  parameters.mcsd.decimation = 0.055;
  parameters.mcsd.splitNormals = true;
  EXPECT_EQ(shownSentence(parameters.describe()), "MCSD Sinc 20, Dezimierung 5,5 %, geteilte Normalen");
  for (const StructureKind kind : kAllStructureKinds) {
    EXPECT_FALSE(shownSentence(ReconstructionParameters::defaultsFor(kind).describe()).contains("unbiased"));
  }
}

TEST_F(ShownSentenceTest, TheNotesOfTheLiversVoxelsAreGermanAndNameTheLesion) {
  EXPECT_EQ(shownSentence(std::string("tumour 2: 1.250 mL lie outside the liver mask and are counted as liver.")),
            "Tumor 2: 1,250 mL liegen außerhalb der Lebermaske und zählen als Leber.");
  EXPECT_EQ(shownSentence(std::string("Met_03: 1.250 mL do not touch the liver and are not counted in it.")),
            "Met_03: 1,250 mL berühren die Leber nicht und zählen nicht zu ihr.");
}

TEST_F(ShownSentenceTest, ADamagedCaseNamesWhatIsWrongInIt) {
  std::ofstream(folder / "a.glisson") << "no database at all, but long enough to be looked at";
  EXPECT_EQ(shown([&] { CaseFile::open(folder / "a.glisson"); }),
            name("a.glisson") + " ist kein Glisson-Fall; wählen Sie eine Datei .glisson.");
  EXPECT_EQ(shownSentence(std::string("/x.glisson is damaged (its plans is missing); open an older copy of the case.")),
            "/x.glisson ist beschädigt (der Teil plans fehlt); öffnen Sie eine ältere Kopie des Falls.");
}

TEST_F(ShownSentenceTest, NamesAndFilesThatLookLikeSentencesStayAsTheyAre) {
  EXPECT_EQ(shownSentence(std::string("/data/%2 is damaged/a %1.nii does not exist; check the path.")),
            "/data/%2 is damaged/a %1.nii existiert nicht; prüfen Sie den Pfad.");
  EXPECT_EQ(shownSentence(std::string("A sentence that no library says.")), "A sentence that no library says.");
  EXPECT_EQ(shownSentence(QString()), QString());
  EXPECT_EQ(shownName(std::string("hepatic vein")), "Lebervene");
  EXPECT_EQ(shownName(std::string("VENA_2")), "VENA_2");
}

TEST_F(ShownSentenceTest, InEnglishOnlyWhatNamesAFlagIsSaidOtherwise) {
  language.use("en");
  const std::string plain = "/a b.nii is cut off before its voxels; copy or export it again.";
  EXPECT_EQ(shownSentence(plain), QString::fromStdString(plain));
  EXPECT_EQ(shownSentence(std::string("volume -0.31 % against the voxels")), "volume -0.31 % against the voxels");
  EXPECT_EQ(
      shownSentence(std::string("a.nii lies in two places: its sform and qform are 5.00 mm apart; choose with --prefer sform or "
                                "--prefer qform.")),
      "a.nii lies in two places: its sform and qform are 5.00 mm apart; choose sform or qform.");
}

// ---- in the window

class ShownInWindowTest : public ShownSentenceTest {
 protected:
  QTemporaryDir data;
  std::unique_ptr<ThreadJobRunner> jobs = std::make_unique<ThreadJobRunner>(2);
  std::unique_ptr<MainWindow> window;

  void SetUp() override {
    language.use("de");
    window = std::make_unique<MainWindow>(*jobs, language, data.filePath("recovery").toStdString());
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  void TearDown() override {
    jobs.reset();
    window.reset();
    language.use("en");
  }
};

TEST_F(ShownInWindowTest, ARefusedFileIsToldInGermanAndFollowsTheLanguage) {
  const ImageGeometry grid = fixtures::permutedGrid(0, 0);
  fixtures::Bytes file = fixtures::nifti(grid, fixtures::asymmetricBody(grid));
  file.resize(400);
  fixtures::writeFile(folder / "liver.nii", file);
  window->opener().openPaths({name("liver.nii")});
  auto* text = window->findChild<QLabel*>("messageText");
  ASSERT_TRUE(test::waitFor([&] { return !window->messages().messages().isEmpty(); }));
  EXPECT_TRUE(text->text().startsWith(name("liver.nii") + " ist abgeschnitten")) << text->text().toStdString();
  language.use("en");
  EXPECT_TRUE(test::waitFor([&] { return text->text().startsWith(name("liver.nii") + " is cut off"); }))
      << text->text().toStdString();
}

TEST_F(ShownInWindowTest, AQuestionAsksInGermanAndNamesNoFlag) {
  const ImageGeometry grid = fixtures::permutedGrid(0, 0);
  fixtures::NiftiOptions options;
  options.qform = true;
  options.sformShiftMm = 5;
  fixtures::writeFile(folder / "liver.nii", fixtures::nifti(grid, fixtures::asymmetricBody(grid), options));
  window->opener().openPaths({name("liver.nii")});
  ASSERT_TRUE(test::waitFor(
      [&] { return window->findChild<QMessageBox*>("frameDialog") != nullptr || !window->messages().messages().isEmpty(); }));
  auto* box = window->findChild<QMessageBox*>("frameDialog");
  ASSERT_NE(box, nullptr) << window->messages().messages().join('\n').toStdString();
  EXPECT_TRUE(box->informativeText().contains("liegt an zwei Orten")) << box->informativeText().toStdString();
  EXPECT_FALSE(box->informativeText().contains("--"));
  box->reject();
}

TEST_F(ShownInWindowTest, TheNotesOfACaseFollowTheLanguage) {
  Case content = test::smallCase();
  content.notes = {"Not part of a liver model: spleen."};
  emit window->opener().opened(content, nullptr, {});
  auto* notes = window->findChild<QListWidget*>("noteList");
  ASSERT_TRUE(test::waitFor([&] { return notes->count() > 0; }));
  EXPECT_EQ(notes->item(0)->text(), "Nicht Teil eines Lebermodells: spleen.");
  language.use("en");
  EXPECT_TRUE(test::waitFor([&] { return notes->item(0)->text() == "Not part of a liver model: spleen."; }));
  ASSERT_TRUE(test::waitFor([&] { return jobs->idle(); }));
}

}  // namespace
}  // namespace glisson
