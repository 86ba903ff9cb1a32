#include "app/cli/cohort.h"

#include <iostream>
#include <new>

#include "app/cli/cohort_csv.h"
#include "app/cli/cohort_html.h"
#include "app/cli/cohort_summary.h"
#include "app/cli/evaluate_label.h"
#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"

namespace glisson::cli {

namespace {

/// What one patient came to, kept in its folder; nothing where the user interrupted it.
std::optional<PatientOutcome> outcomeOf(const CohortToEvaluate& cohort, const CohortEntry& entry, const ExecutionContext& context) {
  removeOutcome(cohort.folder, entry);
  PatientOutcome outcome;
  try {
    const LabelToEvaluate label{.segmentation = entry.segmentation.string(),
                                .reading = readOptions(entry.input),
                                .choice = entry.choice,
                                .options = cohort.options,
                                .recipes = cohort.recipes,
                                .folder = cohort.folder / entry.name};
    const std::optional<Evaluation> evaluation = evaluateLabel(label, context);
    if (!evaluation) {
      return std::nullopt;
    }
    outcome.figures = figuresOf(*evaluation);
  } catch (const Cancelled&) {
    complain("interrupted before a model of " + entry.name + " was made; the same command goes on from there");
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    outcome.failure = kOutOfMemory;
  } catch (const std::exception& error) {
    outcome.failure = error.what();
  }
  saveOutcome(cohort.folder, {entry, cohort.options, cohort.recipes}, outcome);
  return outcome;
}

GatheredCohort gathered(const CohortToEvaluate& cohort) {
  GatheredCohort all;
  all.list = cohort.list.file;
  all.options = cohort.options;
  std::vector<PatientFigures> figures;
  for (const CohortEntry& entry : cohort.list.entries) {
    all.patients.push_back({entry, loadOutcome(cohort.folder, {entry, cohort.options, cohort.recipes})});
    if (all.patients.back().state() == PatientState::Evaluated) {
      figures.push_back(all.patients.back().outcome->figures);
    }
  }
  all.statistics = statisticsOf(figures);
  return all;
}

int conclude(const CohortToEvaluate& cohort, const GatheredCohort& all) {
  if (all.statistics.patients == 0) {
    throw InputError("no patient of " + cohort.list.file + " has a result in " + cohort.folder.string() +
                     "; see why above, and run them again");
  }
  writeFileAtomically(cohort.folder / "cohort.csv", cohortCsv(all));
  writeFileAtomically(cohort.folder / "cohort.json", textOf(cohortJson(all)) + "\n");
  writeFileAtomically(cohort.folder / "cohort.html", cohortHtml(all));
  std::cout << cohort.folder.string() << ": " << cohortText(all);
  return all.statistics.patients == all.patients.size() ? kDone : kCheckFailed;
}

}  // namespace

void leaveToFlags(CohortList& list, const MaskChoice& choice, const InputFlags& input) {
  for (CohortEntry& entry : list.entries) {
    if (!entry.choice.label && entry.choice.structure.empty()) {
      entry.choice = choice;
    }
    for (std::string InputFlags::*flag : {&InputFlags::labels, &InputFlags::accept, &InputFlags::prefer}) {
      if ((entry.input.*flag).empty()) {
        entry.input.*flag = input.*flag;
      }
    }
  }
}

int evaluateCohort(const CohortToEvaluate& cohort, const ExecutionContext& context) {
  const auto count = static_cast<double>(cohort.list.entries.size());
  for (const CohortEntry& entry : cohort.list.entries) {
    const auto outcome = outcomeOf(cohort, entry, context.range((entry.number - 1) / count, entry.number / count));
    if (!outcome) {
      return kInterrupted;
    }
    if (!outcome->failure.empty()) {
      complain(sentenceOf({entry, outcome}, cohort.list.file));
    }
  }
  return conclude(cohort, gathered(cohort));
}

int evaluatePatient(const CohortToEvaluate& cohort, int number, const ExecutionContext& context) {
  const std::size_t count = cohort.list.entries.size();
  if (number < 1 || static_cast<std::size_t>(number) > count) {
    throw UsageError("--task takes a number from 1 to " + std::to_string(count) + ": " + cohort.list.file +
                     " has as many patients");
  }
  const CohortEntry& entry = cohort.list.entries[static_cast<std::size_t>(number) - 1];
  const auto outcome = outcomeOf(cohort, entry, context);
  if (!outcome) {
    return kInterrupted;
  }
  if (!outcome->failure.empty()) {
    throw InputError(sentenceOf({entry, outcome}, cohort.list.file));
  }
  return kDone;
}

int gatherCohort(const CohortToEvaluate& cohort) {
  const GatheredCohort all = gathered(cohort);
  for (const GatheredPatient& patient : all.patients) {
    if (patient.state() != PatientState::Evaluated) {
      complain(sentenceOf(patient, cohort.list.file));
    }
  }
  return conclude(cohort, all);
}

}  // namespace glisson::cli
