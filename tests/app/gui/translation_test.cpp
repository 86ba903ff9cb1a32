// The languages are complete: every text of the sources is in the .ts file and finished, and keeps its placeholders.

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <set>

#include "tests/support/paths.h"

namespace {

struct Message {
  QString context;
  QString source;
  QString translation;
  QString type;
};

std::vector<Message> messagesOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) {
      continue;
    }
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QLatin1String("source")) {
      messages.push_back({context, xml.readElementText(), {}, {}});
    } else if (xml.name() == QLatin1String("translation")) {
      messages.back().type = xml.attributes().value("type").toString();
      messages.back().translation = xml.readElementText();
    }
  }
  return messages;
}

std::set<QString> placeholders(const QString& text) {
  static const QRegularExpression kPattern("%\\d|%n");
  std::set<QString> found;
  auto matches = kPattern.globalMatch(text);
  while (matches.hasNext()) {
    found.insert(matches.next().captured());
  }
  return found;
}

const QString kGerman = QString::fromStdString(glisson::test::sourceFolder() + "/translations/glisson_de.ts");

TEST(TranslationTest, EveryTextIsFinishedAndKeepsItsPlaceholders) {
  const std::vector<Message> messages = messagesOf(kGerman);
  ASSERT_GT(messages.size(), 200U);
  for (const Message& message : messages) {
    EXPECT_TRUE(message.type.isEmpty()) << message.type.toStdString() << ": " << message.source.toStdString();
    EXPECT_FALSE(message.translation.isEmpty()) << message.source.toStdString();
    EXPECT_EQ(placeholders(message.source), placeholders(message.translation)) << message.source.toStdString();
  }
}

TEST(TranslationTest, EveryTextOfTheSourcesIsInTheFile) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath("glisson_de.ts");
  ASSERT_TRUE(QFile::copy(kGerman, copy));
  QProcess lupdate;
  lupdate.setWorkingDirectory(QString::fromStdString(glisson::test::sourceFolder()));
  lupdate.start(GLISSON_LUPDATE, {"-silent", "-I", ".", "-no-obsolete", "-locations", "none", "-source-language", "en",
                                  "-target-language", "de", "app", "viewer", "-ts", copy});
  ASSERT_TRUE(lupdate.waitForFinished(120000));
  ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
  std::set<std::pair<QString, QString>> known;
  for (const Message& message : messagesOf(kGerman)) {
    known.emplace(message.context, message.source);
  }
  for (const Message& message : messagesOf(copy)) {
    EXPECT_TRUE(known.contains({message.context, message.source}))
        << message.context.toStdString() << ": " << message.source.toStdString();
  }
}

}  // namespace
