#include <array>
#include <iostream>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/plan_territories.h"
#include "app/cli/table.h"
#include "planning/storage/case_file.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct Flags {
  std::string caseFile;
  std::vector<std::string> planes;
  std::string plan;
  bool json = false;
  TerritoryFlags territories;
};

/// ox,oy,oz,nx,ny,nz: a point of the plane (mm LPS) and the direction to the resected side.
HalfSpace planeOf(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto number = parseNumber(part);
    if (!number) {
      throw UsageError("--plane " + text + ": \"" + part + "\" is no number");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != 6) {
    throw UsageError("--plane takes six numbers ox,oy,oz,nx,ny,nz, not \"" + text + "\"");
  }
  const Vec3 normal(numbers[3], numbers[4], numbers[5]);
  if (!(normal.norm() > 0)) {
    throw UsageError("--plane " + text + ": the normal has no length");
  }
  return {Vec3(numbers[0], numbers[1], numbers[2]), normal.normalized()};
}

std::size_t planIndex(const std::vector<ResectionPlan>& plans, const std::string& name, const std::string& file) {
  if (name.empty() && !plans.empty()) {
    return 0;
  }
  std::string names;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (plans[i].name == name) {
      return i;
    }
    names += (names.empty() ? "" : ", ") + plans[i].name;
  }
  throw UsageError("--plan " + name + " is not in " + file + "; it holds: " + names);
}

std::string millimetres(const std::optional<double>& value) { return value ? formatNumber(*value, 1) + " mm" : "-"; }

void printText(const PlanAssessment& a) {
  const auto ml = [](double value) { return formatNumber(value, 1) + " mL"; };
  if (!a.warning.empty()) {
    std::cout << "note: " << a.warning << '\n';
  }
  std::cout << "total: " << ml(a.totalMl) << ", tumour " << ml(a.tumourMl) << ", functional " << ml(a.functionalMl) << '\n'
            << "resected: " << ml(a.resectedMl) << ", remnant " << ml(a.remnantMl) << " (+- " << ml(a.volumeUncertaintyMl) << ")\n"
            << "functional remnant: " << ml(a.functionalRemnantMl) << ", FLR " << formatNumber(a.flrPercent, 1) << " %\n";
  for (const ResectionVolume& resection : a.resections) {
    std::cout << resection.name << ": " << ml(resection.volumeMl) << ", cut area " << formatNumber(resection.cutAreaMm2, 0)
              << " mm2\n";
  }
  if (!a.tumours.empty()) {
    std::vector<std::vector<std::string>> rows{{"tumour", "state", "margin", "at least", "distance"}};
    for (const TumourAssessment& tumour : a.tumours) {
      rows.push_back({tumour.id + " " + tumour.name, std::string(textOf(tumour.state)), millimetres(tumour.marginMm),
                      millimetres(tumour.marginAtLeastMm), millimetres(tumour.distanceMm)});
    }
    std::cout << alignedTable(rows)
              << "margins: voxel size only; segmentation, breathing, registration and transection not included\n";
  }
  for (const VesselCrossing& vessel : a.vesselsCrossed) {
    std::cout << "vessel crossed: " << vessel.name << " at (" << formatNumber(vessel.positionMm.x(), 1) << ", "
              << formatNumber(vessel.positionMm.y(), 1) << ", " << formatNumber(vessel.positionMm.z(), 1) << ") mm, diameter "
              << formatNumber(vessel.diameterMm, 1) << " mm\n";
  }
}

/// A resection that takes nothing or everything is refused: its numbers would look like a plan.
void checkDivides(const ResectionVolume& added, double totalMl, const Case& source) {
  if (added.volumeMl > 0 && added.volumeMl < totalMl) {
    return;
  }
  const IndexBox& box = source.liver->liver.box();
  Vec3 middle;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    middle[axis] = box.first[a] + 0.5 * (box.size[a] - 1);
  }
  const Vec3 centre = source.liver->geometry.toWorld(middle);
  throw UsageError("--plane does not divide the liver (" + std::string(added.volumeMl > 0 ? "all of it" : "nothing") +
                   " would be resected), so nothing was stored; the liver lies about (" + formatNumber(centre.x(), 1) + ", " +
                   formatNumber(centre.y(), 1) + ", " + formatNumber(centre.z(), 1) + ") mm");
}

void show(const PlanAssessment& assessment, const ResectionPlan& plan, const TerritoryCommand* territories, bool json) {
  if (json) {
    std::cout << (territories != nullptr ? toJson(assessment, territories->report(plan), territories->perfusion())
                                         : toJson(assessment))
              << '\n';
    if (!assessment.warning.empty()) {
      complain(assessment.warning);
    }
    return;
  }
  printText(assessment);
  if (territories != nullptr) {
    territories->printText(territories->report(plan));
  }
}

int addResection(const Flags& flags, const ExecutionContext& context) {
  Resection resection;
  for (const std::string& plane : flags.planes) {
    resection.planes.push_back(planeOf(plane));
  }
  checkTerritoryFlags(flags.territories);
  CaseFile file = CaseFile::open(flags.caseFile);
  Case source = file.load();
  ResectionPlan& plan = source.plans[planIndex(source.plans, flags.plan, flags.caseFile)];
  if (!resection.planes.empty()) {
    resection.name = "Resection " + std::to_string(plan.resections.size() + 1);
    plan.resections.push_back(resection);
  }
  const PlanAssessment assessment = PlanAssessor(source).assess(plan);
  if (!resection.planes.empty()) {
    checkDivides(assessment.resections.back(), assessment.totalMl, source);
  }
  std::unique_ptr<TerritoryCommand> territories;
  if (flags.territories.wanted) {
    territories = std::make_unique<TerritoryCommand>(source, flags.territories, context);
  }
  context.throwIfCancelled();
  if (!resection.planes.empty()) {
    file.storePlans(source.plans);
  }
  show(assessment, plan, territories.get(), flags.json);
  return kDone;
}

}  // namespace

void addPlan(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("plan", "Add a resection to a case's plan and print the plan's assessment");
  command->add_option("CASE", flags->caseFile, "The .glisson case")->required();
  command
      ->add_option(
          "--plane", flags->planes,
          "ox,oy,oz,nx,ny,nz: a point (mm LPS) and the direction to the resected side; several bound one resection together; "
          "none: only the assessment")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--plan", flags->plan, "The plan's name (default: the first)");
  command->add_flag("--json", flags->json, "JSON on stdout");
  addTerritoryFlags(*command, flags->territories);
  command->callback(
      [flags, &chosen] { chosen = [flags](const ExecutionContext& context) { return addResection(*flags, context); }; });
}

}  // namespace glisson::cli
