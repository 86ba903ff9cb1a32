#pragma once
// Purpose: the curve in which a bent plane crosses a slice, inside the picture.

#include <vector>

#include "planning/resection/bend.h"
#include "viewer/slice_geometry.h"

namespace glisson {

/// Lines through slice points, each with the resected side on its right as seen on the screen (y down); a closed one ends where it
/// begins. Its points are at most `stepMm` apart; what bends more finely is not seen.
std::vector<std::vector<SlicePoint>> slicesCurves(const SliceGeometry& geometry, int slice, const ResectionPlane& plane,
                                                  double stepMm = 0.5);

}  // namespace glisson
