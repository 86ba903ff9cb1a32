#pragma once
// Purpose: the JSON of `reconstruct --report` and `measure --json` (keys are a contract: README, "The command line").

#include <optional>

#include "reconstruction/json.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/reconstruct.h"

namespace glisson::cli {

struct ReconstructReport {
  double loadSeconds = 0;
  double writeSeconds = 0;
  std::optional<double> peakGrowthMb;
  std::optional<ErrorSummary> paperErrorMm;
  std::optional<ErrorSummary> voxelErrorMm;
  int threads = 0;
};

/// Indented; a name that is no UTF-8 does not cost the rest.
std::string textOf(const Json& json);
/// Not finite becomes null: JSON has no word for it.
Json number(double value);
Json toJson(const ErrorSummary& errors);
Json toJson(const std::optional<ErrorSummary>& errors);
Json toJson(const Reconstruction& result, const ReconstructReport& report);

}  // namespace glisson::cli
