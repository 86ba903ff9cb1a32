#pragma once
// Purpose: the resection plane in the 3D view: the section's fill and grid lie in the model's renderer, outline, handles and the
// word at the arrow in the overlay, where nothing hides them. Frame: mm LPS.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/plane_handles.h"

class vtkRenderer;

namespace glisson {

inline constexpr double kGridMm = 10.0;

class PlaneActors {
 public:
  PlaneActors(vtkRenderer* model, vtkRenderer* overlay);
  ~PlaneActors();

  void setVisible(bool visible);
  void setSection(const HalfSpace& plane, const std::vector<Loop>& loops);
  void placeHandles(const HalfSpace& plane, const HandleLayout& layout, std::optional<PlaneHandle> highlighted);
  /// The word at the arrow's tip, UTF-8: the side the arrow points to.
  void setLabel(const std::string& text);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
