
#include "planning/volumetry/margin_plane.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {}  // namespace

std::string toJson(const MarginProposal& proposal) {
  const bool found = proposal.plane.has_value();
  const auto known = [&](double value) { return found ? Json(value) : Json(nullptr); };
  Json json;
  json["tumour"] = proposal.tumourId;
  json["name"] = proposal.tumourName;
  json["safetyMarginMm"] = proposal.safetyMarginMm;
  json["plane"] = found ? Json{{"originMm", vectorJson(proposal.plane->origin)}, {"normal", vectorJson(proposal.plane->normal)}}
                        : Json(nullptr);
  json["resectedFunctionalMl"] = known(proposal.resectedFunctionalMl);
  json["marginMm"] = known(proposal.marginMm);
  json["marginAtLeastMm"] = known(proposal.marginAtLeastMm);
  json["vesselsCrossed"] = Json::array();
  for (const VesselCrossing& crossing : proposal.vessels) {
    json["vesselsCrossed"].push_back({{"name", crossing.name},
                                      {"positionMm", vectorJson(crossing.positionMm)},
                                      {"diameterMm", crossing.diameterMm},
                                      {"runsAlongCut", crossing.runsAlong}});
  }
  json["reason"] = proposal.reason.empty() ? Json(nullptr) : Json(proposal.reason);
  json["notice"] = proposal.notice;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
