#pragma once
// Purpose: the language of the window, changed at run time: translators for Glisson and Qt, and the locale of numbers and dates.

#include <QObject>
#include <QString>
#include <QTranslator>

namespace glisson {

class Language : public QObject {
  Q_OBJECT
 public:
  explicit Language(QObject* parent = nullptr);
  /// "en" or "de"; others mean English. Every widget gets a LanguageChange.
  void use(const QString& code);
  [[nodiscard]] QString code() const { return code_; }
  /// The one remembered, else the system's where there is a translation, else English.
  static QString preferred();

 private:
  QString code_;
  QTranslator glisson_;
  QTranslator qt_;
};

}  // namespace glisson
