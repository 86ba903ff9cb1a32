#pragma once
// Purpose: the parts of a package once the islands are where the plan gives them: a separated piece that counts with the other side
// is a mesh of that side, and the resection surface has no faces where it divides nothing any more. Private to planning/exchange.
// mm LPS.

#include <vector>

#include "planning/resection/resection_plan.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// What a resection makes of the parenchyma.
struct ResectedPart {
  std::vector<SurfaceMesh> pieces;  ///< closed
  SurfaceMesh surface;              ///< open, facing the resected side
};

/// How much of a closed mesh lies on the resection's planes, mm^2.
using AreaOnPlanes = double (*)(const SurfaceMesh& piece, const std::vector<ResectionPlane>& planes);

/// Moves each of `islands` that is given to the other side. A piece of the remnant goes to the resection whose planes it lies on.
/// Throws PlanningError where the surface has no such separated piece: it hangs together with the rest, or is missing.
void moveIslands(const std::vector<IslandAssessment>& islands, const ResectionPlan& plan, AreaOnPlanes areaOnPlanes,
                 std::vector<ResectedPart>& parts, std::vector<SurfaceMesh>& remnant);

}  // namespace glisson
