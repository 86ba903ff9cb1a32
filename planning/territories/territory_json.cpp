#include "planning/territories/territory_json.h"

#include "reconstruction/json.h"

namespace glisson {

namespace {

std::string_view roleText(BranchRole role) {
  switch (role) {
    case BranchRole::Trunk:
      return "trunk";
    case BranchRole::Supplying:
      return "supplying";
    case BranchRole::Outside:
      break;
  }
  return "outside";
}

Json cutsOf(const std::vector<VesselCut>& cuts) {
  Json list = Json::array();
  for (const VesselCut& cut : cuts) {
    list.push_back({{"branch", cut.branch}, {"positionMm", vectorJson(cut.positionMm)}, {"diameterMm", 2 * cut.radiusMm}});
  }
  return list;
}

Json branchesOf(const VesselGraph& graph) {
  Json list = Json::array();
  for (std::size_t b = 0; b < graph.branches.size(); ++b) {
    const VesselBranch& branch = graph.branches[b];
    list.push_back({{"branch", b},
                    {"parent", branch.parent < 0 ? Json(nullptr) : Json(branch.parent)},
                    {"role", roleText(branch.role)},
                    {"lengthMm", branch.lengthMm},
                    {"meanRadiusMm", branch.meanRadiusMm},
                    {"minRadiusMm", branch.minRadiusMm},
                    {"downstreamInLiverMm", branch.inLiverMm},
                    {"fromMm", vectorJson(branch.lineMm.front())},
                    {"toMm", vectorJson(branch.lineMm.back())}});
  }
  return list;
}
}  // namespace

std::string toJson(const PlanAssessment& assessment, const TerritoryReport& report, const LiverPerfusion& perfusion) {
  Json json = Json::parse(toJson(assessment));
  Json estimates;
  estimates["territoriesFrom"] = textOf(report.territories.source);
  estimates["territoriesConfirmed"] = report.territories.confirmed;
  estimates["territories"] = Json::array();
  for (const TerritoryVolume& part : report.volumes) {
    estimates["territories"].push_back(
        {{"name", part.name}, {"volumeMl", part.volumeMl}, {"resectedMl", part.resectedMl}, {"remnantMl", part.remnantMl}});
  }
  estimates["tumours"] = Json::array();
  for (const TumourTerritories& tumour : report.tumours) {
    Json shares = Json::array();
    for (const TerritoryShare& share : tumour.shares) {
      shares.push_back({{"name", share.name}, {"volumeMl", share.volumeMl}, {"percent", share.percent}});
    }
    estimates["tumours"].push_back({{"id", tumour.id}, {"name", tumour.name}, {"territories", std::move(shares)}});
  }
  const bool known = report.effect.isKnown();
  estimates["devascularisedMl"] = orNull(report.effect.devascularisedMl);
  estimates["congestedMl"] = orNull(report.effect.congestedMl);
  estimates["devascularisedOrCongestedMl"] = known ? Json(report.effect.devascularisedOrCongestedMl) : Json(nullptr);
  estimates["perfusedFlrMl"] = known ? Json(report.effect.perfusedFlrMl) : Json(nullptr);
  estimates["perfusedFlrPercent"] = known ? Json(report.effect.perfusedFlrPercent) : Json(nullptr);
  estimates["portalCuts"] = cutsOf(report.effect.portalCuts);
  estimates["hepaticCuts"] = cutsOf(report.effect.hepaticCuts);
  const auto& node = perfusion.portal().mainBifurcation;
  const VesselGraph& portal = perfusion.portal();
  estimates["mainBifurcationMm"] =
      node ? vectorJson(portal.sites[static_cast<std::size_t>(portal.nodes[static_cast<std::size_t>(*node)].site)].positionMm)
           : Json(nullptr);
  estimates["portalBranches"] = branchesOf(portal);
  estimates["notes"] = report.notes;
  json["estimates"] = std::move(estimates);
  // A name that is no UTF-8 must not cost the numbers.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
