#pragma once
// Purpose: the methods there are beside PSR and MCSD.

#include <string_view>
#include <vector>

#include "reconstruction/methods/method.h"

namespace glisson {

/// In the order of lists and tables.
const std::vector<ReconstructionMethod>& listedMethods();
/// Throws UsageError, which names those there are.
const ReconstructionMethod& listedMethod(std::string_view id);
/// An empty id is the usual one. Throws UsageError, which names those there are.
const MethodVariant& variantOf(const ReconstructionMethod& method, std::string_view id);

}  // namespace glisson
