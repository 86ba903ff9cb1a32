#pragma once
// Purpose: pointing in the 3D view: which clicks make a gesture, and what it is in the world. No drawing, no Qt. Frame: mm LPS for
// the world, logical pixels for the picture.

#include <functional>
#include <optional>
#include <vector>

#include "viewer/view_camera.h"

namespace glisson {

enum class PickKind : std::uint8_t {
  Point,        ///< one click on a surface
  Branch,       ///< one click on a vessel
  TwoPoints,    ///< two clicks on a surface; the camera may turn in between
  ThreePoints,  ///< three clicks on a surface; the camera may turn in between
  Line          ///< a stroke across the view, pressed, drawn and released
};

struct Pick {
  PickKind kind = PickKind::Point;
  std::vector<Vec3> points;  ///< on a surface; of a line: two points on the lines of sight through its ends
  ViewCamera camera;         ///< at the last of them
};

/// The point of the model seen at a pixel; nothing where none is.
using Look = std::function<std::optional<Vec3>(const Pixel&)>;

class PickTool {
 public:
  explicit PickTool(PickKind kind) : kind_(kind) {}
  [[nodiscard]] PickKind kind() const { return kind_; }
  /// A line takes the mouse for itself from press to release; the others only take clicks, so drags still turn the camera.
  [[nodiscard]] bool takesDrag() const { return kind_ == PickKind::Line; }

  void press(const Pixel& at);
  void move(const Pixel& at);
  /// The gesture where it is whole now.
  std::optional<Pick> release(const Pixel& at, const ViewCamera& camera, const Look& look);
  /// What to draw.
  [[nodiscard]] std::vector<Pixel> shown(const ViewCamera& camera) const;

 private:
  PickKind kind_;
  std::vector<Vec3> points_;
  std::optional<Pixel> pressed_;
  Pixel now_ = Pixel::Zero();
};

}  // namespace glisson
