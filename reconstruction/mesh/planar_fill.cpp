#include "reconstruction/mesh/planar_fill.h"

#include <algorithm>
#include <limits>

#include "reconstruction/mesh/triangulation.h"

namespace glisson {

namespace {
using planar::Face;
using planar::kNone;
using planar::next;
using planar::NoFill;
using planar::previous;
using planar::Triangulation;

/// How often the border runs from the lower to the upper of two points, less how often it runs back.
class NetBorder {
 public:
  explicit NetBorder(std::span<const BorderEdge> border) {
    for (const auto& [from, to] : border) {
      edges_.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) { return key(x) < key(y); });
  }
  [[nodiscard]] int along(std::uint32_t from, std::uint32_t to) const {
    const Edge wanted{std::min(from, to), std::max(from, to), 0};
    int sum = 0;
    for (auto at =
             std::lower_bound(edges_.begin(), edges_.end(), wanted, [](const Edge&x, const Edge&y) { return key(x) < key(y); });
         at != edges_.end() && key(*at) == key(wanted); ++at) {
      sum += at->sense;
    }
    return from < to ? sum : -sum;
  }

 private:
  struct Edge {
    std::uint32_t low;
    std::uint32_t high;
    int sense;
  };
  static std::uint64_t key(const Edge& e) { return (std::uint64_t{e.low} << 32U) | e.high; }
  std::vector<Edge> edges_;
};

/// The faces the border runs round once; throws NoFill where it runs round one in another way.
std::vector<Triangle> facesInside(const Triangulation& triangulation, const NetBorder& border) {
  const auto& faces = triangulation.faces();
  constexpr int kUnknown = std::numeric_limits<int>::min();
  std::vector<int> winding(faces.size(), kUnknown);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t n = 0; n < faces.size() && stack.empty(); ++n) {
    const Triangle& c = faces[n].corner;
    if (std::any_of(c.begin(), c.end(), [&](std::uint32_t p) { return triangulation.isSurrounding(p); })) {
      winding[n] = 0;
      stack.push_back(n);
    }
  }
  std::vector<Triangle> inside;
  while (!stack.empty()) {
    const std::uint32_t n = stack.back();
    stack.pop_back();
    const Face& f = faces[n];
    if (winding[n] != 0 && winding[n] != 1) {
      throw NoFill();
    }
    if (winding[n] == 1) {
      inside.push_back(f.corner);
    }
    for (std::size_t place = 0; place < 3; ++place) {
      const std::uint32_t across = f.beyond[place];
      if (across == kNone) {
        continue;
      }
      const int there = winding[n] - (f.fixed[place] ? border.along(f.corner[next(place)], f.corner[previous(place)]) : 0);
      if (winding[across] == kUnknown) {
        winding[across] = there;
        stack.push_back(across);
      } else if (winding[across] != there) {
        throw NoFill();
      }
    }
  }
  return inside;
}
}  // namespace

std::optional<std::vector<Triangle>> fillRegion(std::span<const Vec2> points, std::span<const BorderEdge> border) {
  if (points.size() < 3 || border.size() < 3) {
    return std::nullopt;
  }
  try {
    Triangulation triangulation(points);
    for (const auto& [from, to] : border) {
      triangulation.fix(from, to);
    }
    return facesInside(triangulation, NetBorder(border));
  } catch (const NoFill&) {
    return std::nullopt;
  }
}

}  // namespace glisson
