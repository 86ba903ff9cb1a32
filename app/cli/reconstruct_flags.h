#pragma once
// Purpose: the method flags of `reconstruct` and what they mean together.

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "reconstruction/reconstruct.h"

namespace glisson::cli {

struct ReconstructFlags {
  std::string method = "psr";
  std::string depths = "7";  ///< one or several, comma separated
  std::string sampling = "unbiased";
  std::string filter = "sinc";
  std::string order = "decimate-first";
  std::string simplify;  ///< empty, "10000" or "0.3mm"
  ReconstructionParameters parameters;
};

void addReconstructFlags(CLI::App& command, ReconstructFlags& flags);
/// One set of parameters per depth (MCSD: one), each validated. Throws UsageError, also where a flag belongs to the other method.
std::vector<ReconstructionParameters> parametersOf(const CLI::App& command, const ReconstructFlags& flags);

}  // namespace glisson::cli
