#pragma once
// Purpose: the margin of a tumour that is not cut (method.md 5), from its voxel boxes to the resection surface inside the liver.

#include "planning/volumetry/cut_distance.h"

namespace glisson {

/// The margin of boxes that lie on the resected side altogether.
struct Margin {
  double mm = 0;             ///< infinity where there is no surface
  double atLeast = 0;        ///< mm - what a bent plane's pieces are flattened by - resolution along the shortest way
  Vec3 from = Vec3::Zero();  ///< of the shortest way: on the boxes
  Vec3 to = Vec3::Zero();    ///< on the surface
};
Margin marginOf(const TumourBoxes& tumour, const Vec3& spacing, const CutDistance& cut);

/// Half the extent of a voxel along a unit direction: what a margin along it cannot resolve.
double resolutionMm(const Vec3& direction, const Vec3& spacing);

}  // namespace glisson
