#pragma once
// Purpose: the handles of the plane that is worked on, the word at its arrow, and the line of the margin that decides, in the
// overlay, where nothing hides them. Frame: mm LPS.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "viewer/plane_handles.h"

class vtkRenderer;

namespace glisson {

class PlaneActors {
 public:
  explicit PlaneActors(vtkRenderer* overlay);
  ~PlaneActors();

  void setVisible(bool visible);
  void placeHandles(const HalfSpace& plane, const HandleLayout& layout, std::optional<PlaneHandle> highlighted, bool tilts = true);
  /// The control points of a bent plane with the net between them; the highlighted ones brighter. Nothing: none are shown.
  void placeControlPoints(const ResectionPlane* plane, const std::array<bool, 16>& highlighted, double mmPerPixel);
  /// Red where it is too short, else white; drawn while the plane is visible.
  void setMarginLine(const std::optional<std::pair<Vec3, Vec3>>& line, bool tooShort);
  /// The word at the arrow's tip, UTF-8: the side the arrow points to.
  void setLabel(const std::string& text);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
