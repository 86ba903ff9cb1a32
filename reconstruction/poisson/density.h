#pragma once
// Purpose: the area of `paper` samples, which carry none of their own: that of a cell over the number of samples near it.

#include "reconstruction/poisson/splatting.h"

namespace glisson::poisson {

/// Sets the weights, mm^2. `cellMm` is the cell of `level`.
void weighByDensity(CubeSamples& samples, int level, double cellMm, const ExecutionContext& context);

}  // namespace glisson::poisson
