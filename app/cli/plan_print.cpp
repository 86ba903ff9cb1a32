#include "app/cli/plan_print.h"

#include <iostream>

#include "app/cli/table.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {
std::string millimetres(const std::optional<double>& value) { return value ? formatNumber(*value, 1) + " mm" : "-"; }
std::string millilitres(double value) { return formatNumber(value, 1) + " mL"; }

std::string at(const Vec3& p) {
  return "(" + formatNumber(p.x(), 1) + ", " + formatNumber(p.y(), 1) + ", " + formatNumber(p.z(), 1) + ") mm";
}

void printVessel(const VesselCrossing& vessel) {
  std::cout << "vessel crossed: " << vessel.name << " at " << at(vessel.positionMm) << ", diameter "
            << formatNumber(vessel.diameterMm, 1) << " mm" << (vessel.runsAlong ? ", runs along the cut" : "") << '\n';
}

std::string unitOf(FlrRatioKind kind) { return kind == FlrRatioKind::PerBsaMlPerM2 ? "mL/m2" : "%"; }

std::string_view wordsOf(FlrRatioKind kind) {
  switch (kind) {
    case FlrRatioKind::OfSlvUrataPercent:
      return "FLR of SLV (Urata)";
    case FlrRatioKind::OfSlvVautheyPercent:
      return "FLR of SLV (Vauthey)";
    case FlrRatioKind::PerBsaMlPerM2:
      return "FLR per body surface";
    case FlrRatioKind::PerBodyWeightPercent:
      return "FLR per body weight";
    case FlrRatioKind::OfFunctionalPercent:
      break;
  }
  return "FLR of functional volume";
}
}  // namespace

void print(const PlanAssessment& a) {
  if (!a.warning.empty()) {
    std::cout << "note: " << a.warning << '\n';
  }
  std::cout << "total: " << millilitres(a.totalMl) << ", tumour " << millilitres(a.tumourMl) << ", functional "
            << millilitres(a.functionalMl) << '\n';
  if (a.divides) {
    std::cout << "resected: " << millilitres(a.resectedMl) << ", remnant " << millilitres(a.remnantMl) << " (+- "
              << millilitres(a.volumeUncertaintyMl) << ")\n"
              << "functional remnant: " << millilitres(a.functionalRemnantMl) << ", FLR " << formatNumber(a.flrPercent, 1)
              << " %\n";
    for (const ResectionVolume& resection : a.resections) {
      std::cout << resection.name << ": " << millilitres(resection.volumeMl) << ", cut area "
                << formatNumber(resection.cutAreaMm2, 0) << " mm2\n";
    }
  }
  for (const IslandAssessment& island : a.islands) {
    std::cout << "island of the " << (island.side == PlanSide::Resected ? "resected side" : "remnant") << ": "
              << millilitres(island.volumeMl) << ", functional " << millilitres(island.functionalMl) << ", at " << at(island.point)
              << (island.assigned ? ", given to the other side" : "") << '\n';
  }
  if (!a.tumours.empty()) {
    std::vector<std::vector<std::string>> rows{{"tumour", "state", "margin", "at least", "distance"}};
    for (const TumourAssessment& tumour : a.tumours) {
      rows.push_back({tumour.id + " " + tumour.name, std::string(textOf(tumour.state)), millimetres(tumour.marginMm),
                      millimetres(tumour.marginAtLeastMm), millimetres(tumour.distanceMm)});
    }
    std::cout << alignedTable(rows) << kMarginNotice << '\n';
  }
  for (const VesselCrossing& vessel : a.vesselsCrossed) {
    printVessel(vessel);
  }
}

void printBends(const ResectionPlan& plan) {
  for (const Resection& resection : plan.resections) {
    for (std::size_t p = 0; p < resection.planes.size(); ++p) {
      if (const auto& bend = resection.planes[p].bend) {
        const Range heights = BendShape(*bend).heights();
        const std::string size = formatNumber(2 * bend->halfSizeMm, 0);
        std::cout << "plane " << p + 1 << " of " << resection.name << " is bent: control points from "
                  << formatNumber(heights.low, 1) << " to " << formatNumber(heights.high, 1) << " mm over " << size << " x " << size
                  << " mm\n";
      }
    }
  }
}

void print(const FlrCard& card) {
  if (card.slvUrataMl) {
    std::cout << "body surface: " << formatNumber(*card.bsaMostellerM2, 2) << " m2 (Mosteller), "
              << formatNumber(*card.bsaDuBoisM2, 2) << " m2 (DuBois)\n"
              << "standardised liver volume: " << millilitres(*card.slvUrataMl) << " (Urata), " << millilitres(*card.slvVautheyMl)
              << " (Vauthey)\n";
  }
  for (const FlrRatio& ratio : card.ratios) {
    const bool fine = ratio.kind == FlrRatioKind::PerBodyWeightPercent;
    std::cout << wordsOf(ratio.kind) << ": " << formatNumber(ratio.value, fine ? 2 : 1) << ' ' << unitOf(ratio.kind);
    for (const FlrThreshold& threshold : ratio.thresholds) {
      std::cout << "; " << threshold.citation << ": " << formatExact(threshold.value) << ' ' << unitOf(ratio.kind);
    }
    std::cout << '\n';
  }
  for (const MarginBand& band : card.marginBands) {
    std::cout << "margin of " << formatExact(band.mm) << " mm: " << band.meaning << " (" << band.citation << ")\n";
  }
  for (const std::string& reason : card.reasons) {
    std::cout << "note: " << reason << '\n';
  }
  std::cout << "thresholds and margins: information with its source, not advice\n";
}

void print(const std::vector<TumourMeasures>& measures) {
  if (measures.empty()) {
    return;
  }
  std::vector<std::vector<std::string>> rows{{"tumour", "nearest vessel", "volume", "diameter", "to vessel", "to capsule"}};
  for (const TumourMeasures& m : measures) {
    rows.push_back({m.id + " " + m.name, m.vesselMm ? m.nearestVessel : "-", formatNumber(m.volumeMl, 2) + " mL",
                    millimetres(m.longestDiameterMm), millimetres(m.vesselMm),
                    (m.capsuleBeyondImage ? ">= " : "") + millimetres(m.capsuleMm)});
  }
  std::cout << alignedTable(rows);
}

void print(const std::vector<Measure>& measures) {
  for (const Measure& measure : measures) {
    std::cout << measure.name << ": " << millimetres(measure.mm()) << " from " << at(measure.from) << " to " << at(measure.to)
              << '\n';
  }
}

void print(const MarginProposal& proposal) {
  if (!proposal.plane) {
    std::cout << "margin plane: none\nnote: " << proposal.reason << '\n';
    return;
  }
  const Vec3& n = proposal.plane->normal;
  std::cout << "margin plane around " << proposal.tumourName << ": through " << at(proposal.plane->origin) << ", normal ("
            << formatNumber(n.x(), 4) << ", " << formatNumber(n.y(), 4) << ", " << formatNumber(n.z(), 4) << "), margin "
            << millimetres(proposal.marginMm) << ", at least " << millimetres(proposal.marginAtLeastMm) << ", functional volume "
            << millilitres(proposal.resectedFunctionalMl) << "\nnote: " << proposal.notice << "\nvessels of "
            << formatExact(kListedVesselMm) << " mm and more that it crosses: " << proposal.vessels.size() << '\n';
  for (const VesselCrossing& vessel : proposal.vessels) {
    printVessel(vessel);
  }
}

void print(const PlanComparison& comparison, const std::vector<std::string>& differences) {
  std::vector<std::vector<std::string>> rows{{"", ""}};
  for (const std::string& name : comparison.names) {
    rows[0].push_back(name);
  }
  for (const ComparedRow& row : comparison.rows) {
    std::vector<std::string> cells{std::string(row.id), ""};
    for (std::size_t n = 0; n < row.values.size(); ++n) {
      const char* mark = row.smallest[n] ? " min" : row.largest[n] ? " max" : "    ";
      cells.push_back((row.values[n] ? formatNumber(*row.values[n], 1) : "-") + mark);
    }
    rows.push_back(std::move(cells));
  }
  std::cout << alignedTable(rows);
  for (const std::string& sentence : differences) {
    std::cout << sentence << '\n';
  }
}

}  // namespace glisson::cli
