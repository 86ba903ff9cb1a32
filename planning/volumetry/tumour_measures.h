#pragma once
// Purpose: what can be measured of each tumour without a plan: size, and how near it lies to vessels and to the capsule.
// Frame: mm LPS. All from the voxels' boxes, exactly: what they cannot resolve is half a voxel, as for margins (method.md 5).

#include <optional>
#include <string>
#include <vector>

#include "planning/case/case.h"

namespace glisson {

struct TumourMeasures {
  std::string id;
  std::string name;
  double volumeMl = 0;
  double longestDiameterMm = 0;  ///< of the voxels' boxes
  Vec3 diameterFrom = Vec3::Zero();
  Vec3 diameterTo = Vec3::Zero();
  /// Shortest way to what lies outside L; 0 where the tumour reaches it. Cavities inside L are not outside.
  double capsuleMm = 0;
  bool capsuleBeyondImage = false;  ///< L goes on beyond the image there, so the capsule is at least this far
  std::string nearestVesselId;      ///< empty where the case has no vessels
  std::string nearestVessel;
  std::optional<double> vesselMm;  ///< shortest way to that vessel's voxels, also those outside L; 0 where they touch
};

/// One entry for each lesion with voxels, in the model's order. Polls cancel before each.
std::vector<TumourMeasures> tumourMeasures(const Case& source, const ExecutionContext& context = {});

/// The `tumourMeasures` array of `plan --json`, as text.
std::string toJson(const std::vector<TumourMeasures>& measures);

}  // namespace glisson
