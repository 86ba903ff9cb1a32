// The program glisson from outside: exit codes, one line on stderr, the picture.

#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <set>

#include "tests/support/paths.h"

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
       {QStringList{"--size", "big", "x.glisson"}, QStringList{"--screenshot", "x.png"}, QStringList{"--no-such-flag"},
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

TEST(ProgramTest, TheSamplePatientsPictureShowsTheWholeWindowWithTheModel) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("out.png");
  const Ended ended = glisson({"--sample", "--screenshot", path, "--size", "1100x720", "--lang", "en"});
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

}  // namespace
