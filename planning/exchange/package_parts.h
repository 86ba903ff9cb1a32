#pragma once
// Purpose: the meshes of a navigation package: the structures as they are, and what the plan makes of the parenchyma. Private to
// planning/exchange. mm LPS.

#include <string>
#include <string_view>
#include <vector>

#include "planning/exchange/mesh_files.h"
#include "planning/exchange/package.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

struct PackageMesh {
  NamedMesh named;  ///< its id names the STL file and the GLB node; its name is made from the id, never from the source's free text
  std::string role;  ///< "structure", "remnant", "resected", "resection surface"
  bool closed = true;
  int resection = -1;  ///< index into the plan's resections, for resected parts and their surface
};

/// Structures in the model's order, then remnant, resected parts and resection surfaces; of the plan's assessment, those `islands`
/// that are given to the other side are meshes of that side. Throws PlanningError (no parenchyma, not
/// built, defects with self-intersection, deviations not accepted, a resection that does not divide the liver), Cancelled (polled
/// between meshes and inside the cuts).
std::vector<PackageMesh> packageMeshes(const Case& source, const ResectionPlan& plan, const std::vector<IslandAssessment>& islands,
                                       const ExportOptions& options, const ExecutionContext& context);

}  // namespace glisson
