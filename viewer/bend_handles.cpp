#include "viewer/bend_handles.h"

#include <algorithm>

namespace glisson {

std::optional<std::size_t> controlPointAt(const ResectionPlane& plane, const ViewCamera& camera, const Pixel& mouse) {
  constexpr double kGraspPixels = 9.0;
  std::optional<std::size_t> best;
  double nearest = 0;
  for (std::size_t n = 0; plane.bend && n < plane.bend->heightsMm.size(); ++n) {
    const Vec3 at = controlPoint(plane, n);
    const double depth = (at - camera.position).dot(camera.forward);
    if (depth > 0 && (camera.toPixel(at) - mouse).norm() < kGraspPixels && (!best || depth < nearest)) {
      best = n;
      nearest = depth;
    }
  }
  return best;
}

ResectionPlane lifted(const ResectionPlane& plane, std::size_t point, bool group, double mm) {
  ResectionPlane raised = plane;
  std::array<bool, 16> members{};
  members[point] = true;
  if (group) {
    members = groupOf(point);
  }
  for (std::size_t n = 0; n < members.size(); ++n) {
    double& height = raised.bend->heightsMm[n];
    height = members[n] ? std::clamp(height + mm, -kMostBendMm, kMostBendMm) : height;
  }
  return raised;
}

BendDrag::BendDrag(const ResectionPlane& plane, std::size_t point, bool group, const ViewCamera& camera, const Pixel& mouse)
    : start_(plane), point_(point), group_(group), camera_(camera), grasp_(mouse) {
  graspAlong_ = along(mouse);
}

double BendDrag::along(const Pixel& mouse) const {
  return alongNormal(camera_, controlPoint(start_, point_), start_.normal, mouse, grasp_);
}

ResectionPlane BendDrag::planeAt(const Pixel& mouse) const { return lifted(start_, point_, group_, along(mouse) - graspAlong_); }

}  // namespace glisson
