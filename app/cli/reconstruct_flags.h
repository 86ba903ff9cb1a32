#pragma once
// Purpose: the method flags of `reconstruct` and what they mean together.

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "reconstruction/reconstruct.h"

namespace glisson::cli {

struct ReconstructFlags {
  std::string method = "psr";
  // One value or several, comma separated.
  std::string depths = "7";  ///< numbers or "auto"
  std::string variants;      ///< ids of a listed method's; empty: its usual one
  std::string smoothings = "10";
  std::string decimations = "0.25";
  std::string sampling = "unbiased";
  std::string filter = "sinc";
  std::string order = "decimate-first";
  std::string simplify;  ///< empty, "10000" or "0.3mm"
  ReconstructionParameters parameters;
};

void addReconstructFlags(CLI::App& command, ReconstructFlags& flags);
/// One surface to make, and what its file is called behind OUT: "_d6", "_s22_e10"; empty where it is the only one.
struct ParameterSet {
  ReconstructionParameters parameters;
  std::string suffix;
};
/// A set per depth (psr), per decimation and smoothing (mcsd), or per variant (listed methods), each validated. Throws UsageError,
/// also where a flag belongs to another method.
std::vector<ParameterSet> parametersOf(const CLI::App& command, const ReconstructFlags& flags);

}  // namespace glisson::cli
