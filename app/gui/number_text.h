#pragma once
// Purpose: numbers as the user reads them, with the decimal sign of the chosen language (QLocale's default).

#include <QString>

namespace glisson {

/// "1,012.5"; never an exponent. Non-finite: a dash.
QString numberText(double value, int decimals);
QString mlText(double ml, int decimals = 0);            ///< "1,012 mL"
QString mmText(double mm, int decimals = 1);            ///< "7.8 mm"
QString areaText(double mm2);                           ///< from mm^2: "84.3 cm^2"
QString percentText(double percent, int decimals = 0);  ///< "73 %"
/// "20200131" as 31.01.2020 in German, as 2020-01-31 else; other texts unchanged.
QString dateText(const std::string& yyyymmdd);

}  // namespace glisson
