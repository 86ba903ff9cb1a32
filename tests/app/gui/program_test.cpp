// The program glisson from outside: exit codes, one line on stderr, the picture.

#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <set>

#include "pdf_text.h"
#include "tests/support/paths.h"
#include "tests/support/real_data.h"
#include "tests/support/run_program.h"

namespace {

struct Ended {
  int code = -1;
  QString err;
};

Ended glisson(const QStringList& arguments) {
  const QTemporaryDir home;  // settings and recovery files of its own
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("HOME", home.path());
  environment.insert("XDG_RUNTIME_DIR", home.path());
  environment.insert("XDG_CONFIG_HOME", home.path() + "/config");
  environment.insert("XDG_DATA_HOME", home.path() + "/data");
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(QString::fromStdString(glisson::test::programFolder() + "/glisson"), arguments);
  if (!process.waitForFinished(180000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  QStringList lines;
  for (const QString& line : QString::fromUtf8(process.readAllStandardError()).split('\n', Qt::SkipEmptyParts)) {
    if (!line.startsWith("QStandardPaths")) {
      lines << line;
    }
  }
  return {process.exitCode(), lines.join('\n')};
}

TEST(ProgramTest, WrongUsageEndsWithTwoAndOneLine) {
  for (const QStringList& wrong :
       {QStringList{"--size", "big", "x.glisson"}, QStringList{"--screenshot", "x.png"}, QStringList{"--pdf", "x.pdf"},
        QStringList{"--sample", "--identity"}, QStringList{"--sample", "--plan", "B"}, QStringList{"--no-such-flag"},
        QStringList{"--sample", "x.glisson"}, QStringList{"--lang", "xx"}}) {
    const Ended ended = glisson(wrong);
    EXPECT_EQ(ended.code, 2) << wrong.join(' ').toStdString();
    EXPECT_EQ(ended.err.count('\n'), 0) << ended.err.toStdString();
    EXPECT_FALSE(ended.err.isEmpty());
  }
}

TEST(ProgramTest, AMissingInputEndsAScreenshotWithThreeAndItsName_H9) {
  const QTemporaryDir folder;
  const Ended ended = glisson({folder.filePath("missing.nii"), "--screenshot", folder.filePath("out.png")});
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(ended.err.contains("missing.nii")) << ended.err.toStdString();
  EXPECT_EQ(ended.err.count('\n'), 0);
  EXPECT_FALSE(QFile::exists(folder.filePath("out.png")));
}

/// The number before " mL" in the line of the report that begins with `name`.
double millilitres(const QString& text, const QString& name) {
  const QRegularExpressionMatch match =
      QRegularExpression("^\\s*" + QRegularExpression::escape(name) + "\\s+([\\d,.]+).mL", QRegularExpression::MultilineOption)
          .match(text);
  EXPECT_TRUE(match.hasMatch()) << name.toStdString() << "\n" << text.toStdString();
  return match.captured(1).remove(',').toDouble();
}

void expectReport(const QString& path) {
  const QString text = glisson::test::pdfText(path);
  EXPECT_NEAR(millilitres(text, "Resected") + millilitres(text, "Remnant"), millilitres(text, "Liver, tumours in it included"),
              0.11);
  for (const char* part : {"Resection plan: Plan 1", "tumour 2", "Vessels crossed", "PSR d=7", "Planes", "SHA-256",
                           "registration error not included", "Not accepted by anybody: ", "accepted by", "page 1 of"}) {
    EXPECT_TRUE(text.simplified().contains(part)) << part << "\n" << text.toStdString();
  }
  const auto pages = text.count("page ");
  EXPECT_EQ(text.count("not for clinical use"), pages);
  EXPECT_TRUE(QRegularExpression("\\btumour 2 +[0-9a-f]{64}\\b").match(text).hasMatch()) << text.toStdString();
  EXPECT_FALSE(text.contains("Glisson, Sample")) << "the person is not named by default";
}

TEST(ProgramTest, TheReportSpeaksTheWindowsLanguage) {
  const QTemporaryDir folder;
  const QString report = folder.filePath("de.pdf");
  const Ended ended = glisson({"--sample", "--pdf", report, "--lang", "de"});
  ASSERT_EQ(ended.code, 0) << ended.err.toStdString();
  const QString text = glisson::test::pdfText(report);
  for (const char* english : {"Remnant", "Vessels crossed", "safety margin", "clinical use", "Structures", "removed"}) {
    EXPECT_FALSE(text.contains(english, Qt::CaseInsensitive)) << english << "\n" << text.toStdString();
  }
  EXPECT_TRUE(text.contains("Sicherheitsabstand")) << text.toStdString();
}

TEST(ProgramTest, TheReportNamesThePatientOnlyWhenAsked_H8) {
  const QTemporaryDir folder;
  const QString report = folder.filePath("named.pdf");
  const Ended ended = glisson({"--sample", "--pdf", report, "--identity", "--lang", "en"});
  ASSERT_EQ(ended.code, 0) << ended.err.toStdString();
  const QString text = glisson::test::pdfText(report);
  EXPECT_TRUE(text.contains("Glisson, Sample")) << text.toStdString();
  EXPECT_TRUE(QRegularExpression("\\bid \\S").match(text).hasMatch()) << text.toStdString();
}

TEST(ProgramTest, TheReportIsOfThePlanThatIsNamedWithConfirmedTerritoriesAndSaysWhenItWasWritten) {
  const glisson::test::TemporaryFolder folder;
  const std::string file = folder / "case.glisson";
  const auto cli = [](const std::vector<std::string>& arguments) {
    const glisson::test::Finished finished = glisson::test::runProgram("glisson-cli", arguments);
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
  };
  cli({"sample", folder / "sample"});
  cli({"model", folder / "sample/segmentation.seg.nrrd", "-o", file});
  cli({"plan", file, "--plane", "-10,-40,-1170,1,0,0"});
  cli({"plan", file, "--duplicate", "B", "--margin", "4", "--territories", "--confirm-territories"});
  const QString report = QString::fromStdString(folder / "b.pdf");
  const Ended ended = glisson({QString::fromStdString(file), "--pdf", report, "--plan", "B", "--lang", "en"});
  ASSERT_EQ(ended.code, 0) << ended.err.toStdString();
  const QString text = glisson::test::pdfText(report).simplified();
  for (const char* part : {"Resection plan: B", "safety margin 4.0", "Territories and the remnant's blood", "model revision",
                           "transection are not included"}) {
    EXPECT_TRUE(text.contains(part)) << part << "\n" << text.toStdString();
  }
  EXPECT_TRUE(QRegularExpression("Written 20\\d\\d-\\d\\d-\\d\\d \\d\\d:\\d\\d UTC; case G-").match(text).hasMatch())
      << text.toStdString();
  EXPECT_FALSE(text.contains("nobody has confirmed them"));
  const QString none = QString::fromStdString(folder / "none.pdf");
  const Ended missing = glisson({QString::fromStdString(file), "--pdf", none, "--plan", "C", "--lang", "en"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(missing.err.contains("no plan \"C\"; it has: Plan 1, B")) << missing.err.toStdString();
  EXPECT_FALSE(QFile::exists(none));
}

TEST(ProgramTest, TheSamplePatientsPictureShowsTheWholeWindowWithTheModelAndItsReportItsNumbers) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("out.png");
  const QString report = folder.filePath("out.pdf");
  const Ended ended = glisson({"--sample", "--screenshot", path, "--pdf", report, "--size", "1100x720", "--lang", "en"});
  expectReport(report);
  ASSERT_EQ(ended.code, 0) << ended.err.toStdString();
  const QImage picture(path);
  EXPECT_EQ(picture.size(), QSize(1100, 720));
  // the model: the 3D view is upper right of the middle; it holds far more colours than an empty view
  std::set<QRgb> colours;
  for (int y = 120; y < 350; ++y) {
    for (int x = 500; x < 780; ++x) {
      colours.insert(picture.pixel(x, y));
    }
  }
  EXPECT_GT(colours.size(), 1000U);
}

TEST(ProgramTest, TheRealPatientsMasksBecomeTheWholeModelInTheWindow) {
  const auto masks = glisson::test::unpackedIrcadb01Masks();
  if (!masks) {
    GTEST_SKIP() << "skipped: no real data";
  }
  const QTemporaryDir folder;
  const Ended ended = glisson({QString::fromStdString((masks->path() / "MASKS_DICOM").string()), "--screenshot",
                               folder.filePath("out.png"), "--pdf", folder.filePath("out.pdf")});
  ASSERT_EQ(ended.code, 0) << ended.err.toStdString();
  EXPECT_FALSE(QImage(folder.filePath("out.png")).isNull());
  const QString text = glisson::test::pdfText(folder.filePath("out.pdf"));
  EXPECT_NEAR(millilitres(text, "Liver, tumours in it included"), 1488.8, 0.1);
  EXPECT_EQ(text.count("MCSD sinc 10"), 11) << text.toStdString();
  EXPECT_EQ(text.count("PSR d=7 unbiased"), 1);
}

}  // namespace
