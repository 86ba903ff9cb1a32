
#include "planning/volumetry/assessment.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {}  // namespace

std::string_view textOf(TumourState state) {
  switch (state) {
    case TumourState::Removed:
      return "removed";
    case TumourState::Cut:
      return "cut";
    case TumourState::Left:
      break;
  }
  return "left";
}

std::string_view textOf(PlanSide side) { return side == PlanSide::Resected ? "resected" : "remnant"; }

std::string toJson(const PlanAssessment& assessment) {
  Json json;
  json["totalMl"] = assessment.totalMl;
  json["tumourMl"] = assessment.tumourMl;
  json["functionalMl"] = assessment.functionalMl;
  // A surface that does not divide the liver gives no volumes.
  const auto known = [&](double value) { return assessment.divides ? Json(value) : Json(nullptr); };
  json["resectedMl"] = known(assessment.resectedMl);
  json["remnantMl"] = known(assessment.remnantMl);
  json["volumeUncertaintyMl"] = known(assessment.volumeUncertaintyMl);
  json["functionalRemnantMl"] = known(assessment.functionalRemnantMl);
  json["flrPercent"] = known(assessment.flrPercent);
  json["resections"] = Json::array();
  for (const ResectionVolume& resection : assessment.resections) {
    json["resections"].push_back(
        {{"name", resection.name}, {"volumeMl", known(resection.volumeMl)}, {"cutAreaMm2", resection.cutAreaMm2}});
  }
  json["islands"] = Json::array();
  for (const IslandAssessment& island : assessment.islands) {
    const Vec3& p = island.point;
    json["islands"].push_back({{"side", textOf(island.side)},
                               {"assigned", island.assigned},
                               {"volumeMl", island.volumeMl},
                               {"functionalMl", island.functionalMl},
                               {"pointMm", {p[0], p[1], p[2]}}});
  }
  json["tumours"] = Json::array();
  for (const TumourAssessment& tumour : assessment.tumours) {
    json["tumours"].push_back({{"name", tumour.name},
                               {"kind", tumour.isCyst ? "cyst" : "tumour"},
                               {"state", textOf(tumour.state)},
                               {"marginMm", orNull(tumour.marginMm)},
                               {"marginAtLeastMm", orNull(tumour.marginAtLeastMm)},
                               {"distanceMm", orNull(tumour.distanceMm)}});
  }
  json["vesselsCrossed"] = Json::array();
  for (const VesselCrossing& crossing : assessment.vesselsCrossed) {
    const Vec3& p = crossing.positionMm;
    json["vesselsCrossed"].push_back({{"name", crossing.name},
                                      {"positionMm", {p[0], p[1], p[2]}},
                                      {"diameterMm", crossing.diameterMm},
                                      {"runsAlongCut", crossing.runsAlong}});
  }
  // A name that is no UTF-8 must not cost the numbers.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
