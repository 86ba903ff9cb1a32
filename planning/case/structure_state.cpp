#include "planning/case/structure_state.h"

#include "planning/case/case.h"
#include "reconstruction/errors.h"

namespace glisson {

StructureState stateOf(const Structure& structure) {
  return {structure.id, structure.colour, structure.opacity, structure.visible, structure.acceptance, {}};
}

std::shared_ptr<const LiverModel> withState(const LiverModel& model, const StructureState& from, const StructureState& to) {
  const Structure* found = model.find(to.id);
  if (found == nullptr) {
    throw PlanningError("The model has no structure " + to.id + "; build it from the segmentation of this case.");
  }
  Structure changed = *found;
  if (!(from.colour == to.colour)) {
    changed.colour = to.colour;
  }
  if (from.opacity != to.opacity) {
    changed.opacity = to.opacity;
  }
  if (from.visible != to.visible) {
    changed.visible = to.visible;
  }
  const std::shared_ptr<const LiverModel> next = withStructure(model, std::move(changed));
  return from.acceptance == to.acceptance ? next : withAcceptance(*next, {to.id}, to.acceptance);
}

}  // namespace glisson
