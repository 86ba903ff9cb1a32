#pragma once
// Purpose: the control points of a bent plane as handles, without any drawing: which one the mouse is over, and which plane a drag
// gives. Pure values. Frame: mm LPS for the world, logical pixels for the picture.

#include <optional>

#include "viewer/plane_handles.h"

namespace glisson {

/// The control point under the mouse, of several the nearest to the viewer; nothing where there is none or the plane is flat.
std::optional<std::size_t> controlPointAt(const ResectionPlane& plane, const ViewCamera& camera, const Pixel& mouse);

/// The plane with one control point, or all of its group (corners, edges, inner), `mm` higher. Heights stay within kMostBendMm.
ResectionPlane lifted(const ResectionPlane& plane, std::size_t point, bool group, double mm);

/// One drag of a control point along the normal, from grasp to release. The camera does not move meanwhile.
class BendDrag {
 public:
  BendDrag(const ResectionPlane& plane, std::size_t point, bool group, const ViewCamera& camera, const Pixel& mouse);
  [[nodiscard]] ResectionPlane planeAt(const Pixel& mouse) const;
  [[nodiscard]] const ResectionPlane& start() const { return start_; }
  [[nodiscard]] std::size_t point() const { return point_; }
  [[nodiscard]] bool group() const { return group_; }

 private:
  [[nodiscard]] double along(const Pixel& mouse) const;

  ResectionPlane start_;
  std::size_t point_;
  bool group_;
  ViewCamera camera_;
  Pixel grasp_;
  double graspAlong_ = 0;
};

}  // namespace glisson
