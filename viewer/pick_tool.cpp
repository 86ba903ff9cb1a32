#include "viewer/pick_tool.h"

#include <algorithm>
#include <iterator>

namespace glisson {

namespace {
constexpr double kClickPixels = 4;    ///< the mouse moves a little in a click
constexpr double kStrokePixels = 12;  ///< a shorter stroke has no direction
constexpr double kAheadMm = 100;      ///< a line's ends are named this far from the eye

/// Of a gesture of clicks.
std::size_t clicksOf(PickKind kind) {
  switch (kind) {
    case PickKind::Point:
    case PickKind::Branch:
      return 1;
    case PickKind::TwoPoints:
      return 2;
    case PickKind::ThreePoints:
    case PickKind::Line:
      break;
  }
  return 3;
}
}  // namespace

void PickTool::press(const Pixel& at) {
  pressed_ = at;
  now_ = at;
}

void PickTool::move(const Pixel& at) { now_ = at; }

std::optional<Pick> PickTool::release(const Pixel& at, const ViewCamera& camera, const Look& look) {
  if (!pressed_) {
    return std::nullopt;
  }
  const Pixel from = *pressed_;
  pressed_.reset();
  const double moved = (at - from).norm();
  if (kind_ == PickKind::Line) {
    if (moved < kStrokePixels) {
      return std::nullopt;
    }
    const auto ahead = [&](const Pixel& pixel) {
      const Ray ray = camera.rayAt(pixel);
      return Vec3(ray.origin + kAheadMm * ray.direction);
    };
    return Pick{kind_, {ahead(from), ahead(at)}, camera};
  }
  if (moved > kClickPixels) {
    return std::nullopt;  // the camera was turned
  }
  if (const std::optional<Vec3> point = look(at)) {
    points_.push_back(*point);
  }
  if (points_.size() < clicksOf(kind_)) {
    return std::nullopt;
  }
  return Pick{kind_, points_, camera};
}

std::vector<Pixel> PickTool::shown(const ViewCamera& camera) const {
  if (kind_ == PickKind::Line) {
    return pressed_ ? std::vector<Pixel>{*pressed_, now_} : std::vector<Pixel>{};
  }
  std::vector<Pixel> pixels;
  std::ranges::transform(points_, std::back_inserter(pixels), [&](const Vec3& point) { return camera.toPixel(point); });
  return pixels;
}

}  // namespace glisson
