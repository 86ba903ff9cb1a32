#include "viewer/first_frames.h"

#include <vtkPropCollection.h>

namespace glisson {

FirstFrames::Held FirstFrames::hold(std::span<vtkRenderer* const> layers, bool peels) {
  std::set<const vtkProp*>& drawn = drawn_[peels ? 1 : 0];
  const std::size_t most = drawn.empty() ? 1 : kNewProps;
  std::size_t added = 0;
  for (vtkRenderer* layer : layers) {
    vtkPropCollection* props = layer->GetViewProps();
    for (int n = 0; n < props->GetNumberOfItems(); ++n) {
      auto* prop = static_cast<vtkProp*>(props->GetItemAsObject(n));
      if (prop->GetVisibility() == 0 || drawn.contains(prop)) {
        continue;
      }
      if (added < most) {
        ++added;
        drawn.insert(prop);
      } else {
        prop->VisibilityOff();
        held_.push_back(prop);
      }
    }
  }
  return {.anyNew = added > 0, .more = !held_.empty()};
}

void FirstFrames::release() {
  for (vtkProp* prop : held_) {
    prop->VisibilityOn();
  }
  held_.clear();
}

}  // namespace glisson
