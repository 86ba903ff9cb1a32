#include "app/gui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>

namespace glisson {

Language::Language(QObject* parent) : QObject(parent) {}

void Language::use(const QString& code) {
  code_ = code == QLatin1String("de") ? QStringLiteral("de") : QStringLiteral("en");
  // the locale first: the texts that are set on LanguageChange hold numbers
  QLocale locale(code_ == QLatin1String("de") ? QLocale::German : QLocale::English);
  locale.setNumberOptions(QLocale::DefaultNumberOptions);
  QLocale::setDefault(locale);
  QCoreApplication::removeTranslator(&glisson_);
  QCoreApplication::removeTranslator(&qt_);
  if (qt_.load("qtbase_" + code_, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(&qt_);
  }
  if (glisson_.load("glisson_" + code_, ":/i18n")) {
    QCoreApplication::installTranslator(&glisson_);
  } else {
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
  }
}

QString Language::preferred() {
  const QString system = QLocale::system().name().left(2);
  return QSettings().value("language", system == QLatin1String("de") ? "de" : "en").toString();
}

}  // namespace glisson
