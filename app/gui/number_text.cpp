#include "app/gui/number_text.h"

#include <QDate>
#include <QLocale>
#include <cmath>

namespace glisson {

QString numberText(double value, int decimals) {
  if (!std::isfinite(value)) {
    return QStringLiteral("-");
  }
  const QString text = QLocale().toString(value, 'f', decimals);
  const QString zero = QLocale().toString(0.0, 'f', decimals);
  return text == QLocale().negativeSign() + zero ? zero : text;  // "-0.0" says nothing
}

QString mlText(double ml, int decimals) { return numberText(ml, decimals) + QStringLiteral("\u00A0mL"); }

QString mmText(double mm, int decimals) { return numberText(mm, decimals) + QStringLiteral("\u00A0mm"); }

QString areaText(double mm2) { return numberText(mm2 / 100, 1) + QStringLiteral("\u00A0cm\u00B2"); }

QString percentText(double percent, int decimals) { return numberText(percent, decimals) + QStringLiteral("\u00A0%"); }

QString dateText(const std::string& yyyymmdd) {
  QString text = QString::fromStdString(yyyymmdd);
  const QDate date = QDate::fromString(text, QStringLiteral("yyyyMMdd"));
  if (!date.isValid()) {
    return text;
  }
  // 1/2/20 is read as two different days: English gets the order nobody mistakes
  return QLocale().language() == QLocale::German ? date.toString(QStringLiteral("dd.MM.yyyy")) : date.toString(Qt::ISODate);
}

}  // namespace glisson
