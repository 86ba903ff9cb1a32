
#include "planning/report/flr_card.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {
Json fromRatio(const FlrRatio& ratio) {
  Json thresholds = Json::array();
  for (const FlrThreshold& threshold : ratio.thresholds) {
    thresholds.push_back({{"value", threshold.value}, {"citation", threshold.citation}, {"condition", idOf(threshold.condition)}});
  }
  return {{"ratio", idOf(ratio.kind)}, {"value", ratio.value}, {"thresholds", thresholds}};
}
}  // namespace

std::string_view idOf(FlrRatioKind kind) {
  switch (kind) {
    case FlrRatioKind::OfSlvUrataPercent:
      return "flrOfSlvUrataPercent";
    case FlrRatioKind::OfSlvVautheyPercent:
      return "flrOfSlvVautheyPercent";
    case FlrRatioKind::PerBsaMlPerM2:
      return "flrPerBsaMlPerM2";
    case FlrRatioKind::PerBodyWeightPercent:
      return "flrPerBodyWeightPercent";
    case FlrRatioKind::OfFunctionalPercent:
      break;
  }
  return "flrOfFunctionalPercent";
}

std::string toJson(const FlrCard& card) {
  Json json;
  json["heightCm"] = orNull(card.facts.heightCm);
  json["weightKg"] = orNull(card.facts.weightKg);
  json["condition"] = card.facts.condition ? Json(idOf(*card.facts.condition)) : Json(nullptr);
  json["tumourType"] = card.facts.tumourType ? Json(idOf(*card.facts.tumourType)) : Json(nullptr);
  json["functionalMl"] = card.functionalMl;
  json["functionalRemnantMl"] = orNull(card.functionalRemnantMl);
  json["bsaMostellerM2"] = orNull(card.bsaMostellerM2);
  json["bsaDuBoisM2"] = orNull(card.bsaDuBoisM2);
  json["slvUrataMl"] = orNull(card.slvUrataMl);
  json["slvVautheyMl"] = orNull(card.slvVautheyMl);
  json["ratios"] = Json::array();
  for (const FlrRatio& ratio : card.ratios) {
    json["ratios"].push_back(fromRatio(ratio));
  }
  json["marginBands"] = Json::array();
  for (const MarginBand& band : card.marginBands) {
    json["marginBands"].push_back({{"marginMm", band.mm}, {"meaning", band.meaning}, {"citation", band.citation}});
  }
  json["reasons"] = card.reasons;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
