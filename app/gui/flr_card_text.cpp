#include "app/gui/flr_card_text.h"

#include <QCoreApplication>

#include "app/gui/number_text.h"
#include "app/gui/sentences.h"

namespace glisson {

namespace {

class CardText {
  Q_DECLARE_TR_FUNCTIONS(glisson::FlrCardBox)
};

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

}  // namespace

QString flrRatioName(FlrRatioKind kind) {
  switch (kind) {
    case FlrRatioKind::OfFunctionalPercent:
      return CardText::tr("FLR of the functional liver");
    case FlrRatioKind::OfSlvUrataPercent:
      return CardText::tr("FLR of SLV (Urata)");
    case FlrRatioKind::OfSlvVautheyPercent:
      return CardText::tr("FLR of SLV (Vauthey)");
    case FlrRatioKind::PerBsaMlPerM2:
      return CardText::tr("FLR per body surface");
    case FlrRatioKind::PerBodyWeightPercent:
      break;
  }
  return CardText::tr("FLR of the body weight");
}

QString flrRatioText(FlrRatioKind kind, double value, int decimals) {
  if (kind == FlrRatioKind::PerBsaMlPerM2) {
    return numberText(value, 0) + QStringLiteral("\u00A0mL/m\u00B2");
  }
  return percentText(value, kind == FlrRatioKind::PerBodyWeightPercent ? std::max(decimals, 1) : decimals);
}

QString flrThresholdsText(const FlrRatio& ratio) {
  QStringList published;
  for (const FlrThreshold& threshold : ratio.thresholds) {
    published << textOf(threshold.citation) + QStringLiteral(": ") + flrRatioText(ratio.kind, threshold.value, 0);
  }
  return published.join(QStringLiteral("; "));
}

QStringList marginBandTexts(const FlrCard& card) {
  QStringList texts;
  for (const MarginBand& band : card.marginBands) {
    texts << CardText::tr("Margin %1: %2 (%3)")
                 .arg(mmText(band.mm, 0), shownSentence(std::string(band.meaning)), textOf(band.citation));
  }
  return texts;
}

QString conditionText(LiverCondition condition) {
  switch (condition) {
    case LiverCondition::Normal:
      return CardText::tr("normal");
    case LiverCondition::LongChemotherapy:
      return CardText::tr("over 3 months of chemotherapy");
    case LiverCondition::Injured:
      break;
  }
  return CardText::tr("injured");
}

QString tumourTypeText(TumourType type) {
  return type == TumourType::ColorectalMetastases ? CardText::tr("colorectal metastases")
                                                  : CardText::tr("hepatocellular carcinoma");
}

}  // namespace glisson
