#include <CLI/CLI.hpp>
#include <atomic>
#include <iostream>
#include <mutex>
#include <set>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/evaluate_html.h"
#include "app/cli/evaluate_summary.h"
#include "app/cli/model_store.h"
#include "app/cli/peak_memory.h"
#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/experiment.h"
#include "reconstruction/evaluation/models_csv.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/parallel.h"

namespace glisson::cli {

namespace {

constexpr double kPublishedScale = 1.25;  // of the authors' base code
constexpr int kPublishedTimings = 3;

struct Flags {
  std::string segmentation;
  std::string output;
  std::string sampling = "paper";
  std::string methods = "all";
  bool asPublished = false;
  bool bestOfThree = false;
  int threads = 0;
  MaskChoice choice;
  InputFlags input;
};

ExperimentOptions optionsOf(const Flags& flags) {
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

/// The ids of a comma separated list, all, or none of the listed methods.
std::set<std::string, std::less<>> otherMethodsOf(const std::string& text) {
  std::set<std::string, std::less<>> ids;
  if (text == "none") {
    return ids;
  }
  if (text == "all") {
    for (const ReconstructionMethod& method : listedMethods()) {
      ids.insert(method.id);
    }
    return ids;
  }
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    ids.insert(listedMethod(part).id);
  }
  if (ids.empty()) {
    throw UsageError("--methods takes all, none or names of other methods separated by commas, not \"" + text + "\"");
  }
  return ids;
}

/// "psr_knn,mpu,vessels".
std::string otherMethodsText() {
  std::string text;
  for (const ReconstructionMethod& method : listedMethods()) {
    text += (text.empty() ? "" : ",") + method.id;
  }
  return text;
}

/// Those of the experiment without the methods that are not asked for.
std::vector<ModelRecipe> recipesOf(const Flags& flags) {
  const auto methods = otherMethodsOf(flags.methods);
  std::vector<ModelRecipe> recipes = allRecipes();
  std::erase_if(recipes,
                [&](const ModelRecipe& recipe) { return recipe.family == ModelFamily::Other && !methods.contains(recipe.method); });
  return recipes;
}

/// "DIR/" is DIR.
std::filesystem::path withoutSlash(const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(text).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

/// Said before the work is done: DIR may be missing, the folder it is to stand in may not.
std::filesystem::path outputFolder(const Flags& flags) {
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

/// What the library refuses of a label is said with the label's name and file.
EvaluationReference referenceOf(const Flags& flags, const EvaluatedLabel& label, const ExecutionContext& context) {
  try {
    return {*label.chosen.mask, label.geometry, context};
  } catch (const ReconstructionError& error) {
    throw ReconstructionError(flags.segmentation + ", " + label.chosen.name + ": " + error.what());
  }
}

/// Makes what the store does not have and keeps it there.
class Run {
 public:
  Run(const EvaluatedLabel& label, const EvaluationReference& reference, const ModelStore& store, std::vector<ModelRecipe> recipes)
      : label_(label), reference_(reference), store_(store), recipes_(std::move(recipes)) {}

  void loadKept() {
    for (std::size_t n = 0; n < recipes_.size(); ++n) {
      models_[n] = store_.load(recipes_[n]);
      if (!models_[n]) {
        missing_.push_back(n);
      }
    }
  }
  void makeMissing(const ExecutionContext& context) {
    std::vector<ModelRecipe> recipes;
    for (const std::size_t place : missing_) {
      recipes.push_back(recipes_[place]);
    }
    makeModels(
        *label_.chosen.mask, label_.geometry, reference_, recipes, label_.options,
        [&](std::size_t n, EvaluatedModel model) { take(missing_[n], std::move(model)); }, context);
  }
  /// Once all are there.
  [[nodiscard]] Evaluation result() const {
    std::vector<EvaluatedModel> models;
    for (const std::optional<EvaluatedModel>& model : models_) {
      models.push_back(*model);
    }
    return evaluated(std::move(models));
  }

  [[nodiscard]] std::size_t all() const { return recipes_.size(); }
  [[nodiscard]] std::size_t kept() const { return recipes_.size() - missing_.size(); }
  [[nodiscard]] std::size_t made() const { return made_; }

 private:
  /// The memory is the program's: of the models made until now, which is more than one at a time.
  void take(std::size_t place, EvaluatedModel model) {
    {
      const std::lock_guard lock(mutex_);
      model.peakMemoryMb = memory_.growthMb();
    }
    store_.save(model);
    models_[place] = std::move(model);
    ++made_;
  }

  const EvaluatedLabel& label_;
  const EvaluationReference& reference_;
  const ModelStore& store_;
  const std::vector<ModelRecipe> recipes_;
  std::vector<std::optional<EvaluatedModel>> models_ = std::vector<std::optional<EvaluatedModel>>(recipes_.size());
  std::vector<std::size_t> missing_;
  std::atomic<std::size_t> made_{0};
  std::mutex mutex_;
  PeakMemory memory_;
};

void writeResults(const std::filesystem::path& folder, const EvaluatedLabel& label, const Evaluation& evaluation) {
  writeFileAtomically(folder / "models.csv", modelsCsv(evaluation, label.voxelVolumeMl));
  writeFileAtomically(folder / "summary.json", textOf(summaryJson(label, evaluation)) + "\n");
  writeFileAtomically(folder / "report.html", evaluationHtml(label, evaluation));
}

int evaluate(const Flags& flags, const ExecutionContext& context) {
  EvaluatedLabel label;
  label.options = optionsOf(flags);
  const std::vector<ModelRecipe> recipes = recipesOf(flags);
  const ReadOptions options = readOptions(flags.input);
  const std::filesystem::path folder = outputFolder(flags);
  const ThreadLimit limit(flags.threads);

  const Segmentation segmentation = readSegmentation(flags.segmentation, options, context.range(0, 0.05));
  label.file = withoutSlash(flags.segmentation).filename().string();
  label.chosen = chooseMask(segmentation, flags.choice);
  label.geometry = segmentation.geometry;
  const EvaluationReference reference = referenceOf(flags, label, context.range(0.05, 0.1));
  label.points = reference.pointCount();
  label.voxelVolumeMl = reference.voxelVolumeMl();

  const ModelStore store(folder / "models", label);
  store.prepare();
  Run run(label, reference, store, recipes);
  run.loadKept();
  try {
    run.makeMissing(context.range(0.1, 1.0));
    context.throwIfCancelled();
  } catch (const Cancelled&) {
    complain("interrupted; " + std::to_string(run.kept() + run.made()) + " of " + std::to_string(run.all()) +
             " models are kept in " + store.folder().string() + ", and the same command goes on from there");
    return kInterrupted;
  }
  const Evaluation evaluation = run.result();
  if (!evaluation.bounds) {
    throw CheckFailed(flags.segmentation + ", " + label.chosen.name + ": no model could be made (" +
                      evaluation.models.front().failure + ")");
  }
  writeResults(folder, label, evaluation);
  std::cout << folder.string() << ": " << run.all() << " models of " << label.chosen.name << ", " << run.made() << " made, "
            << run.kept() << " kept from before, " << evaluation.failed() << " failed\n"
            << summaryText(evaluation);
  return kDone;
}

}  // namespace

void addEvaluate(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("evaluate", "Compare PSR with MCSD on one structure: the paper's experiment");
  command->add_option("SEG", flags->segmentation, "Label map or folder of masks")->required();
  addMaskChoice(*command, flags->choice);
  command->add_option("-o,--output", flags->output, "Folder for models.csv, summary.json, report.html; a stopped run goes on there")
      ->required();
  command->add_option("--sampling", flags->sampling, "Samples of PSR: paper or unbiased")->capture_default_str();
  command->add_option("--methods", flags->methods, "Methods beside PSR and MCSD: all, none or " + otherMethodsText())
      ->capture_default_str();
  command->add_flag("--as-published", flags->asPublished, "PSR's cube at the authors' scale of 1.25");
  command->add_flag("--best-of-three", flags->bestOfThree, "Time each model three times and keep the quickest, as the paper does");
  addInteger(*command, "--threads", flags->threads, "Threads; 0 is all cores");
  addInputFlags(*command, flags->input);
  command->callback([flags, &chosen] { chosen = [flags](const ExecutionContext& context) { return evaluate(*flags, context); }; });
}

}  // namespace glisson::cli
