#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/command.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson::cli {

void addSample(CLI::App& app, Action& chosen) {
  struct Flags {
    std::string directory;
    bool thin = false;
  };
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("sample", "Write the built-in synthetic patient: CT as DICOM and NIfTI, segmentation, truth");
  command->add_option("DIR", flags->directory, "Folder to write to; missing or empty")->required();
  command->add_flag("--thin", flags->thin, "0.8 mm slices and branches down to 2 mm");
  command->callback([flags, &chosen] {
    chosen = [flags](const ExecutionContext& context) {
      const SamplePatient patient = makeSamplePatient(flags->thin, context.range(0, 0.7));
      writeSamplePatient(patient, flags->directory, context.range(0.7, 1));
      std::cout << "sample patient: " << patient.ct.geometry.describe() << ", " << patient.segmentation.structures.size()
                << " structures, in " << flags->directory << '\n';
      return kDone;
    };
  });
}

}  // namespace glisson::cli
