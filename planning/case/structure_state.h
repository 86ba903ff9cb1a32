#pragma once
// Purpose: what a person sets on a structure, as an edit changes it: how it looks, and who accepts its surface.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planning/case/liver_model.h"

namespace glisson {

struct StructureState {
  std::string id;
  Rgb colour;
  double opacity = 1;  ///< 0..1
  bool visible = true;
  std::optional<Acceptance> acceptance;
  std::string surface;  ///< surfaceHash() of the surface whose acceptance is changed; empty in an edit of the looks alone
  bool operator==(const StructureState&) const = default;
};

/// Without the surface's hash.
StructureState stateOf(const Structure& structure);

/// A new snapshot where the structure is in state `to` in all that differs from `from`; the rest stays as it is. Revision + 1.
/// Throws PlanningError where there is no such structure, or no surface to accept.
std::shared_ptr<const LiverModel> withState(const LiverModel& model, const StructureState& from, const StructureState& to);

}  // namespace glisson
