#pragma once
// Purpose: the parts of a case as JSON, for the case file. Private to storage/. Numbers come back as the same doubles.
// The from-functions throw Json::exception or std::runtime_error on what does not fit.

#include "planning/case/case.h"
#include "planning/case/structure_state.h"
#include "reconstruction/json.h"

namespace glisson::caseJson {

Json fromPlans(const std::vector<ResectionPlan>& plans);
std::vector<ResectionPlan> toPlans(const Json& json);

Json fromFacts(const PatientFacts& facts);
/// Validated.
PatientFacts toFacts(const Json& json);

Json fromMarks(const TerritoryMarks& marks);
/// Validated.
TerritoryMarks toMarks(const Json& json);

Json fromStates(const std::vector<StructureState>& states);
std::vector<StructureState> toStates(const Json& json);

Json fromIdentity(const PatientIdentity& identity);
PatientIdentity toIdentity(const Json& json);

Json fromGeometry(const ImageGeometry& geometry);
/// Validated.
ImageGeometry toGeometry(const Json& json);

Json fromBox(const IndexBox& box);
/// Checked to lie in a grid of `size` voxels.
IndexBox toBox(const Json& json, const Index3& size);

/// Everything but the mask.
Json fromLabelled(const LabelledMask& structure);
LabelledMask toLabelled(const Json& json);

/// Everything but the mesh, whose counts are in `vertices` and `triangles`.
Json fromStructure(const Structure& structure);
struct StoredStructure {
  Structure structure;
  std::shared_ptr<Reconstruction> reconstruction;  ///< null where not built; the mesh is still empty
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};
StoredStructure toStructure(const Json& json);

}  // namespace glisson::caseJson
