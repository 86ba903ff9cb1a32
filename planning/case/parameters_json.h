#pragma once
// Purpose: reconstruction parameters as JSON, the same words and keys in case files, plans and reports.

#include "reconstruction/json.h"
#include "reconstruction/reconstruct.h"

namespace glisson {

/// Every parameter, those of the method that was not used among them. Numbers come back as the same doubles.
Json parametersJson(const ReconstructionParameters& parameters);
/// Reads parametersJson(), validated. Throws Json::exception, UsageError.
ReconstructionParameters parametersFromJson(const Json& json);

/// The method and the parameters the mesh depends on.
Json usedParametersJson(const ReconstructionParameters& parameters);

}  // namespace glisson
