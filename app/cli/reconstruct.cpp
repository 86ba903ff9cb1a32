#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>

#include "app/cli/choose.h"
#include "app/cli/command.h"
#include "app/cli/reconstruct_flags.h"
#include "app/cli/report.h"
#include "planning/exchange/atomic_file.h"
#include "planning/exchange/mesh_files.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/peak_memory.h"
#include "reconstruction/stopwatch.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct CommandFlags {
  std::string segmentation;
  std::string output;
  std::string report;
  int threads = 0;
  MaskChoice choice;
  InputFlags input;
  ReconstructFlags method;
};

/// One surface, its place on disk and what was measured about it.
struct Made {
  std::filesystem::path output;
  std::filesystem::path report;
  Reconstruction result;
  ReconstructReport measured;
};

/// OUT.stl -> OUT_d5.stl where several surfaces are asked for.
std::filesystem::path withSuffix(const std::filesystem::path& path, const std::string& suffix) {
  if (suffix.empty() || path.empty()) {
    return path;
  }
  return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

void checkOutputs(const CommandFlags& flags) {
  const std::string extension = toLower(std::filesystem::path(flags.output).extension().string());
  if (extension != ".stl" && extension != ".ply" && extension != ".obj" && extension != ".vtp" && extension != ".glb") {
    throw UsageError("-o " + flags.output + " needs one of the endings .stl .ply .obj .vtp .glb");
  }
  if (flags.threads < 0) {
    throw UsageError("--threads takes 1 or more, or 0 for all cores");
  }
  checkWritable(flags.output);
  if (!flags.report.empty()) {
    checkWritable(flags.report);
  }
}

std::string summaryOf(const Made& made) {
  const Reconstruction& result = made.result;
  const std::string volume =
      std::isfinite(result.meshVolumeMl) ? formatNumber(result.meshVolumeMl, 2) + " mL" : "no volume of an open mesh";
  std::string line = made.output.string() + ": " + result.parameters.describe() + ", " +
                     std::to_string(result.mesh.triangles.size()) + " triangles, " + volume + " (voxels " +
                     formatNumber(result.voxelVolumeMl, 2) + " mL), " + formatNumber(result.seconds.total(), 2) + " s";
  for (const auto* list : {&result.notes, &result.deviations}) {
    for (const std::string& note : *list) {
      line += "\n  note: " + note;
    }
  }
  return line;
}

void write(Made& made, const ChosenMask& chosen) {
  const Stopwatch stopwatch;
  writeMesh({made.output.stem().string(), chosen.name, defaultColour(chosen.kind), 1.0, made.result.mesh}, made.output);
  made.measured.writeSeconds = stopwatch.seconds();
  if (!made.report.empty()) {
    writeFileAtomically(made.report, textOf(toJson(made.result, made.measured)) + "\n");
  }
}

int reconstructAll(const CLI::App& command, const CommandFlags& flags, const ExecutionContext& context) {
  const std::vector<ParameterSet> sets = parametersOf(command, flags.method);
  const ReadOptions options = readOptions(flags.input);
  checkOutputs(flags);
  const ThreadLimit limit(flags.threads);

  const Stopwatch stopwatch;
  const Segmentation segmentation = readSegmentation(flags.segmentation, options, context.range(0, 0.2));
  const ChosenMask chosen = chooseMask(segmentation, flags.choice);
  if (chosen.mask->empty()) {
    throw ReconstructionError(flags.segmentation + ", " + chosen.name +
                              ": the mask is empty, so there is no surface to make; choose another structure");
  }
  const double loadSeconds = stopwatch.seconds();

  std::vector<Made> all(sets.size());
  std::vector<ReconstructionParameters> parameters;
  parameters.reserve(sets.size());
  for (const ParameterSet& set : sets) {
    parameters.push_back(set.parameters);
  }
  const PeakMemory memory;
  const auto take = [&](std::size_t n, Reconstruction result) {
    Made& made = all[n];
    made.output = withSuffix(flags.output, sets[n].suffix);
    made.report = withSuffix(flags.report, sets[n].suffix);
    made.result = std::move(result);
    made.measured.peakGrowthMb = memory.growthMb();
    made.measured.loadSeconds = loadSeconds;
    made.measured.threads = flags.threads;
    if (!flags.report.empty() && !made.result.mesh.empty()) {
      made.measured.paperErrorMm = paperError(made.result.mesh, *chosen.mask, segmentation.geometry, context);
      made.measured.voxelErrorMm = voxelError(made.result.mesh, *chosen.mask, segmentation.geometry, context);
    }
  };
  reconstructEach(*chosen.mask, segmentation.geometry, chosen.kind, parameters, take, context.range(0.2, 1.0));

  int code = kDone;
  for (Made& made : all) {
    context.throwIfCancelled();
    write(made, chosen);
    std::cout << summaryOf(made) << '\n';
    if (made.result.defects.any()) {
      complain(made.output.string() + " was written, but its surface has defects: " + made.result.defects.names().front() +
               "; it will not be exported to navigation");
      code = kCheckFailed;
    }
  }
  return code;
}

}  // namespace

void addReconstruct(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<CommandFlags>();
  auto* command = app.add_subcommand("reconstruct", "Make the surface of one structure");
  command->add_option("SEG", flags->segmentation, "Label map or folder of masks")->required();
  addMaskChoice(*command, flags->choice);
  addReconstructFlags(*command, flags->method);
  addInteger(*command, "--threads", flags->threads, "Threads; 0 is all cores");
  command->add_option("-o,--output", flags->output, "OUT.stl, .ply, .obj, .vtp or .glb")->required();
  command->add_option("--report", flags->report, "Also write times, volumes, errors and checks as JSON");
  addInputFlags(*command, flags->input);
  command->callback([flags, command, &chosen] {
    chosen = [flags, command](const ExecutionContext& context) { return reconstructAll(*command, *flags, context); };
  });
}

}  // namespace glisson::cli
