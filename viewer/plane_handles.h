#pragma once
// Purpose: the handles of the resection plane without any drawing: where they stand, which one the mouse is over, and which plane
// a drag gives. Pure values. Frame: mm LPS for the world, logical pixels for the picture.

#include <array>
#include <optional>
#include <vector>

#include "planning/resection/bend.h"
#include "viewer/plane_section.h"
#include "viewer/view_camera.h"

namespace glisson {

enum class PlaneHandle { Centre, Normal, TiltRight, TiltUp, TiltLeft, TiltDown, Spin };

/// Whether it turns the plane about an axis within it.
bool isTilt(PlaneHandle handle);

inline constexpr double kHandlePixels = 8.0;  ///< radius of the spheres
inline constexpr double kArrowPixels = 80.0;  ///< length of the arrow along the normal
/// Half of the room the word at the arrow takes, in every language; it stays inside the view.
inline constexpr double kLabelHalfWidth = 46.0;
inline constexpr double kLabelHalfHeight = 14.0;

struct HandleLayout {
  Vec3 anchor = Vec3::Zero();  ///< centre sphere, foot of the arrow, pivot of a tilt
  Vec3 arrowTip = Vec3::Zero();
  Vec3 label = Vec3::Zero();        ///< middle of the word at the arrow; beside the handles also where the arrow is seen end-on
  std::array<Vec3, 4> tilts{};      ///< TiltRight, TiltUp, TiltLeft, TiltDown, on the border of the section
  std::array<bool, 4> tiltShown{};  ///< false where it would lie over the centre (seen edge-on)
  Vec3 spin = Vec3::Zero();         ///< on the border, between TiltRight and TiltUp
  bool spinShown = false;           ///< false where the plane is seen too flat to be turned within itself
  double mmPerPixel = 1;            ///< at the anchor: handles keep their size on the screen
};

/// Where the handles of `plane` stand: along u and v of its bend, or, of a flat one, along axesOf() turned by `spun` radians. The
/// anchor is the plane's origin where that lies inside the section, else the section's centre.
Vec3 anchorOf(const HalfSpace& plane, const std::vector<Loop>& section);
HandleLayout layoutHandles(const ResectionPlane& plane, const Vec3& anchor, const std::vector<Loop>& section,
                           const ViewCamera& camera, double spun = 0);

/// The handle under the mouse, or nothing.
std::optional<PlaneHandle> handleAt(const HandleLayout& layout, const ViewCamera& camera, const Pixel& mouse);

/// How far along `normal`, a line through `anchor`, the mouse is, mm: the point of the line nearest to the line of sight. Seen
/// end-on, up on the screen from `grasp` is away from the viewer.
double alongNormal(const ViewCamera& camera, const Vec3& anchor, const Vec3& normal, const Pixel& mouse, const Pixel& grasp);

/// Where `origin` is once the plane through it has been turned about `pivot` from normal to normal, as movedTo() turns its bend.
Vec3 turnedAbout(const Vec3& pivot, const Vec3& origin, const Vec3& from, const Vec3& to);

/// One drag from grasp to release. The camera does not move meanwhile.
class PlaneDrag {
 public:
  PlaneDrag(PlaneHandle handle, const ResectionPlane& plane, const HandleLayout& layout, const ViewCamera& camera,
            const Pixel& mouse);
  /// The plane for the mouse at `mouse`: Normal moves it along its normal, Centre takes its origin along in the picture's plane,
  /// Tilt turns it about the anchor. A flat plane has its origin at the anchor then; a bent one, whose square is about its origin,
  /// moves as a rigid body. Spin turns a bent one about its normal and leaves a flat one as it is.
  [[nodiscard]] ResectionPlane planeAt(const Pixel& mouse) const;
  /// How far Spin has turned, radians, right-handed about the normal; 0 of the other handles.
  [[nodiscard]] double spunAt(const Pixel& mouse) const;
  [[nodiscard]] PlaneHandle handle() const { return handle_; }
  [[nodiscard]] const ResectionPlane& start() const { return start_; }
  /// Where the anchor is for a plane of this drag.
  [[nodiscard]] Vec3 anchorFor(const HalfSpace& plane) const;

 private:
  [[nodiscard]] HalfSpace movedAt(const Pixel& mouse) const;
  [[nodiscard]] Vec3 inPicture(const Pixel& mouse) const;
  [[nodiscard]] Vec3 onPlane(const Pixel& mouse) const;  ///< of Spin
  [[nodiscard]] Vec3 onSphere(const Pixel& mouse) const;

  PlaneHandle handle_;
  ResectionPlane start_;
  Vec3 anchor_;
  Vec3 carried_ = Vec3::Zero();  ///< from the anchor to the origin
  double radius_ = 1;
  ViewCamera camera_;
  Pixel grasp_;
  double graspAlong_ = 0;
  Vec3 graspPoint_ = Vec3::Zero();
};

}  // namespace glisson
