// The part of the document that edits plans.

#include <utility>

#include "app/gui/document.h"
#include "app/gui/edit_commands.h"
#include "planning/resection/plan_list.h"
#include "planning/volumetry/bend_over.h"

namespace glisson {

namespace {

constexpr const char* kPatientStep = QT_TRANSLATE_NOOP("glisson::Document", "change patient facts");

/// The nearest place that exists.
ChosenPlane existing(const std::vector<ResectionPlan>& plans, ChosenPlane chosen) {
  const auto within = [](std::size_t place, std::size_t size) { return size == 0 ? 0 : std::min(place, size - 1); };
  chosen.plan = within(chosen.plan, plans.size());
  if (plans.empty() || plans[chosen.plan].resections.empty()) {
    return {chosen.plan, 0, 0};
  }
  const std::vector<Resection>& resections = plans[chosen.plan].resections;
  chosen.resection = within(chosen.resection, resections.size());
  chosen.plane = within(chosen.plane, resections[chosen.resection].planes.size());
  return chosen;
}

}  // namespace

const ResectionPlan& Document::plan() const {
  static const ResectionPlan kNone;
  return chosen_.plan < case_.plans.size() ? case_.plans[chosen_.plan] : kNone;
}

std::optional<ResectionPlane> Document::plane() const {
  const std::vector<Resection>& resections = plan().resections;
  if (chosen_.resection >= resections.size() || chosen_.plane >= resections[chosen_.resection].planes.size()) {
    return std::nullopt;
  }
  return resections[chosen_.resection].planes[chosen_.plane];
}

void Document::choose(const ChosenPlane& chosen) {
  if (existing(case_.plans, chosen) == chosen_) {
    return;
  }
  cancelDrag();
  const ChosenPlane next = existing(case_.plans, chosen);
  if (next == chosen_) {
    return;
  }
  const bool otherPlan = next.plan != chosen_.plan;
  chosen_ = next;
  emit planChanged();
  if (otherPlan) {
    assessInFrame();
    assessAll();
  }
}

std::vector<ResectionPlan> Document::plansWithPlane(const ResectionPlane& plane) const {
  std::vector<ResectionPlan> plans = case_.plans;
  if (plans.empty()) {
    plans.push_back({.name = "Plan 1", .resections = {}});
  }
  ResectionPlan& current = plans[chosen_.plan];
  if (this->plane()) {
    current.resections[chosen_.resection].planes[chosen_.plane] = checkedPlane(plane);
  } else {
    current = apply(current, PlanEdit(AddResection{{.name = {}, .planes = {plane}}}));
  }
  return plans;
}

void Document::pushPlans(const QString& name, std::vector<ResectionPlan> plans, const ChosenPlane& chosen) {
  const ChosenPlane after = existing(plans, chosen);
  undo_.push(new PlansCommand(*this, name, {case_.plans, chosen_}, {std::move(plans), after}));
}

void Document::placePlane(const HalfSpace& plane) {
  cancelDrag();
  pushPlans(QString::fromLatin1(QT_TR_NOOP("place plane")), plansWithPlane(plane), chosen_);
}

void Document::movePlane(const HalfSpace& plane) {
  if (this->plane()) {
    edit(MovePlane{chosen_.resection, chosen_.plane, plane});
  }
}

void Document::removePlane() {
  if (plane()) {
    edit(RemovePlane{chosen_.resection, chosen_.plane});
  }
}

void Document::startBend() {
  cancelDrag();
  const std::optional<ResectionPlane> now = plane();
  if (now && !now->bend && case_.liver) {
    const ResectionPlane bent = bendOver(*case_.liver, *now);
    edit(BendPlane{chosen_.resection, chosen_.plane, *bent.bend, bent.origin});
  }
}

void Document::bendPlane(const Bend& bend) {
  if (plane() && plane()->bend) {
    edit(BendPlane{chosen_.resection, chosen_.plane, bend});
  }
}

void Document::flattenPlane() {
  if (plane() && plane()->bend) {
    edit(FlattenPlane{chosen_.resection, chosen_.plane});
  }
}

void Document::edit(const PlanEdit& edit) {
  cancelDrag();
  std::vector<ResectionPlan> plans = case_.plans;
  if (chosen_.plan >= plans.size()) {
    return;
  }
  ResectionPlan& current = plans[chosen_.plan];
  const QString name = QString::fromStdString(nameOf(current, edit));
  current = apply(current, edit);
  ChosenPlane chosen = chosen_;
  if (std::holds_alternative<AddResection>(edit.what)) {
    chosen = {chosen.plan, current.resections.size() - 1, 0};
  } else if (const auto* added = std::get_if<AddPlane>(&edit.what)) {
    chosen = {chosen.plan, added->resection, current.resections[added->resection].planes.size() - 1};
  }
  pushPlans(name, std::move(plans), chosen);
}

void Document::addPlan() {
  cancelDrag();
  std::vector<ResectionPlan> plans = withNew(case_.plans);
  const std::size_t last = plans.size() - 1;
  pushPlans(QString::fromLatin1(QT_TR_NOOP("new plan")), std::move(plans), {last, 0, 0});
}

void Document::duplicatePlan() {
  cancelDrag();
  pushPlans(QString::fromLatin1(QT_TR_NOOP("duplicate plan")), withDuplicate(case_.plans, chosen_.plan),
            {chosen_.plan + 1, chosen_.resection, chosen_.plane});
}

void Document::renamePlan(const std::string& name) {
  cancelDrag();
  if (name != plan().name) {
    pushPlans(QString::fromLatin1(QT_TR_NOOP("rename plan")), withRenamed(case_.plans, chosen_.plan, name), chosen_);
  }
}

void Document::removePlan() {
  cancelDrag();
  pushPlans(QString::fromLatin1(QT_TR_NOOP("delete plan")), without(case_.plans, chosen_.plan), {chosen_.plan, 0, 0});
}

void Document::beginDrag() {
  beforeDrag_ = case_.plans;
  wholeMs_ = 0;  // each drag tries once more
}

void Document::dragTo(const ResectionPlane& plane) {
  if (!beforeDrag_) {
    beginDrag();
  }
  case_.plans = plansWithPlane(plane);
  emit planChanged();
  assessInFrame();
}

void Document::endDrag(const ResectionPlane& plane) {
  if (!beforeDrag_) {
    return;
  }
  case_.plans = *std::exchange(beforeDrag_, std::nullopt);
  const std::optional<ResectionPlane> from = this->plane();
  if (from && *from == plane) {
    emit planChanged();  // a click on a handle moves nothing and is no step
    assessInFrame();
    assessAll();
    return;
  }
  if (!from) {
    placePlane(plane);
  } else if (from->normal == plane.normal && from->bend && plane.bend && from->bend->u != plane.bend->u) {
    edit(SpinPlane{chosen_.resection, chosen_.plane, plane.bend->u, plane.origin});
  } else if (from->origin == plane.origin && from->normal == plane.normal && plane.bend) {
    edit(BendPlane{chosen_.resection, chosen_.plane, *plane.bend});
  } else {
    movePlane(plane);
  }
}

void Document::cancelDrag() {
  if (beforeDrag_) {
    case_.plans = *std::exchange(beforeDrag_, std::nullopt);
    emit dragCancelled();
    emit planChanged();
    assessInFrame();
    assessAll();
  }
}

void Document::forgetDrag() {
  if (beforeDrag_) {
    beforeDrag_.reset();
    emit dragCancelled();
  }
}

void Document::setPlans(std::vector<ResectionPlan> plans, const ChosenPlane& chosen, const QString& name) {
  leaveReadOnlyFile();
  forgetDrag();  // undone or done again
  case_.plans = std::move(plans);
  chosen_ = existing(case_.plans, chosen);
  store_.storePlans(case_.plans, name);
  emit planChanged();
  assessInFrame();
  assessAll();
}

void Document::restoreHistory(const CaseFile& file) {
  for (const EditStep& step : standingEdits(file.history())) {
    const auto named = [&](const char* otherwise) {
      return step.name.empty() ? QString::fromLatin1(otherwise) : QString::fromStdString(step.name);
    };
    if (step.patient) {
      undo_.push(new PatientCommand(*this, named(kPatientStep), step.patient->before, step.patient->after, true));
    } else if (step.territories) {
      const QString name = named(QT_TR_NOOP("change territories"));
      undo_.push(new TerritoriesCommand(*this, name, step.territories->before, step.territories->after, true));
    } else if (step.structures) {
      undo_.push(new StructuresCommand(*this, named(QT_TR_NOOP("edit structures")), changesOf(*step.structures), false, true));
    } else {
      const PlansCommand::State before{step.before, existing(step.before, {})};
      undo_.push(new PlansCommand(*this, named(QT_TR_NOOP("edit plans")), before, {step.after, existing(step.after, {})}, true));
    }
  }
  undo_.setClean();
}

void Document::setPatient(const PatientFacts& facts) {
  validate(facts);
  if (!(facts == case_.patient)) {
    undo_.push(new PatientCommand(*this, QString::fromLatin1(kPatientStep), case_.patient, facts));
  }
}

void Document::setTerritories(const TerritoryMarks& marks, const QString& step) {
  if (!(marks == case_.territories)) {
    undo_.push(new TerritoriesCommand(*this, step, case_.territories, marks));
  }
}

void Document::storeTerritories(const TerritoryMarks& marks, const QString& name) {
  leaveReadOnlyFile();
  case_.territories = marks;
  store_.storeTerritories(marks, name);
  emit territoriesChanged();
}

void Document::storePatient(const PatientFacts& facts, const QString& name) {
  leaveReadOnlyFile();
  case_.patient = facts;
  store_.storePatient(facts, name);
  emit patientChanged();
}

}  // namespace glisson
