#include "app/cli/plan_territories.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "app/cli/table.h"
#include "planning/territories/marked_branches.h"
#include "planning/territories/segment_map.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {
constexpr double kListedShare = 0.05;  ///< of the trunk's length in the liver: smaller branches are in the JSON only

/// NAME=BRANCH,BRANCH
TerritoryPick pickOf(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--territory takes NAME=BRANCH,BRANCH, not \"" + text + "\"");
  }
  TerritoryPick pick;
  pick.name = text.substr(0, equals);
  if (pick.name == kNotPicked) {
    throw UsageError("--territory " + text + ": \"not picked\" is what the branches without a name are called; give another name");
  }
  std::istringstream parts(text.substr(equals + 1));
  for (std::string part; std::getline(parts, part, ',');) {
    const auto number = parseInteger(part);
    if (!number || *number < 0 || *number != static_cast<std::int32_t>(*number)) {
      throw UsageError("--territory " + text + ": \"" + part + "\" is no number of a branch");
    }
    pick.branches.push_back(static_cast<std::int32_t>(*number));
  }
  if (pick.branches.empty()) {
    throw UsageError("--territory " + text + " names no branch");
  }
  return pick;
}

TerritoryChoice choiceOf(const TerritoryFlags& flags, const TerritoryMarks& marks, const VesselGraph& portal) {
  TerritoryChoice choice;
  if (flags.picks.empty() && !flags.confirm) {
    return glisson::choiceOf(marks, portal);
  }
  if (flags.picks.empty()) {
    choice = proposeLeftRight(portal);
    choice.confirmed = !choice.picks.empty();
    return choice;
  }
  for (const std::string& text : flags.picks) {
    choice.picks.push_back(pickOf(text));
  }
  choice.confirmed = true;
  return choice;
}

std::string ml(double value) { return formatNumber(value, 1) + " mL"; }
std::string mlOrUnknown(const std::optional<double>& value) { return value ? ml(*value) : "not known"; }

void printCuts(const char* vessel, const std::vector<VesselCut>& cuts) {
  for (const VesselCut& cut : cuts) {
    std::cout << vessel << " branch " << cut.branch << " cut at (" << formatNumber(cut.positionMm.x(), 1) << ", "
              << formatNumber(cut.positionMm.y(), 1) << ", " << formatNumber(cut.positionMm.z(), 1) << ") mm, diameter "
              << formatNumber(2 * cut.radiusMm, 1) << " mm\n";
  }
}

void printTumours(const std::vector<TumourTerritories>& tumours) {
  for (const TumourTerritories& tumour : tumours) {
    std::string parts;
    for (const TerritoryShare& share : tumour.shares) {
      parts += (parts.empty() ? "" : ", ") + share.name + " " + ml(share.volumeMl) + " (" + formatNumber(share.percent, 0) + " %)";
    }
    std::cout << tumour.id << ' ' << tumour.name << " lies in (estimate): " << (parts.empty() ? "none of them" : parts) << '\n';
  }
}

void printBranches(const VesselGraph& portal) {
  std::vector<std::vector<std::string>> rows{
      {"portal branch", "behind", "role", "length", "diameter", "in the liver, with all behind it"}};
  const double whole = portal.empty() ? 0.0 : portal.branches.front().inLiverMm;
  for (std::size_t b = 0; b < portal.branches.size(); ++b) {
    const VesselBranch& branch = portal.branches[b];
    if (branch.role == BranchRole::Supplying && branch.inLiverMm >= kListedShare * whole) {
      rows.push_back({std::to_string(b), branch.parent < 0 ? "-" : std::to_string(branch.parent), "supplies",
                      formatNumber(branch.lengthMm, 1) + " mm", formatNumber(2 * branch.meanRadiusMm, 1) + " mm",
                      formatNumber(100 * branch.inLiverMm / whole, 1) + " %"});
    }
  }
  if (rows.size() > 1) {
    std::cout << alignedTable(rows);
  }
}
}  // namespace

void addTerritoryFlags(CLI::App& command, TerritoryFlags& flags) {
  command.add_flag("--territories", flags.wanted,
                   "Estimates: territories of the portal branches (left and right proposed), devascularised and congested remnant");
  command.add_flag("--confirm-territories", flags.confirm,
                   "You have looked at the proposed left and right and found them right; the case keeps it");
  command
      .add_option("--territory", flags.picks,
                  "NAME=BRANCH,BRANCH: branches that make a territory, with all behind them; repeatable; the case keeps them")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--segments", flags.segments,
                     "A map of liver segments 1 to 8, instead of branches; the case keeps where it lies");
  addInputFlags(command, flags.input);
}

void checkTerritoryFlags(const TerritoryFlags& flags) {
  if (!flags.wanted && (flags.confirm || !flags.picks.empty() || !flags.segments.empty())) {
    throw UsageError("--confirm-territories, --territory and --segments belong to --territories");
  }
  if (static_cast<int>(flags.confirm) + static_cast<int>(!flags.picks.empty()) + static_cast<int>(!flags.segments.empty()) > 1) {
    throw UsageError("--confirm-territories, --territory and --segments exclude each other");
  }
  for (const std::string& text : flags.picks) {
    (void)pickOf(text);
  }
}

TerritoryCommand::TerritoryCommand(const Case& source, const TerritoryFlags& flags, const ExecutionContext& context)
    : perfusion_(source, context.range(0, 0.8)), marks_(source.territories), notes_(perfusion_.notes()) {
  if (!flags.segments.empty()) {
    territories_ = segmentTerritories(source, flags.segments, readOptions(flags.input), context.range(0.8, 1.0));
    marks_ = {.marks = {}, .segments = segmentMapFile(flags.segments, territories_)};
  } else {
    const TerritoryChoice choice = choiceOf(flags, source.territories, perfusion_.portal());
    territories_ = territoriesOf(source, perfusion_.portal(), choice, context.range(0.8, 1.0));
    if (!choice.picks.empty() && (flags.confirm || !flags.picks.empty())) {
      marks_ = marksOf(choice, perfusion_.portal());
    }
  }
  notes_.insert(notes_.end(), territories_.notes.begin(), territories_.notes.end());
  tumours_ = tumourTerritories(source, territories_);
}

std::string TerritoryCommand::editName() const {
  if (marks_.segments) {
    return "choose map of segments";
  }
  return marks_.proposed ? "confirm territories" : "pick territory";
}

TerritoryReport TerritoryCommand::report(const ResectionPlan& plan) const {
  return {territories_, volumesOf(territories_, plan), perfusion_.effectOf(plan), notes_, tumours_};
}

void TerritoryCommand::printText(const TerritoryReport& report) const {
  for (const std::string& note : report.notes) {
    std::cout << "note: " << note << '\n';
  }
  if (report.territories.source != TerritorySource::Segments) {
    printBranches(perfusion_.portal());
  }
  if (!report.volumes.empty()) {
    std::vector<std::vector<std::string>> rows{{"territory (estimate)", "volume", "resected", "remnant"}};
    for (const TerritoryVolume& part : report.volumes) {
      rows.push_back({part.name, ml(part.volumeMl), ml(part.resectedMl), ml(part.remnantMl)});
    }
    std::cout << alignedTable(rows);
    printTumours(report.tumours);
    if (!report.territories.confirmed) {
      std::cout << "left and right are proposed from the main bifurcation: look at them, then give --confirm-territories\n";
    }
  }
  const PerfusionEstimate& effect = report.effect;
  std::cout << "estimated remnant without inflow: devascularised " << mlOrUnknown(effect.devascularisedMl)
            << ", without outflow: congested " << mlOrUnknown(effect.congestedMl);
  if (effect.isKnown()) {
    std::cout << ", either: " << ml(effect.devascularisedOrCongestedMl)
              << "\nestimated functional remnant without them: " << ml(effect.perfusedFlrMl) << ", FLR "
              << formatNumber(effect.perfusedFlrPercent, 1) << " %";
  }
  std::cout << '\n';
  printCuts("portal", report.effect.portalCuts);
  printCuts("hepatic", report.effect.hepaticCuts);
}

}  // namespace glisson::cli
