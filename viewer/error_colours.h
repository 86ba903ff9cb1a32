#pragma once
// Purpose: the colours of distances in the views that compare surfaces: dark blue (0) over green to yellow (the scale's end),
// lighter all the way, so that they are told apart without colour vision and in grey. Source: N. Smith, S. van der Walt: viridis,
// 2015 (CC0), at ten equal steps.

#include "reconstruction/image/structure_kind.h"

namespace glisson {

/// `share` 0..1; beyond it the colour of the end.
Rgb errorColour(double share);

/// The end of a common scale for surfaces whose 95th percentiles are these: the next 1, 2, 5 times a power of ten; at least 0.1 mm.
double errorScaleMm(double p95Mm);

}  // namespace glisson
