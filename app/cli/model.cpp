#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/table.h"
#include "planning/case/case.h"
#include "planning/storage/case_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct ModelFlags {
  std::string segmentation;
  std::string ct;
  bool embedCt = false;
  std::string output;
  bool replace = false;
  int threads = 0;
  InputFlags input;
};

std::string defectsOf(const Reconstruction& made) {
  std::string list;
  for (const std::string& name : made.defects.names()) {
    list += (list.empty() ? "" : "; ") + name;
  }
  return list.empty() ? "none" : list;
}

std::string deviationOf(const Reconstruction& made) {
  const double percent = 100.0 * made.volumeDeviation();
  return std::isfinite(percent) ? (percent >= 0 ? "+" : "") + formatNumber(percent, 3) + " %" : "-";
}

void printTable(const LiverModel& model) {
  std::vector<std::vector<std::string>> rows{
      {"structure", "method", "mL voxels", "mL mesh", "deviation", "triangles", "defects", "seconds"}};
  for (const Structure& structure : model.structures) {
    if (!structure.reconstruction) {
      continue;
    }
    const Reconstruction& made = *structure.reconstruction;
    rows.push_back({structure.id, made.parameters.describe(), formatNumber(made.voxelVolumeMl, 2),
                    std::isfinite(made.meshVolumeMl) ? formatNumber(made.meshVolumeMl, 2) : "open", deviationOf(made),
                    std::to_string(made.mesh.triangles.size()), defectsOf(made), formatNumber(made.seconds.total(), 2)});
  }
  std::cout << alignedTable(rows);
}

void printNotes(const Case& made) {
  for (const std::string& note : made.notes) {
    std::cout << "note: " << note << '\n';
  }
  for (const Structure& structure : made.model->structures) {
    if (!structure.reconstruction) {
      continue;
    }
    for (const auto* list : {&structure.reconstruction->notes, &structure.reconstruction->deviations}) {
      for (const std::string& note : *list) {
        std::cout << "note: " << structure.id << ": " << note << '\n';
      }
    }
  }
}

/// A case somebody has planned in is not replaced by one without plans unasked.
void checkHoldsNoPlan(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return;
  }
  std::vector<ResectionPlan> plans;
  try {
    plans = CaseFile::open(path).load().plans;
  } catch (const Error&) {  // no case that can be opened
    return;
  }
  if (std::ranges::any_of(plans, [](const ResectionPlan& plan) { return !plan.resections.empty(); })) {
    throw InputError(path.string() + " holds plans, which would be lost; name another file, or replace it with --replace");
  }
}

int makeModel(const ModelFlags& flags, const ExecutionContext& context) {
  const ReadOptions options = readOptions(flags.input);
  if (std::filesystem::path(flags.output).extension() != ".glisson") {
    throw UsageError("-o " + flags.output + " needs the ending .glisson");
  }
  if (flags.embedCt && flags.ct.empty()) {
    throw UsageError("--embed-ct needs the CT that is to be in the case; name it with --ct");
  }
  if (flags.threads < 0) {
    throw UsageError("--threads takes 1 or more, or 0 for all cores");
  }
  checkWritable(flags.output);
  if (!flags.replace) {
    checkHoldsNoPlan(flags.output);
  }
  const ThreadLimit limit(flags.threads);
  Segmentation segmentation = readSegmentation(flags.segmentation, options, context.range(0, 0.1));
  std::shared_ptr<const CtVolume> ct;
  if (!flags.ct.empty()) {
    ct = std::make_shared<const CtVolume>(readCt(flags.ct, options, context.range(0.1, 0.2)));
    segmentation = matchToCt(std::move(segmentation), *ct, options);
  }
  const Case made =
      buildModel(newCase(ct, std::make_shared<const Segmentation>(std::move(segmentation))), context.range(0.2, 0.95));
  context.throwIfCancelled();
  CaseFile::create(flags.output, made, {}, {.embed = flags.embedCt}, context.range(0.95, 1.0));
  printTable(*made.model);
  printNotes(made);
  std::cout << "written: " << flags.output << '\n';
  if (flags.embedCt) {
    constexpr double kBytesPerMb = 1e6;
    const auto bytes = static_cast<double>(std::filesystem::file_size(flags.output));
    std::cout << "the CT is in it: " << formatNumber(bytes / kBytesPerMb, 1) << " MB; whoever gets the file sees the slices\n";
  }
  for (const Structure& structure : made.model->structures) {
    if (structure.reconstruction && structure.reconstruction->defects.any()) {
      complain(structure.id + " in " + flags.output + " has defects: " + structure.reconstruction->defects.names().front() +
               "; it will not be exported to navigation");
      return kCheckFailed;
    }
  }
  return kDone;
}

}  // namespace

void addModel(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<ModelFlags>();
  auto* command = app.add_subcommand("model", "Make the whole liver model: all structures, default methods");
  command->add_option("SEG", flags->segmentation, "Label map or folder of masks")->required();
  command->add_option("--ct", flags->ct, "The CT the segmentation belongs to");
  command->add_flag("--embed-ct", flags->embedCt, "Put the CT into the case, to send it to somebody who has not got the images");
  command->add_option("-o,--output", flags->output, "CASE.glisson")->required();
  command->add_flag("--replace", flags->replace, "Replace CASE.glisson also where it holds plans");
  addInteger(*command, "--threads", flags->threads, "Threads; 0 is all cores");
  addInputFlags(*command, flags->input);
  command->callback([flags, &chosen] { chosen = [flags](const ExecutionContext& context) { return makeModel(*flags, context); }; });
}

}  // namespace glisson::cli
