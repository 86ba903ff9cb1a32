#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "app/cli/command.h"
#include "planning/exchange/package.h"
#include "planning/storage/case_file.h"
#include "reconstruction/errors.h"

namespace glisson::cli {

namespace {

void parseFormats(const std::string& text, ExportOptions& options) {
  options.stl = false;
  options.glb = false;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    if (part == "stl") {
      options.stl = true;
    } else if (part == "glb") {
      options.glb = true;
    } else {
      throw UsageError("--formats takes stl and glb, not \"" + part + "\"");
    }
  }
  if (!options.stl && !options.glb) {
    throw UsageError("--formats needs at least one of stl and glb");
  }
}

/// What planning refuses is said with the case's file, which it does not know.
ExportResult exportCase(const std::string& file, const std::string& directory, const ExportOptions& options,
                        const ExecutionContext& context) {
  try {
    return exportPackage(CaseFile::open(file).load(), directory, options, context);
  } catch (const PlanningError& error) {
    throw PlanningError(file + ": " + error.what());
  } catch (const CheckFailed& error) {
    throw CheckFailed(file + ": " + error.what());
  }
}

}  // namespace

void addExport(CLI::App& app, Action& chosen) {
  struct Flags {
    std::string caseFile;
    std::string directory;
    std::string formats = "stl,glb";
    ExportOptions options;
  };
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("export", "Write the navigation package of a case's plan");
  command->add_option("CASE", flags->caseFile, "The .glisson case")->required();
  command->add_option("-o,--output", flags->directory, "Folder that is to hold the package's folder")->required();
  command->add_option("--formats", flags->formats, "stl, glb (comma separated)")->capture_default_str();
  command->add_option("--plan", flags->options.planName, "The plan's name (default: the first)");
  command->add_flag("--patient-id", flags->options.patientId, "Put the patient's id into plan.json");
  command->add_flag("--accept-deviations", flags->options.acceptDeviations,
                    "Export although a structure deviates from its voxels beyond the limits");
  command->callback([flags, &chosen] {
    chosen = [flags](const ExecutionContext& context) {
      parseFormats(flags->formats, flags->options);
      const ExportResult result = exportCase(flags->caseFile, flags->directory, flags->options, context);
      for (const std::string& file : result.files) {
        std::cout << (result.folder / file).string() << '\n';
      }
      std::cout << "exported and verified: " << result.folder.string() << '\n';
      return kDone;
    };
  });
}

}  // namespace glisson::cli
