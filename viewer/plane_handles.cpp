#include "viewer/plane_handles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/segment.h"

namespace glisson {

namespace {

constexpr double kLabelPixels = 36.0;     ///< from the arrow's tip to the middle of the word
constexpr double kLabelBelow = 26.0;      ///< where the arrow is seen end-on
constexpr double kGraspPixels = 12.0;     ///< how near the mouse must be
constexpr double kFallbackPixels = 60.0;  ///< reach of a tilt handle where the plane misses the liver
constexpr double kEndOnCosine = 0.97;     ///< the arrow is seen end-on: its direction on the screen says nothing

/// The point moved in the picture's plane, so that what stands around it is not cut off at the view's border.
Vec3 insideView(const Vec3& point, const ViewCamera& camera, double halfWidth, double halfHeight) {
  const auto kept = [](double at, double half, double size) {
    return size > 2 * half ? std::clamp(at, half, size - half) : 0.5 * size;
  };
  const Pixel at = camera.toPixel(point);
  const Pixel moved = Pixel(kept(at.x(), halfWidth, camera.width), kept(at.y(), halfHeight, camera.height)) - at;
  return point + camera.mmPerPixel(point) * (moved.x() * camera.right() - moved.y() * camera.up);
}

constexpr double kSpinAngle = std::numbers::pi / 8;  ///< from TiltRight, beside the control points of a bend
constexpr double kLeastFacing = 0.2;                 ///< seen flatter than this, a plane is not spun: cosine

PlaneAxes handleAxes(const ResectionPlane& plane, double spun) {
  if (plane.bend) {
    return {plane.bend->u, plane.normal.cross(plane.bend->u)};
  }
  const PlaneAxes axes = axesOf(plane.normal);
  const double c = std::cos(spun);
  const double s = std::sin(spun);
  return {c * axes.u + s * axes.v, c * axes.v - s * axes.u};
}

}  // namespace

bool isTilt(PlaneHandle handle) {
  return handle != PlaneHandle::Centre && handle != PlaneHandle::Normal && handle != PlaneHandle::Spin;
}

Vec3 anchorOf(const HalfSpace& plane, const std::vector<Loop>& section) {
  return isInside(section, plane, plane.origin) ? plane.origin : centreOf(section, plane);
}

HandleLayout layoutHandles(const ResectionPlane& plane, const Vec3& anchor, const std::vector<Loop>& section,
                           const ViewCamera& camera, double spun) {
  HandleLayout layout;
  layout.anchor = anchor;
  layout.mmPerPixel = camera.mmPerPixel(anchor);
  layout.arrowTip = anchor + kArrowPixels * layout.mmPerPixel * plane.normal;
  const Vec3 acrossView = plane.normal - plane.normal.dot(camera.forward) * camera.forward;
  layout.label =
      layout.arrowTip + layout.mmPerPixel * (kLabelPixels * acrossView - kLabelBelow * (1.0 - acrossView.norm()) * camera.up);
  layout.label = insideView(layout.label, camera, kLabelHalfWidth, kLabelHalfHeight);
  const Pixel offTip = camera.toPixel(layout.label) - camera.toPixel(layout.arrowTip);
  if (std::abs(offTip.x()) < kLabelHalfWidth && std::abs(offTip.y()) < kLabelBelow) {
    // pushed onto the arrow by the view's border: it stands below the tip, or above it at the bottom
    const bool room = camera.toPixel(layout.arrowTip).y() + kLabelBelow + kLabelHalfHeight <= camera.height;
    layout.label -= layout.mmPerPixel * ((room ? kLabelBelow : -kLabelBelow) - offTip.y()) * camera.up;
  }
  const PlaneAxes axes = handleAxes(plane, spun);
  const Pixel centre = camera.toPixel(anchor);
  const auto onBorder = [&](const Vec3& direction) {
    const double distance = reach(section, plane, anchor, direction);
    return Vec3(anchor + (distance > 0 ? distance : kFallbackPixels * layout.mmPerPixel) * direction);
  };
  const auto besideCentre = [&](const Vec3& point) { return (camera.toPixel(point) - centre).norm() > 2.2 * kHandlePixels; };
  const std::array<Vec3, 4> directions{axes.u, axes.v, -axes.u, -axes.v};
  for (std::size_t n = 0; n < 4; ++n) {
    layout.tilts[n] = onBorder(directions[n]);
    layout.tiltShown[n] = besideCentre(layout.tilts[n]);
  }
  layout.spin = onBorder(std::cos(kSpinAngle) * axes.u + std::sin(kSpinAngle) * axes.v);
  layout.spinShown = besideCentre(layout.spin) && std::abs(plane.normal.dot(camera.forward)) > kLeastFacing;
  return layout;
}

std::optional<PlaneHandle> handleAt(const HandleLayout& layout, const ViewCamera& camera, const Pixel& mouse) {
  std::optional<PlaneHandle> best;
  double nearest = kGraspPixels;
  const auto consider = [&](PlaneHandle handle, double distance) {
    if (distance < nearest) {
      nearest = distance;
      best = handle;
    }
  };
  const Pixel centre = camera.toPixel(layout.anchor);
  consider(PlaneHandle::Centre, (mouse - centre).norm());
  for (std::size_t n = 0; n < 4; ++n) {
    if (layout.tiltShown[n]) {
      consider(static_cast<PlaneHandle>(static_cast<int>(PlaneHandle::TiltRight) + static_cast<int>(n)),
               (mouse - camera.toPixel(layout.tilts[n])).norm());
    }
  }
  if (layout.spinShown) {
    consider(PlaneHandle::Spin, (mouse - camera.toPixel(layout.spin)).norm());
  }
  // The arrow's foot belongs to the centre sphere.
  const Pixel tip = camera.toPixel(layout.arrowTip);
  const Pixel along = tip - centre;
  const double length = along.norm();
  const Pixel foot = length > 2 * kGraspPixels ? Pixel(centre + along * (1.5 * kGraspPixels / length)) : tip;
  consider(PlaneHandle::Normal, distanceToSegment(mouse, foot, tip));
  return best;
}

double alongNormal(const ViewCamera& camera, const Vec3& anchor, const Vec3& normal, const Pixel& mouse, const Pixel& grasp) {
  const Ray sight = camera.rayAt(mouse);
  const double cosine = sight.direction.dot(normal);
  if (std::abs(camera.forward.dot(normal)) > kEndOnCosine) {
    const double sign = camera.forward.dot(normal) > 0 ? 1.0 : -1.0;
    return sign * (grasp.y() - mouse.y()) * camera.mmPerPixel(anchor);
  }
  // Both directions are unit.
  const Vec3 between = sight.origin - anchor;
  return (between.dot(normal) - cosine * between.dot(sight.direction)) / (1.0 - cosine * cosine);
}

Vec3 turnedAbout(const Vec3& pivot, const Vec3& origin, const Vec3& from, const Vec3& to) {
  const Vec3 start = isOpposite(from, to) ? Vec3(-from) : from;
  return pivot + Eigen::Quaterniond::FromTwoVectors(start, to) * (origin - pivot);
}

PlaneDrag::PlaneDrag(PlaneHandle handle, const ResectionPlane& plane, const HandleLayout& layout, const ViewCamera& camera,
                     const Pixel& mouse)
    : handle_(handle), start_(plane), anchor_(layout.anchor), camera_(camera), grasp_(mouse) {
  if (plane.bend) {
    carried_ = plane.origin - anchor_;
  }
  if (isTilt(handle)) {
    const auto n = static_cast<std::size_t>(static_cast<int>(handle) - static_cast<int>(PlaneHandle::TiltRight));
    radius_ = std::max((layout.tilts[n] - anchor_).norm(), 1e-6);
    graspPoint_ = layout.tilts[n];
    // The mouse rarely meets the handle's centre: keep the offset, so that nothing jumps.
    grasp_ = camera_.toPixel(layout.tilts[n]) - mouse;
  } else if (handle == PlaneHandle::Spin) {
    graspPoint_ = onPlane(mouse);
  } else if (handle == PlaneHandle::Normal) {
    graspAlong_ = alongNormal(camera_, anchor_, start_.normal, mouse, grasp_);
  } else {
    graspPoint_ = inPicture(mouse);
  }
}

Vec3 PlaneDrag::inPicture(const Pixel& mouse) const {
  const Ray sight = camera_.rayAt(mouse);
  const double depth = (anchor_ - sight.origin).dot(camera_.forward) / sight.direction.dot(camera_.forward);
  return sight.origin + depth * sight.direction;
}

Vec3 PlaneDrag::onPlane(const Pixel& mouse) const {
  // Along the camera's direction, which the plane faces: in perspective the line of sight itself may miss it.
  const Vec3 beside = inPicture(mouse);
  return beside + (start_.normal.dot(anchor_ - beside) / start_.normal.dot(camera_.forward)) * camera_.forward;
}

Vec3 PlaneDrag::onSphere(const Pixel& mouse) const {
  const Ray sight = camera_.rayAt(mouse + grasp_);
  const double closest = (anchor_ - sight.origin).dot(sight.direction);
  const Vec3 foot = sight.origin + closest * sight.direction - anchor_;
  const double inside = radius_ * radius_ - foot.squaredNorm();
  if (inside <= 0) {
    return foot.normalized();  // beside the sphere: its rim
  }
  const double half = std::sqrt(inside);
  const bool front = (graspPoint_ - anchor_).dot(camera_.forward) <= 0;
  return (foot + (front ? -half : half) * sight.direction) / radius_;
}

ResectionPlane PlaneDrag::planeAt(const Pixel& mouse) const {
  return handle_ == PlaneHandle::Spin ? spun(start_, anchor_, spunAt(mouse)) : movedTo(start_, movedAt(mouse));
}

double PlaneDrag::spunAt(const Pixel& mouse) const {
  if (handle_ != PlaneHandle::Spin) {
    return 0;
  }
  const Vec3 from = graspPoint_ - anchor_;
  const Vec3 to = onPlane(mouse) - anchor_;
  return std::atan2(from.cross(to).dot(start_.normal), from.dot(to));
}

HalfSpace PlaneDrag::movedAt(const Pixel& mouse) const {
  if (handle_ == PlaneHandle::Normal) {
    return {start_.origin + (alongNormal(camera_, anchor_, start_.normal, mouse, grasp_) - graspAlong_) * start_.normal,
            start_.normal};
  }
  if (handle_ == PlaneHandle::Centre) {
    return {anchor_ + carried_ + (inPicture(mouse) - graspPoint_), start_.normal};
  }
  const Vec3 from = (graspPoint_ - anchor_) / radius_;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(from, onSphere(mouse));
  const Vec3 normal = (turn * start_.normal).normalized();
  return {turnedAbout(anchor_, anchor_ + carried_, start_.normal, normal), normal};
}

Vec3 PlaneDrag::anchorFor(const HalfSpace& plane) const {
  if (handle_ == PlaneHandle::Normal) {
    return anchor_ + (plane.origin - start_.origin);
  }
  return handle_ == PlaneHandle::Centre ? Vec3(plane.origin - carried_) : anchor_;
}

}  // namespace glisson
