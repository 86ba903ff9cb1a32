#include "reconstruction/mesh/cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/cut_section.h"
#include "reconstruction/mesh/edges.h"
#include "reconstruction/mesh/refine.h"
#include "reconstruction/mesh/self_intersection.h"

namespace glisson {

using namespace cutting;

namespace {
constexpr double kVolumeTolerance = 1e-9;

class Splitter {
 public:
  Splitter(const SurfaceMesh& mesh, const Shape& shape, const Grid& grid)
      : mesh_(mesh), shape_(shape), normal_(shape.plane.normal), grid_(grid) {
    split_.vertices = mesh.vertices;
    heights_.reserve(mesh.vertices.size());
    split_.onPlane.reserve(mesh.vertices.size());
    for (Vec3& v : split_.vertices) {
      const double height = shape.height(v);
      split_.onPlane.push_back(std::abs(height) <= grid.onPlaneMm);
      heights_.push_back(split_.onPlane.back() ? 0.0 : height);
      if (grid.floats && split_.onPlane.back()) {
        v = grid.place(v - height * normal_);
      }
    }
  }

  Split run() {
    for (const Triangle& t : mesh_.triangles) {
      add(t);
    }
    return std::move(split_);
  }

 private:
  [[nodiscard]] int side(std::uint32_t v) const { return heights_[v] > 0 ? 1 : (heights_[v] < 0 ? -1 : 0); }

  void add(const Triangle& t) {
    const std::array<int, 3> s{side(t[0]), side(t[1]), side(t[2])};
    const int low = std::min({s[0], s[1], s[2]});
    const int high = std::max({s[0], s[1], s[2]});
    if (low == 0 && high == 0) {
      // In the plane: what it bounds lies against its normal.
      const Vec3& a = split_.vertices[t[0]];
      const bool facesUp = (split_.vertices[t[1]] - a).cross(split_.vertices[t[2]] - a).dot(normal_) > 0;
      (facesUp ? split_.below : split_.above).push_back(t);
    } else if (low >= 0) {
      split_.above.push_back(t);
    } else if (high <= 0) {
      split_.below.push_back(t);
    } else {
      divide(t, s);
    }
  }

  /// A triangle with corners on both sides.
  void divide(const Triangle& t, const std::array<int, 3>& s) {
    for (std::size_t n = 0; n < 3; ++n) {
      const std::uint32_t a = t[n];
      const std::uint32_t b = t[(n + 1) % 3];
      const std::uint32_t c = t[(n + 2) % 3];
      const int sb = s[(n + 1) % 3];
      const int sc = s[(n + 2) % 3];
      if (s[n] == 0) {
        const std::uint32_t p = crossing(b, c);
        part(sb).push_back({a, b, p});
        part(sc).push_back({a, p, c});
        return;
      }
      if (s[n] * sb < 0 && s[n] * sc < 0) {
        const std::uint32_t p = crossing(a, b);
        const std::uint32_t q = crossing(c, a);
        part(s[n]).push_back({a, p, q});
        const auto& v = split_.vertices;
        if ((v[b] - v[q]).squaredNorm() < (v[c] - v[p]).squaredNorm()) {
          part(sb).push_back({p, b, q});
          part(sb).push_back({b, c, q});
        } else {
          part(sb).push_back({p, b, c});
          part(sb).push_back({p, c, q});
        }
        return;
      }
    }
  }

  std::vector<Triangle>& part(int s) { return s > 0 ? split_.above : split_.below; }

  /// The vertex where an edge meets the plane, one for both its triangles.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (a > b) {
      std::swap(a, b);
    }
    const auto [found, isNew] = crossings_.try_emplace({a, b}, static_cast<std::uint32_t>(split_.vertices.size()));
    if (isNew) {
      const double share = shape_.crossing(mesh_.vertices[a], mesh_.vertices[b], heights_[a], heights_[b]);
      const Vec3 point = mesh_.vertices[a] + share * (mesh_.vertices[b] - mesh_.vertices[a]);
      split_.vertices.push_back(grid_.place(point));
      split_.onPlane.push_back(true);
    }
    return found->second;
  }

  const SurfaceMesh& mesh_;
  const Shape& shape_;
  Vec3 normal_;
  Grid grid_;
  std::vector<double> heights_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  Split split_;
};

/// Drops triangles that lost a corner and pairs of triangles folded onto each other: they enclose nothing.
void dropCollapsed(std::vector<Triangle>& triangles) {
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const auto fromSmallest = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::set<Triangle> all;
  for (const Triangle& t : triangles) {
    all.insert(fromSmallest(t));
  }
  std::erase_if(triangles, [&](const Triangle& t) {
    const Triangle f = fromSmallest(t);
    return all.contains({f[0], f[2], f[1]});
  });
}

/// Lets vertices of the section that lie at one place be one vertex. Where that joins fans they are parted again by splitFans.
void weldOnPlane(Split& split) {
  std::vector<std::uint32_t> on;
  for (const auto* part : {&split.above, &split.below}) {
    for (const BorderEdge& side : sidesOnPlane(*part, split.onPlane)) {
      on.push_back(side[0]);
    }
  }
  std::sort(on.begin(), on.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3& p = split.vertices[a];
    const Vec3& q = split.vertices[b];
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  });
  on.erase(std::unique(on.begin(), on.end()), on.end());
  std::map<std::uint32_t, std::uint32_t> same;
  for (std::size_t n = 1; n < on.size(); ++n) {
    if (split.vertices[on[n]] == split.vertices[on[n - 1]]) {
      const auto first = same.find(on[n - 1]);
      same[on[n]] = first == same.end() ? on[n - 1] : first->second;
    }
  }
  if (same.empty()) {
    return;
  }
  for (auto* part : {&split.above, &split.below}) {
    for (Triangle& t : *part) {
      for (std::uint32_t& corner : t) {
        const auto found = same.find(corner);
        corner = found == same.end() ? corner : found->second;
      }
    }
    dropCollapsed(*part);
  }
}

SurfaceMesh closedPart(const Split& split, std::vector<Triangle> surface, bool turnSection) {
  SurfaceMesh part{split.vertices, std::move(surface)};
  for (Triangle t : split.section) {
    if (turnSection) {
      std::swap(t[1], t[2]);
    }
    part.triangles.push_back(t);
  }
  dropUnusedVertices(part);
  splitFans(part);
  return part;
}

bool isSound(const SurfaceMesh& part) { return part.empty() || !part.defects().any(); }

/// The cut at one surface; nothing where a half would not be sound.
std::optional<CutResult> tryCut(const SurfaceMesh& mesh, const Shape& shape, const Grid& grid, double volume) {
  Split split = Splitter(mesh, shape, grid).run();
  weldOnPlane(split);
  if (!fillSection(split, shape, grid)) {
    return std::nullopt;
  }
  if (grid.floats) {
    SurfaceMesh moved{split.vertices, split.above};
    moved.triangles.insert(moved.triangles.end(), split.below.begin(), split.below.end());
    volume = signedVolumeMm3(moved);
  }
  CutResult result;
  result.section = {split.vertices, split.section};
  dropUnusedVertices(result.section);
  result.positive = closedPart(split, std::move(split.above), true);
  result.negative = closedPart(split, std::move(split.below), false);
  const double sum = signedVolumeMm3(result.positive) + signedVolumeMm3(result.negative);
  if (!isSound(result.positive) || !isSound(result.negative) || !(std::abs(sum - volume) <= kVolumeTolerance * volume)) {
    return std::nullopt;
  }
  return result;
}

/// Do triangles that the cut made or moved meet others?
bool crossesItself(const SurfaceMesh& part, const Shape& shape, double nearMm, const ExecutionContext& context) {
  std::vector<std::uint32_t> atPlane;
  for (std::uint32_t n = 0; n < part.triangles.size(); ++n) {
    const Triangle& t = part.triangles[n];
    if (std::any_of(t.begin(), t.end(),
                    [&](std::uint32_t corner) { return std::abs(shape.height(part.vertices[corner])) <= nearMm; })) {
      atPlane.push_back(n);
    }
  }
  return !atPlane.empty() && !selfIntersections(part, atPlane, context).empty();
}

Vec3 unitNormal(const HalfSpace& plane) {
  const double length = plane.normal.norm();
  if (!plane.origin.allFinite() || !std::isfinite(length) || length == 0) {
    throw ReconstructionError("The cutting plane has no direction; place it again.");
  }
  return plane.normal / length;
}

void requireNoDefects(const SurfaceMesh& mesh) {
  const MeshDefects defects = mesh.defects();
  if (defects.any()) {
    throw CheckFailed("The mesh cannot be cut because it has defects (" + defects.names().front() + "); reconstruct it again.");
  }
}

[[noreturn]] void throwNoSoundCut() {
  throw CheckFailed("The mesh cannot be cut cleanly by this plane; move the plane by a fraction of a millimetre.");
}
}  // namespace

CutResult cut(const SurfaceMesh& mesh, const HalfSpace& plane, const ExecutionContext& context) {
  const Vec3 normal = unitNormal(plane);
  requireNoDefects(mesh);
  const double volume = signedVolumeMm3(mesh);
  // A section that touches itself within rounding cannot be filled; a few on-plane tolerances further on it can.
  for (const double step : {0.0, 2.5, -2.5, 6.1, -6.1, 13.3, -13.3, 31.7, -31.7}) {
    context.throwIfCancelled();
    auto result = tryCut(mesh, {.plane = {plane.origin + step * kOnPlaneMm * normal, normal}}, {}, volume);
    if (result) {
      return std::move(*result);
    }
  }
  throwNoSoundCut();
}

double floatSpacingMm(const SurfaceMesh& mesh) {
  const Bounds bounds = boundsOf(mesh);
  const auto farthest = static_cast<float>(std::max(bounds.low.cwiseAbs().maxCoeff(), bounds.high.cwiseAbs().maxCoeff()));
  return static_cast<double>(std::nextafter(farthest, std::numeric_limits<float>::infinity())) - static_cast<double>(farthest);
}

namespace {
CutResult cutForFloats(const SurfaceMesh& mesh, const Shape& shape, const ExecutionContext& context) {
  requireNoDefects(mesh);
  const double spacing = floatSpacingMm(mesh);
  // Vertices nearer to the plane than this would leave triangles that rounding can turn over; where a tolerance or a plane still
  // leaves some, another does not.
  for (const double onPlane : {8.0, 16.0, 4.0, 32.0, 2.0}) {
    for (const double step : {0.0, 3.0, -3.0, 7.0, -7.0}) {
      context.throwIfCancelled();
      const Shape moved = shape.movedBy(step * spacing);
      auto result = tryCut(mesh, moved, {onPlane * spacing, true}, 0);
      const double near = (onPlane + 2) * spacing;
      if (result && !crossesItself(result->positive, moved, near, context) &&
          !crossesItself(result->negative, moved, near, context)) {
        return std::move(*result);
      }
    }
  }
  throwNoSoundCut();
}
}  // namespace

CutResult cutForFloats(const SurfaceMesh& mesh, const HalfSpace& plane, const ExecutionContext& context) {
  return cutForFloats(mesh, Shape{.plane = {plane.origin, unitNormal(plane)}}, context);
}

CutResult cutForFloats(const SurfaceMesh& mesh, const CuttingSurface& surface, const ExecutionContext& context) {
  Shape shape{.plane = {surface.plane.origin, unitNormal(surface.plane)}, .above = &surface.above};
  // A triangle whose corners lie on the surface and on a circle of this radius leaves it by half of what is allowed.
  constexpr double kLeastStepMm = 0.5;
  constexpr double kMostStepMm = 20;
  shape.stepMm = surface.mostCurved > 0 ? std::sqrt(kCurvedCutMm / surface.mostCurved) : kMostStepMm;
  shape.stepMm = std::clamp(shape.stepMm, kLeastStepMm, kMostStepMm);
  const double longest = 2 * shape.stepMm;
  const double near = shape.stepMm;  // an edge this short cannot come nearer than the curve between its ends
  const SurfaceMesh fine = splitLongEdges(mesh, longest, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::array<double, 3> heights{shape.height(a), shape.height(b), shape.height(c)};
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    return *least <= near && *most >= -near;
  });
  return cutForFloats(fine, shape, context);
}

}  // namespace glisson
