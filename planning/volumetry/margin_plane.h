#pragma once
// Purpose: the plane that removes one tumour at the safety margin with the smallest functional volume (a geometric start).
// Frame: mm LPS; margins and volumes as method.md 5 counts them.
// What is sought: among all planes that (a) have the tumour's voxel boxes on the resected side, (b) whose part inside L keeps the
// margin's lower bound (PlanAssessment's marginAtLeastMm) at the safety margin or more, and (c) leave functional liver on the
// remnant side, the one that resects the least of F. Where no plane does all three there is none. Method: for a direction n the
// nearest plane clear of the tumour by margin + r(n) everywhere, r(n) = 1/2 sum |n_i| spacing_i, is known exactly; its functional
// volume comes from the voxels in closed form. The best directions of an even set on the sphere are followed by a pattern search
// with falling steps. The best of the ends are then checked against the margin as it is assessed, inside L: moved away where an
// oblique way is coarser than r(n), moved closer where the nearest part of the plane lies outside L. Directions are compared before
// that last step, so a plane that gains by it may be missed; what is returned keeps the margin in every case.

#include <optional>
#include <string>
#include <vector>

#include "planning/case/case.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

/// Vessels at least this wide are listed, mm.
inline constexpr double kListedVesselMm = 3.0;

struct MarginProposal {
  std::string tumourId;
  std::string tumourName;
  double safetyMarginMm = 0;
  std::optional<HalfSpace> plane;       ///< none: `reason` says why; the origin is the middle of the cut inside L
  double resectedFunctionalMl = 0;      ///< of F
  double marginMm = 0;                  ///< of this tumour to this plane
  double marginAtLeastMm = 0;           ///< >= safetyMarginMm
  std::vector<VesselCrossing> vessels;  ///< of kListedVesselMm and more
  std::string reason;
  std::string notice;  ///< what the plane does not know: shown wherever it is
};

/// `tumour`: a lesion's id, or its name where that is the name of one lesion only. Throws PlanningError where there is no such
/// tumour or the margin is not a number of 0 or more. Polls cancel before each direction.
MarginProposal proposeMarginPlane(const Case& source, const std::string& tumour, double safetyMarginMm,
                                  const ExecutionContext& context = {});

/// The `marginProposal` object of `plan --json`, as text.
std::string toJson(const MarginProposal& proposal);

}  // namespace glisson
