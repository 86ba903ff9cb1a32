#pragma once
// Purpose: the value at which the surface is extracted: the mean of X at the samples, weighted by their area (Kazhdan et al. 2006,
// section 4.4). It is never fitted to a volume.

#include "reconstruction/poisson/hierarchy.h"

namespace glisson::poisson {

float isoValue(const CubeSamples& samples, const Level& finest, const ExecutionContext& context);

}  // namespace glisson::poisson
