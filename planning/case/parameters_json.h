#pragma once
// Purpose: reconstruction parameters as JSON, the same words and keys in case files, plans and reports.

#include <nlohmann/json.hpp>

#include "reconstruction/reconstruct.h"

namespace glisson {

/// Every parameter, those of the method that was not used among them. Numbers come back as the same doubles.
nlohmann::ordered_json parametersJson(const ReconstructionParameters& parameters);
/// Reads parametersJson(), validated. Throws nlohmann::json::exception, UsageError.
ReconstructionParameters parametersFromJson(const nlohmann::ordered_json& json);

/// The method and the parameters the mesh depends on.
nlohmann::ordered_json usedParametersJson(const ReconstructionParameters& parameters);

}  // namespace glisson
