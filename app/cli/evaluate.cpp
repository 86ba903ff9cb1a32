#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/cohort.h"
#include "app/cli/evaluate_label.h"
#include "app/cli/evaluate_methods.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson::cli {

namespace {

constexpr double kPublishedScale = 1.25;  // of the authors' base code
constexpr int kPublishedTimings = 3;

struct EvaluateFlags {
  std::string segmentation;
  std::string output;
  std::string cohort;
  bool alone = false;
  int task = 0;  ///< where alone
  bool gather = false;
  bool count = false;
  std::string sampling = "paper";
  std::string methods = "all";
  bool asPublished = false;
  bool bestOfThree = false;
  int threads = 0;
  MaskChoice choice;
  InputFlags input;
};

ExperimentOptions optionsOf(const EvaluateFlags& flags) {
  if (flags.threads < 0) {
    throw UsageError("--threads takes 1 or more, or 0 for all cores");
  }
  if (flags.sampling != "paper" && flags.sampling != "unbiased") {
    throw UsageError("--sampling takes paper or unbiased, not \"" + flags.sampling + "\"");
  }
  ExperimentOptions options;
  options.sampling = flags.sampling == "paper" ? Sampling::Paper : Sampling::Unbiased;
  options.scale = flags.asPublished ? kPublishedScale : options.scale;
  options.timings = flags.bestOfThree ? kPublishedTimings : 1;
  return options;
}

/// Said before the work is done: DIR may be missing, the folder it is to stand in may not.
std::filesystem::path outputFolder(const EvaluateFlags& flags) {
  std::filesystem::path folder = withoutSlash(flags.output);
  std::error_code error;
  if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error)) {
    throw UsageError(flags.output + " is a file; name a folder");
  }
  if (!std::filesystem::is_directory(folder, error)) {
    checkWritable(folder);
  }
  return folder;
}

int evaluateOne(const EvaluateFlags& flags, const ExecutionContext& context) {
  const LabelToEvaluate label{.segmentation = flags.segmentation,
                              .reading = readOptions(flags.input),
                              .choice = flags.choice,
                              .options = optionsOf(flags),
                              .recipes = recipesOf(flags.methods),
                              .folder = outputFolder(flags)};
  const ThreadLimit limit(flags.threads);
  return evaluateLabel(label, context) ? kDone : kInterrupted;
}

int evaluateMany(const EvaluateFlags& flags, const ExecutionContext& context) {
  CohortToEvaluate cohort{.list = readCohortList(flags.cohort), .options = optionsOf(flags), .recipes = recipesOf(flags.methods)};
  if (flags.count) {
    std::cout << cohort.list.entries.size() << '\n';
    return kDone;
  }
  leaveToFlags(cohort.list, flags.choice, flags.input);
  cohort.folder = outputFolder(flags);
  if (flags.gather) {
    return gatherCohort(cohort);
  }
  const ThreadLimit limit(flags.threads);
  return flags.alone ? evaluatePatient(cohort, flags.task, context) : evaluateCohort(cohort, context);
}

int evaluate(const EvaluateFlags& flags, const ExecutionContext& context) {
  if (flags.segmentation.empty() && flags.cohort.empty()) {
    throw UsageError("evaluate takes a label map or a folder of masks, or --cohort LIST; name one");
  }
  if (flags.output.empty() && !flags.count) {
    throw UsageError("--output is missing; name the folder for the results");
  }
  return flags.cohort.empty() ? evaluateOne(flags, context) : evaluateMany(flags, context);
}

}  // namespace

void addEvaluate(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<EvaluateFlags>();
  auto* command = app.add_subcommand("evaluate", "Compare PSR with MCSD on one structure, or on one of each of many patients");
  auto* segmentation = command->add_option("SEG", flags->segmentation, "Label map or folder of masks");
  addMaskChoice(*command, flags->choice);
  command->add_option("-o,--output", flags->output, "Folder for the results; a stopped run goes on there");
  auto* cohort = command->add_option("--cohort", flags->cohort, "A CSV list of patients, instead of SEG")->excludes(segmentation);
  auto* task = addInteger(*command, "--task", flags->task, "Evaluate this patient of the list alone, from 1")
                   ->default_str("")
                   ->needs(cohort);
  auto* gather = command->add_flag("--gather", flags->gather, "Evaluate nobody: put together what is there")->needs(cohort);
  auto* count = command->add_flag("--count", flags->count, "Print how many patients the list has")->needs(cohort);
  task->excludes(gather)->excludes(count);
  gather->excludes(count);
  command->add_option("--sampling", flags->sampling, "Samples of PSR: paper or unbiased")->capture_default_str();
  command->add_option("--methods", flags->methods, "Methods beside PSR and MCSD: all, none or " + otherMethodsText())
      ->capture_default_str();
  command->add_flag("--as-published", flags->asPublished, "PSR's cube at the authors' scale of 1.25");
  command->add_flag("--best-of-three", flags->bestOfThree, "Time each model three times and keep the quickest, as the paper does");
  // The last one holds: a job script's own stands before the user's.
  addInteger(*command, "--threads", flags->threads, "Threads; 0 is all cores")->take_last();
  addInputFlags(*command, flags->input);
  command->callback([flags, task, &chosen] {
    flags->alone = task->count() > 0;
    chosen = [flags](const ExecutionContext& context) { return evaluate(*flags, context); };
  });
}

}  // namespace glisson::cli
