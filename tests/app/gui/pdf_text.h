#pragma once
// What Poppler's programs read in a PDF.

#include <gtest/gtest.h>

#include <QProcess>

namespace glisson::test {

inline QString outputOf(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  EXPECT_TRUE(process.waitForFinished()) << program.toStdString() << " is missing";
  EXPECT_EQ(process.exitCode(), 0);
  return QString::fromUtf8(process.readAllStandardOutput());
}

/// What can be selected, in lines as they are seen.
inline QString pdfText(const QString& path) { return outputOf("pdftotext", {"-layout", path, "-"}); }

}  // namespace glisson::test
