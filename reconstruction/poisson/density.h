#pragma once
// Purpose: the area of `paper` samples, which carry none of their own: that of a cell over the number of samples near it.

#include "reconstruction/poisson/splatting.h"

namespace glisson::poisson {

/// Sets the weights, mm^2. `kernelCellMm` is the cell of level `kernelLevel`.
void weighByDensity(CubeSamples& samples, int kernelLevel, double kernelCellMm, const ExecutionContext& context);

}  // namespace glisson::poisson
