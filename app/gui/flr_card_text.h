#pragma once
// Purpose: the words of the FLR card, in the window's language: the same in the panel and in the report.

#include <QString>
#include <QStringList>

#include "planning/report/flr_card.h"

namespace glisson {

/// "FLR of SLV (Urata)".
QString flrRatioName(FlrRatioKind kind);
/// With its unit.
QString flrRatioText(FlrRatioKind kind, double value, int decimals);
/// "Kishi 2009: 20 %; Vauthey 2000: 25 %"; empty where no threshold is shown.
QString flrThresholdsText(const FlrRatio& ratio);
/// A sentence for each band of the tumour type.
QStringList marginBandTexts(const FlrCard& card);
/// "normal", ...: what the user chose for the card.
QString conditionText(LiverCondition condition);
QString tumourTypeText(TumourType type);

}  // namespace glisson
