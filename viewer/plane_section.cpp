#include "viewer/plane_section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "reconstruction/mesh/planar_fill.h"
#include "viewer/segment.h"

namespace glisson {

namespace {

using Point2 = Eigen::Vector2d;

constexpr std::uint32_t kNone = 0xffffffffU;

/// A point of the section lies on a mesh edge; each has up to two neighbours on a closed mesh.
struct SectionPoint {
  Vec3 at = Vec3::Zero();
  std::vector<std::uint32_t> neighbours;
  bool used = false;
};

class SectionBuilder {
 public:
  SectionBuilder(const SurfaceMesh& mesh, const ResectionPlane& plane) : mesh_(mesh) {
    distance_.reserve(mesh.vertices.size());
    const std::optional<BentSurface> bent = plane.bend ? std::optional(BentSurface(plane)) : std::nullopt;
    for (const Vec3& vertex : mesh.vertices) {
      distance_.push_back(bent ? bent->above(vertex) : plane.normal.dot(vertex - plane.origin));
    }
  }

  std::vector<Loop> loops() {
    for (const Triangle& t : mesh_.triangles) {
      addSegment(t);
    }
    std::vector<Loop> result;
    for (std::uint32_t start = 0; start < points_.size(); ++start) {
      Loop loop;
      for (std::uint32_t at = start; at != kNone && !points_[at].used; at = nextUnused(at)) {
        points_[at].used = true;
        loop.push_back(points_[at].at);
      }
      if (loop.size() >= 3) {
        result.push_back(std::move(loop));
      }
    }
    return result;
  }

 private:
  /// A vertex on the plane counts as above it, so every crossed triangle has exactly two crossed edges.
  [[nodiscard]] bool above(std::uint32_t vertex) const { return distance_[vertex] >= 0; }

  std::uint32_t pointOn(std::uint32_t a, std::uint32_t b) {
    if (a > b) {
      std::swap(a, b);
    }
    const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32U) | b;
    const auto [place, isNew] = pointAt_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (isNew) {
      const double t = distance_[a] / (distance_[a] - distance_[b]);
      points_.push_back({mesh_.vertices[a] + t * (mesh_.vertices[b] - mesh_.vertices[a]), {}, false});
    }
    return place->second;
  }

  void addSegment(const Triangle& t) {
    if (above(t[0]) == above(t[1]) && above(t[1]) == above(t[2])) {
      return;
    }
    std::array<std::uint32_t, 2> ends{kNone, kNone};
    std::size_t found = 0;
    for (std::size_t e = 0; e < 3 && found < 2; ++e) {
      if (above(t[e]) != above(t[(e + 1) % 3])) {
        ends[found++] = pointOn(t[e], t[(e + 1) % 3]);
      }
    }
    points_[ends[0]].neighbours.push_back(ends[1]);
    points_[ends[1]].neighbours.push_back(ends[0]);
  }

  [[nodiscard]] std::uint32_t nextUnused(std::uint32_t at) const {
    for (const std::uint32_t next : points_[at].neighbours) {
      if (!points_[next].used) {
        return next;
      }
    }
    return kNone;
  }

  const SurfaceMesh& mesh_;
  std::vector<double> distance_;
  std::vector<SectionPoint> points_;
  std::unordered_map<std::uint64_t, std::uint32_t> pointAt_;
};

Point2 inPlane(const Vec3& point, const HalfSpace& plane, const PlaneAxes& axes) {
  return {axes.u.dot(point - plane.origin), axes.v.dot(point - plane.origin)};
}

std::vector<std::vector<Point2>> inPlane(const std::vector<Loop>& loops, const HalfSpace& plane, const PlaneAxes& axes) {
  std::vector<std::vector<Point2>> flat;
  for (const Loop& loop : loops) {
    std::vector<Point2>& points = flat.emplace_back();
    for (const Vec3& point : loop) {
      points.push_back(inPlane(point, plane, axes));
    }
  }
  return flat;
}

/// Sorted first coordinates at which the line "second coordinate = height" crosses the loops. `swapped` exchanges the coordinates.
std::vector<double> crossings(const std::vector<std::vector<Point2>>& loops, double height, bool swapped) {
  const Eigen::Index along = swapped ? 1 : 0;
  const Eigen::Index across = swapped ? 0 : 1;
  std::vector<double> at;
  for (const auto& loop : loops) {
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const Point2& a = loop[n];
      const Point2& b = loop[(n + 1) % loop.size()];
      if ((a[across] >= height) != (b[across] >= height)) {
        at.push_back(a[along] + (height - a[across]) / (b[across] - a[across]) * (b[along] - a[along]));
      }
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

}  // namespace

PlaneAxes axesOf(const Vec3& normal) {
  const Vec3 reference = std::abs(normal.z()) < 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
  const Vec3 v = (reference - reference.dot(normal) * normal).normalized();
  return {v.cross(normal), v};
}

std::vector<Loop> sectionLoops(const SurfaceMesh& mesh, const ResectionPlane& plane) { return SectionBuilder(mesh, plane).loops(); }

bool isInside(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point) {
  const PlaneAxes axes = axesOf(plane.normal);
  const Point2 at = inPlane(point, plane, axes);
  const std::vector<double> along = crossings(inPlane(loops, plane, axes), at.y(), false);
  return std::count_if(along.begin(), along.end(), [&](double u) { return u > at.x(); }) % 2 == 1;
}

std::vector<std::pair<Vec3, Vec3>> gridLines(const std::vector<Loop>& loops, const HalfSpace& plane, double spacingMm) {
  const PlaneAxes axes = axesOf(plane.normal);
  const auto flat = inPlane(loops, plane, axes);
  Eigen::AlignedBox2d box;
  for (const auto& loop : flat) {
    for (const Point2& point : loop) {
      box.extend(point);
    }
  }
  std::vector<std::pair<Vec3, Vec3>> lines;
  if (box.isEmpty()) {
    return lines;
  }
  for (const bool swapped : {false, true}) {
    const Eigen::Index across = swapped ? 0 : 1;
    const Vec3& alongAxis = swapped ? axes.v : axes.u;
    const Vec3& acrossAxis = swapped ? axes.u : axes.v;
    const auto first = static_cast<long>(std::ceil(box.min()[across] / spacingMm));
    const auto last = static_cast<long>(std::floor(box.max()[across] / spacingMm));
    for (long n = first; n <= last; ++n) {
      const double height = static_cast<double>(n) * spacingMm;
      const std::vector<double> at = crossings(flat, height, swapped);
      const Vec3 base = plane.origin + height * acrossAxis;
      for (std::size_t c = 0; c + 1 < at.size(); c += 2) {
        lines.emplace_back(base + at[c] * alongAxis, base + at[c + 1] * alongAxis);
      }
    }
  }
  return lines;
}

std::vector<std::pair<Vec3, Vec3>> gridLines(const std::vector<Loop>& loops, const BentSurface& surface, double spacingMm) {
  constexpr double kPieceMm = 2;
  std::vector<std::pair<Vec3, Vec3>> pieces;
  for (const auto& [from, to] : gridLines(loops, HalfSpace{surface.origin(), surface.normal()}, spacingMm)) {
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kPieceMm)));
    for (int n = 0; n < count; ++n) {
      pieces.emplace_back(surface.foot(from + (to - from) * n / count), surface.foot(from + (to - from) * (n + 1) / count));
    }
  }
  return pieces;
}

namespace {
/// Of the loops' shadows: counter-clockwise outside, clockwise around holes.
void orient(std::vector<std::vector<Point2>>& loops) {
  for (std::size_t n = 0; n < loops.size(); ++n) {
    std::size_t around = 0;
    for (std::size_t m = 0; m < loops.size(); ++m) {
      if (m != n) {
        const std::vector<double> along = crossings({loops[m]}, loops[n].front().y(), false);
        around += std::count_if(along.begin(), along.end(), [&](double u) { return u > loops[n].front().x(); }) % 2 == 1 ? 1 : 0;
      }
    }
    double doubled = 0;
    for (std::size_t k = 0; k < loops[n].size(); ++k) {
      const Point2& a = loops[n][k];
      const Point2& b = loops[n][(k + 1) % loops[n].size()];
      doubled += a.x() * b.y() - a.y() * b.x();
    }
    if ((doubled > 0) != (around % 2 == 0)) {
      std::reverse(loops[n].begin(), loops[n].end());
    }
  }
}

}  // namespace

SurfaceMesh filled(const std::vector<Loop>& loops, const BentSurface& surface, double stepMm) {
  const HalfSpace plane{surface.origin(), surface.normal()};
  const PlaneAxes axes = axesOf(plane.normal);
  std::vector<std::vector<Point2>> flat = inPlane(loops, plane, axes);
  for (auto& loop : flat) {
    // Where the surface meets a vertex of the mesh, several edges have their crossing there, within rounding.
    const auto same = [](const Point2& a, const Point2& b) { return (a - b).squaredNorm() < 1e-10; };
    loop.erase(std::unique(loop.begin(), loop.end(), same), loop.end());
    while (loop.size() > 1 && same(loop.front(), loop.back())) {
      loop.pop_back();
    }
  }
  std::erase_if(flat, [](const auto& loop) { return loop.size() < 3; });
  orient(flat);
  std::vector<Vec2> points;
  std::vector<BorderEdge> border;
  Eigen::AlignedBox2d box;
  for (const auto& loop : flat) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto count = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t n = 0; n < count; ++n) {
      points.push_back(loop[n]);
      border.push_back({first + n, first + (n + 1) % count});
      box.extend(loop[n]);
    }
  }
  if (border.empty()) {
    return {};
  }
  constexpr double kClear = 0.4;
  const auto rows = static_cast<int>(std::ceil(box.sizes().y() / stepMm - 0.5));
  for (int row = 0; row < rows; ++row) {
    const double v = box.min().y() + (row + 0.5) * stepMm;
    const std::vector<double> at = crossings(flat, v, false);
    for (std::size_t c = 0; c + 1 < at.size(); c += 2) {
      const auto first = static_cast<int>(std::ceil(at[c] / stepMm));
      const auto last = static_cast<int>(std::floor(at[c + 1] / stepMm));
      for (int column = first; column <= last; ++column) {
        const Point2 p(column * stepMm, v);
        const bool clear = std::ranges::all_of(border, [&](const BorderEdge& edge) {
          return std::abs(points[edge[0]].y() - v) > 3 * stepMm ||
                 distanceToSegment(p, points[edge[0]], points[edge[1]]) > kClear * stepMm;
        });
        if (clear) {
          points.push_back(p);
        }
      }
    }
  }
  SurfaceMesh mesh;
  const auto triangles = fillRegion(points, border);
  if (!triangles) {
    return mesh;
  }
  mesh.triangles = *triangles;
  for (const Vec2& p : points) {
    mesh.vertices.push_back(surface.foot(plane.origin + p.x() * axes.u + p.y() * axes.v));
  }
  return mesh;
}

Vec3 centreOf(const std::vector<Loop>& loops, const HalfSpace& plane) {
  const PlaneAxes axes = axesOf(plane.normal);
  // The largest loop decides; holes and small pieces move the centre of a section little.
  double largest = 0;
  Point2 centre = Point2::Zero();
  for (const auto& loop : inPlane(loops, plane, axes)) {
    double doubled = 0;
    Point2 moment = Point2::Zero();
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const Point2& a = loop[n];
      const Point2& b = loop[(n + 1) % loop.size()];
      const double cross = a.x() * b.y() - a.y() * b.x();
      doubled += cross;
      moment += cross * (a + b);
    }
    if (std::abs(doubled) > largest) {
      largest = std::abs(doubled);
      centre = moment / (3.0 * doubled);
    }
  }
  return plane.origin + centre.x() * axes.u + centre.y() * axes.v;
}

double reach(const std::vector<Loop>& loops, const HalfSpace& plane, const Vec3& point, const Vec3& direction) {
  const Vec3 side = plane.normal.cross(direction);
  double farthest = 0;
  for (const Loop& loop : loops) {
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const Vec3 a = loop[n] - point;
      const Vec3 b = loop[(n + 1) % loop.size()] - point;
      const double sideA = a.dot(side);
      const double sideB = b.dot(side);
      if ((sideA >= 0) != (sideB >= 0)) {
        farthest = std::max(farthest, (a + sideA / (sideA - sideB) * (b - a)).dot(direction));
      }
    }
  }
  return farthest;
}

}  // namespace glisson
