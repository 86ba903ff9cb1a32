#include "reconstruction/mcsd/mcsd.h"

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

void McsdParameters::validate() const {
  if (smoothing < 0 || smoothing > 1000) {
    throw UsageError("The number of smoothing iterations is " + std::to_string(smoothing) + "; choose 0 to 1000.");
  }
  if (smoothing == 1 && filter == SmoothingFilter::Sinc) {
    throw UsageError("One iteration of the windowed sinc filter collapses the surface; choose 0, or 2 to 1000.");
  }
  if (!(decimation >= 0.0 && decimation <= 0.99)) {
    throw UsageError("The decimation is " + formatExact(decimation) + "; choose a share from 0 to 0.99.");
  }
}

McsdResult reconstructMcsd(const Mask& mask, const ImageGeometry& geometry, const McsdParameters& parameters,
                           const ExecutionContext& context) {
  McsdResult made;
  sweepMcsd(
      mask, geometry, std::span(&parameters, 1),
      [&](std::size_t /*set*/, McsdResult result, const ExecutionContext& /*share*/) { made = std::move(result); }, context);
  return made;
}

}  // namespace glisson
