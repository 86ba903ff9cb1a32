#pragma once
// Purpose: the sample patient's portal and hepatic venous trees: tapering capsules that fill the liver, never touch each other and
// keep clear of the tumours. Frame: local LPS mm (anatomy.h).
// Growth by repeated halving of the territory a branch feeds (after Tawhai et al. 2000, airway trees); radii follow Murray's law
// (1926): the cube of a branch's radius is proportional to the territory.

#include <vector>

#include "reconstruction/sample/anatomy.h"

namespace glisson::sample {

struct Branch {
  Capsule shape;
  int parent = -1;     ///< index of the branch it leaves; -1: the root
  int generation = 0;  ///< branch points between the root and this branch
};

struct VesselTree {
  std::vector<Branch> branches;  ///< parents before children
  /// Where a branch divides (two or more children begin), local mm.
  [[nodiscard]] std::vector<Vec3> branchPoints() const;
  /// Branch points on the longest way from the root to a tip.
  [[nodiscard]] int generations() const;
  /// Below 0 inside.
  [[nodiscard]] double distance(const Vec3& p) const;
};

struct VesselTrees {
  VesselTree portal;
  VesselTree hepatic;
};

/// Grows both trees until branches would be thinner than `tipRadiusMm` (1.5 for the sample patient, 1.0 for the thin one).
VesselTrees growVessels(double tipRadiusMm);

}  // namespace glisson::sample
