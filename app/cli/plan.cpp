#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/plan_flags.h"
#include "app/cli/plan_json.h"
#include "app/cli/plan_print.h"
#include "planning/exchange/version.h"
#include "planning/resection/plan_edit.h"
#include "planning/resection/plan_list.h"
#include "planning/storage/case_file.h"
#include "planning/volumetry/bend_over.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {
std::size_t planIndex(const Plans& plans, const std::string& name, const std::string& flag, const std::string& file) {
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
  throw UsageError(flag + " " + name + " is not in " + file + "; it holds: " + names);
}

std::size_t resectionIndex(const ResectionPlan& plan, const std::string& name, const std::string& flag) {
  std::string names;
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    if (plan.resections[r].name == name) {
      return r;
    }
    names += (names.empty() ? "" : ", ") + plan.resections[r].name;
  }
  throw UsageError(flag + " " + name + " is not in " + plan.name + "; it holds: " + (names.empty() ? "none" : names));
}

/// A resection that takes nothing, and a plan that takes everything, are refused: their numbers would look like a plan.
void checkDivides(const PlanAssessment& assessment, std::size_t changed, const Case& source) {
  const ResectionVolume& resection = assessment.resections[changed];
  if (assessment.divides && resection.volumeMl > 0) {
    return;
  }
  if (resection.dividesByItself) {
    throw UsageError(resection.volumeMl > 0
                         ? "the resections of the plan together take all of the liver, so nothing was stored"
                         : "the resection takes nothing, since others of the plan already take all that it would, "
                           "so nothing was stored");
  }
  const IndexBox& box = source.liver->liver.box();
  Vec3 middle;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    middle[axis] = box.first[a] + 0.5 * (box.size[a] - 1);
  }
  const Vec3 centre = source.liver->geometry.toWorld(middle);
  throw UsageError("the plane does not divide the liver (" + std::string(resection.volumeMl > 0 ? "all of it" : "nothing") +
                   " would be resected), so nothing was stored; the liver lies about (" + formatNumber(centre.x(), 1) + ", " +
                   formatNumber(centre.y(), 1) + ", " + formatNumber(centre.z(), 1) + ") mm");
}

/// What one call changes and shows.
struct Work {
  Case source;
  std::size_t index = 0;                   ///< of the plan
  std::vector<std::size_t> cut;            ///< the resections that got planes, or whose planes were bent or flattened
  std::optional<MarginProposal> proposal;  ///< where one was asked for
  std::vector<std::string> edits;          ///< of the plans, as they stand behind Undo

  [[nodiscard]] ResectionPlan& plan() { return source.plans[index]; }
  void edit(const PlanEdit& edit) {
    edits.push_back(nameOf(plan(), edit));
    plan() = apply(plan(), edit);
  }
  /// All of one call is one step.
  [[nodiscard]] std::string editName() const { return edits.size() == 1 ? edits.front() : "edit plans"; }
};

/// Copy, rename and delete: the list first, so that the edits of the same call go into the right plan.
void editList(const PlanFlags& flags, Work& work) {
  if (!flags.duplicate.empty()) {
    work.edits.emplace_back("duplicate plan");
    work.source.plans = withDuplicate(work.source.plans, work.index, flags.duplicate);
    ++work.index;
  }
  if (!flags.rename.empty()) {
    work.edits.emplace_back("rename plan");
    work.source.plans = withRenamed(work.source.plans, work.index, flags.rename);
  }
  if (flags.remove) {
    work.edits.emplace_back("delete plan");
    work.source.plans = without(work.source.plans, work.index);
    work.index = 0;
  }
}

/// Without a half size the square lies over the cut.
ResectionPlane bent(const HalfSpace& plane, const TypedBend& typed, const LiverVoxels& liver) {
  ResectionPlane made = bendOver(liver, plane);
  if (typed.halfSizeMm) {
    made.origin = plane.origin;
    made.bend->halfSizeMm = *typed.halfSizeMm;
  }
  made.bend->heightsMm = typed.heightsMm;
  return made;
}

/// A plane that is bent already keeps its square where no half size is given.
ResectionPlane reshaped(const ResectionPlane& there, const TypedBend& typed, const LiverVoxels& liver) {
  if (!there.bend) {
    return bent(there, typed, liver);
  }
  Bend bend = *there.bend;
  bend.heightsMm = typed.heightsMm;
  bend.halfSizeMm = typed.halfSizeMm.value_or(bend.halfSizeMm);
  return {there, bend};
}

void addPlanes(const PlanFlags& flags, Work& work, const ExecutionContext& context) {
  std::vector<ResectionPlane> planes;
  for (const HalfSpace& plane : planesOf(flags, work.source.segmentation->geometry)) {
    planes.emplace_back(plane);
  }
  if (!flags.bend.empty()) {
    planes.back() = bent(planes.back(), bendOf(flags.bend), *work.source.liver);
  }
  if (!flags.proposeMargin.empty()) {
    work.proposal = proposeMarginPlane(work.source, flags.proposeMargin, work.plan().safetyMarginMm, context);
    if (work.proposal->plane) {
      planes.push_back(*work.proposal->plane);
    }
  }
  if (planes.empty()) {
    if (!flags.toResection.empty() && !work.proposal && work.cut.empty()) {
      throw UsageError("--resection needs a plane of the same call to add");
    }
    return;
  }
  if (flags.toResection.empty()) {
    work.edit(AddResection{{"", planes}});
    work.cut.push_back(work.plan().resections.size() - 1);
    return;
  }
  const std::size_t resection = resectionIndex(work.plan(), flags.toResection, "--resection");
  for (const ResectionPlane& plane : planes) {
    work.edit(AddPlane{resection, plane});
  }
  work.cut.push_back(resection);
}

/// The resection whose planes are bent or flattened, and that it has plane `plane`.
std::size_t resectionWith(std::size_t plane, const PlanFlags& flags, const std::string& flag, Work& work) {
  const std::vector<Resection>& resections = work.plan().resections;
  if (flags.toResection.empty() && resections.size() != 1) {
    throw UsageError(flag + " needs --resection where the plan has not one resection; " + work.plan().name + " has " +
                     std::to_string(resections.size()));
  }
  const std::size_t resection = flags.toResection.empty() ? 0 : resectionIndex(work.plan(), flags.toResection, "--resection");
  const std::size_t planes = resections[resection].planes.size();
  if (plane >= planes) {
    throw UsageError(flag + " " + std::to_string(plane + 1) + ": " + resections[resection].name + " has " + std::to_string(planes) +
                     (planes == 1 ? " plane" : " planes"));
  }
  work.cut.push_back(resection);
  return resection;
}

/// Planes that are there, before others join them.
void reshapePlanes(const PlanFlags& flags, Work& work) {
  for (const std::string& text : flags.flattenPlanes) {
    const std::size_t plane = planeNumberOf("--flatten-plane", text);
    const std::size_t resection = resectionWith(plane, flags, "--flatten-plane", work);
    if (!work.plan().resections[resection].planes[plane].bend) {
      throw UsageError("--flatten-plane " + text + ": the plane is flat");
    }
    work.edit(FlattenPlane{resection, plane});
  }
  for (const std::string& text : flags.bendPlanes) {
    const TypedPlaneBend typed = planeBendOf(text);
    const std::size_t resection = resectionWith(typed.plane, flags, "--bend-plane", work);
    const ResectionPlane made = reshaped(work.plan().resections[resection].planes[typed.plane], typed.bend, *work.source.liver);
    work.edit(BendPlane{resection, typed.plane, made.bend.value(), made.origin});
  }
}

void editIsland(const std::string& text, Work& work) {
  const IslandAssignment island = islandOf(text);
  if (!text.ends_with(",back")) {
    work.edit(AssignIsland{island});
    return;
  }
  constexpr double kSamePointMm = 0.1;  // as it is printed
  const auto& islands = work.plan().islands;
  for (std::size_t n = 0; n < islands.size(); ++n) {
    if ((islands[n].point - island.point).norm() <= kSamePointMm) {
      work.edit(ReleaseIsland{{n}});
      return;
    }
  }
  throw UsageError("--island " + text + ": no island at that point is given to a side");
}

void editPlan(const PlanFlags& flags, Work& work, const ExecutionContext& context) {
  if (!flags.margin.empty()) {
    work.edit(SetSafetyMargin{numberOf("--margin", flags.margin)});
  }
  if (!flags.removeResection.empty()) {
    work.edit(RemoveResection{resectionIndex(work.plan(), flags.removeResection, "--remove-resection")});
  }
  reshapePlanes(flags, work);
  addPlanes(flags, work, context);
  for (const std::string& text : flags.islands) {
    editIsland(text, work);
  }
  for (const std::string& text : flags.measures) {
    work.edit(AddMeasure{measureOf(text)});
  }
}

struct ComparedPlans {
  PlanComparison table;
  std::vector<std::string> differences;  ///< of two plans
};

std::optional<ComparedPlans> compared(const PlanFlags& flags, Work& work, const PlanAssessor& assessor) {
  if (flags.compare.empty()) {
    return std::nullopt;
  }
  std::vector<std::size_t> indices{work.index};
  for (const std::string& name : flags.compare) {
    indices.push_back(planIndex(work.source.plans, name, "--compare", flags.caseFile));
  }
  std::vector<PlanAssessment> assessments;
  assessments.reserve(indices.size());
  for (const std::size_t index : indices) {
    assessments.push_back(assessor.assess(work.source.plans[index]));
  }
  std::vector<AssessedPlan> plans;
  plans.reserve(indices.size());
  for (std::size_t n = 0; n < indices.size(); ++n) {
    plans.push_back({work.source.plans[indices[n]], assessments[n]});
  }
  ComparedPlans comparison{comparePlans(plans), {}};
  if (plans.size() == 2) {
    comparison.differences = differenceOf(plans[0], plans[1]);
  }
  return comparison;
}

void show(const PlanFlags& flags, Work& work, const PlanAssessment& assessment, const std::vector<TumourMeasures>& tumours,
          const std::optional<ComparedPlans>& comparison, const TerritoryCommand* territories) {
  const FlrCard card = flrCard(work.source.patient, assessment);
  if (!flags.json) {
    std::cout << work.plan().name << ", safety margin " << formatExact(work.plan().safetyMarginMm) << " mm\n";
    if (work.proposal) {
      print(*work.proposal);
    }
    printBends(work.plan());
    print(assessment);
    print(tumours);
    print(work.plan().measures);
    print(card);
    printAcceptance(*work.source.model);
    if (comparison) {
      print(comparison->table, comparison->differences);
    }
    if (territories != nullptr) {
      territories->printText(territories->report(work.plan()));
    }
    return;
  }
  Json json = Json::parse(territories == nullptr ? toJson(assessment)
                                                 : toJson(assessment, territories->report(work.plan()), territories->perfusion()));
  json["program"] = "Glisson";
  json["version"] = glissonVersion();
  json["case"] = work.source.code;
  json["ctDate"] = work.source.identity.studyDate.empty() ? Json(nullptr) : Json(work.source.identity.studyDate);
  json["plan"] = work.plan().name;
  json["safetyMarginMm"] = work.plan().safetyMarginMm;
  json["warning"] = assessment.warning.empty() ? Json(nullptr) : Json(assessment.warning);
  json["marginNotice"] = kMarginNotice;
  json["tumourMeasures"] = Json::parse(toJson(tumours));
  json["measures"] = measuresJson(work.plan().measures);
  json["planes"] = planesJson(work.plan());
  if (hasBends(work.plan())) {
    json["bends"] = bendsJson(work.plan());
  }
  json["flrCard"] = Json::parse(toJson(card));
  json["structures"] = structuresJson(*work.source.model);
  if (work.proposal) {
    json["marginProposal"] = Json::parse(toJson(*work.proposal));
  }
  if (comparison) {
    json["comparison"] = Json::parse(toJson(comparison->table, comparison->differences));
  }
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!assessment.warning.empty()) {
    complain(assessment.warning);
  }
}

/// All that the call changes, or nothing of it.
void store(CaseFile& file, const PlanFlags& flags, Work& work, const PatientFacts& before,
           const std::shared_ptr<const LiverModel>& modelBefore, const TerritoryCommand* territories) {
  const TerritoryMarks marks = territories != nullptr ? territories->marks() : work.source.territories;
  CaseChanges changes;
  if (!work.edits.empty()) {
    changes.plans = &work.source.plans;
    changes.planEdit = work.editName();
  }
  if (work.source.patient != before) {
    changes.patient = &work.source.patient;
    changes.patientEdit = "change patient facts";
  }
  if (!(marks == work.source.territories)) {
    changes.territories = &marks;
    changes.territoryEdit = territories->editName();
  }
  if (work.source.model != modelBefore) {
    changes.model = work.source.model.get();
    changes.modelEdit = flags.acceptance.accept.empty() ? "edit structures" : "accept structures";
  }
  if (changes.plans != nullptr || changes.patient != nullptr || changes.territories != nullptr || changes.model != nullptr) {
    file.store(changes);
  }
}

int runPlan(const PlanFlags& flags, const ExecutionContext& context) {
  checkFlags(flags);
  checkTerritoryFlags(flags.territories);
  CaseFile file = CaseFile::open(flags.caseFile);
  Work work{file.load(), 0, {}, {}, {}};
  work.index = planIndex(work.source.plans, flags.plan, "--plan", flags.caseFile);
  const PatientFacts before = work.source.patient;
  const std::shared_ptr<const LiverModel> modelBefore = work.source.model;
  work.source.model = accepted(modelBefore, flags.acceptance, flags.caseFile);
  try {
    editList(flags, work);
    editPlan(flags, work, context);
    work.source.patient = factsOf(flags, before);
    validate(work.source.patient);
  } catch (const PlanningError& error) {
    throw UsageError(error.what());  // what was typed does not fit this case
  }
  const PlanAssessor assessor(work.source);
  const PlanAssessment assessment = assessor.assess(work.plan());
  context.throwIfCancelled();
  for (const std::size_t resection : work.cut) {
    checkDivides(assessment, resection, work.source);
  }
  const std::optional<ComparedPlans> comparison = compared(flags, work, assessor);
  std::optional<TerritoryCommand> territories;
  if (flags.territories.wanted) {
    territories.emplace(work.source, flags.territories, context);
  }
  const std::vector<TumourMeasures> tumours = tumourMeasures(work.source, context);  // before what can no longer be interrupted
  if (!flags.dryRun) {
    store(file, flags, work, before, modelBefore, territories ? &*territories : nullptr);
  }
  show(flags, work, assessment, tumours, comparison, territories ? &*territories : nullptr);
  return kDone;
}

}  // namespace

void addPlan(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<PlanFlags>();
  auto* command = app.add_subcommand("plan", "Add a resection to a case's plan and print the plan's assessment");
  addPlanFlags(*command, *flags);
  command->callback([flags, &chosen] { chosen = [flags](const ExecutionContext& context) { return runPlan(*flags, context); }; });
}

}  // namespace glisson::cli
