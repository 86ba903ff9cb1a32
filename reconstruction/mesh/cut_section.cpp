#include "reconstruction/mesh/cut_section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace glisson::cutting {

double Shape::crossing(const Vec3& a, const Vec3& b, double heightA, double heightB) const {
  double share = heightA / (heightA - heightB);
  if (above == nullptr) {
    return share;
  }
  // Regula falsi with Illinois' halving; what is left at the end is far below a float's rounding.
  double low = 0;
  double high = 1;
  double atLow = heightA;
  double atHigh = heightB;
  constexpr int kTurns = 60;
  constexpr double kSettledMm = 1e-11;
  for (int turn = 0; turn < kTurns; ++turn) {
    share = low + (high - low) * atLow / (atLow - atHigh);
    const double at = height(a + share * (b - a));
    if (std::abs(at) <= kSettledMm) {
      break;
    }
    if ((at > 0) == (atHigh > 0)) {
      high = share;
      atHigh = at;
      atLow *= 0.5;
    } else {
      low = share;
      atLow = at;
      atHigh *= 0.5;
    }
  }
  return share;
}

Shape Shape::movedBy(double mm) const {
  Shape moved = *this;
  moved.plane.origin += mm * plane.normal;
  moved.lift += mm;
  return moved;
}

std::vector<BorderEdge> sidesOnPlane(const std::vector<Triangle>& triangles, const std::vector<bool>& onPlane) {
  std::vector<BorderEdge> sides;
  for (const Triangle& t : triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      const std::uint32_t a = t[n];
      const std::uint32_t b = t[(n + 1) % 3];
      if (onPlane[a] && onPlane[b]) {
        sides.push_back({a, b});
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

namespace {
/// Two directions that span the plane, e1 x e2 = normal; exact for a normal along an axis.
std::array<Vec3, 2> basisOf(const Vec3& normal) {
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vec3 axis = Vec3::Unit(least);
  const Vec3 e1 = (axis - normal * normal.dot(axis)).normalized();
  return {e1, normal.cross(e1)};
}

/// A side the section shares with an edge of the surface that touches the plane inside the section would have four triangles in one
/// half: it gets a vertex of its own in its middle.
void partFromTouchingEdges(Split& split, const std::set<BorderEdge>& touching, const Grid& grid) {
  const auto replaceSide = [&](std::size_t n, std::size_t k, std::uint32_t middle) {
    const Triangle t = split.section[n];
    split.section[n] = {t[k], middle, t[(k + 2) % 3]};
    split.section.push_back({middle, t[(k + 1) % 3], t[(k + 2) % 3]});
  };
  for (std::size_t n = 0; n < split.section.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = split.section[n][k];
      const std::uint32_t b = split.section[n][(k + 1) % 3];
      if (!touching.contains(std::minmax({a, b}) == std::pair(a, b) ? BorderEdge{a, b} : BorderEdge{b, a})) {
        continue;
      }
      const auto middle = static_cast<std::uint32_t>(split.vertices.size());
      const Vec3 between = grid.place(0.5 * (split.vertices[a] + split.vertices[b]));
      split.vertices.push_back(between);
      split.onPlane.push_back(true);
      replaceSide(n, k, middle);
      for (std::size_t other = 0; other < split.section.size(); ++other) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (split.section[other][j] == b && split.section[other][(j + 1) % 3] == a) {
            replaceSide(other, j, middle);
          }
        }
      }
      k = static_cast<std::size_t>(-1);  // the triangle has new sides
    }
  }
}

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Points `step` apart inside the border, none so near to it that a sliver would come of it.
std::vector<Vec2> innerPoints(const std::vector<Vec2>& points, const std::vector<BorderEdge>& border, double step) {
  constexpr double kClear = 0.45;
  Vec2 low = points.front();
  Vec2 high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Vec2> inner;
  const auto rows = static_cast<int>(std::ceil((high.y() - low.y()) / step - 0.5));
  for (int row = 0; row < rows; ++row) {
    const double y = low.y() + (row + 0.5) * step;
    std::vector<double> crossings;
    std::vector<BorderEdge> near;
    for (const BorderEdge& edge : border) {
      const Vec2& a = points[edge[0]];
      const Vec2& b = points[edge[1]];
      if ((a.y() >= y) != (b.y() >= y)) {
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
      if (std::min(a.y(), b.y()) < y + step && std::max(a.y(), b.y()) > y - step) {
        near.push_back(edge);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t n = 0; n + 1 < crossings.size(); n += 2) {
      const auto first = static_cast<int>(std::ceil((crossings[n] - low.x()) / step));
      const auto last = static_cast<int>(std::floor((crossings[n + 1] - low.x()) / step));
      for (int column = first; column <= last; ++column) {
        const Vec2 p(low.x() + column * step, y);
        if (std::all_of(near.begin(), near.end(),
                        [&](const BorderEdge& e) { return distanceToSegment(p, points[e[0]], points[e[1]]) > kClear * step; })) {
          inner.push_back(p);
        }
      }
    }
  }
  return inner;
}
}  // namespace

bool fillSection(Split& split, const Shape& shape, const Grid& grid) {
  const std::vector<BorderEdge> below = sidesOnPlane(split.below, split.onPlane);
  std::vector<BorderEdge> border;  // the section lies left of it, seen against the normal
  std::set<BorderEdge> touching;   // edges in the plane with both triangles on one side
  const auto sort = [&](const std::vector<BorderEdge>& sides, bool collect) {
    for (const BorderEdge& side : sides) {
      const BorderEdge back{side[1], side[0]};
      if (std::binary_search(sides.begin(), sides.end(), back)) {
        touching.insert(std::min(side, back));
      } else if (collect) {
        border.push_back(back);
      }
    }
  };
  sort(below, true);
  sort(sidesOnPlane(split.above, split.onPlane), false);
  if (border.empty()) {
    return true;
  }
  std::vector<std::uint32_t> corners;
  for (const BorderEdge& edge : border) {
    corners.push_back(edge[0]);
    corners.push_back(edge[1]);
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto [e1, e2] = basisOf(shape.plane.normal);
  std::vector<Vec2> points;
  points.reserve(corners.size());
  for (const std::uint32_t v : corners) {
    points.emplace_back(e1.dot(split.vertices[v]), e2.dot(split.vertices[v]));
  }
  for (BorderEdge& edge : border) {
    for (std::uint32_t& end : edge) {
      end = static_cast<std::uint32_t>(std::lower_bound(corners.begin(), corners.end(), end) - corners.begin());
    }
  }
  if (shape.stepMm > 0) {
    for (const Vec2& inner : innerPoints(points, border, shape.stepMm)) {
      const Vec3 under = e1 * inner[0] + e2 * inner[1];
      corners.push_back(static_cast<std::uint32_t>(split.vertices.size()));
      split.vertices.push_back(grid.place(under - shape.height(under) * shape.plane.normal));
      split.onPlane.push_back(true);
      points.emplace_back(e1.dot(split.vertices.back()), e2.dot(split.vertices.back()));
    }
  }
  const auto fill = fillRegion(points, border);
  if (!fill) {
    return false;
  }
  for (const Triangle& t : *fill) {
    split.section.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  }
  partFromTouchingEdges(split, touching, grid);
  return true;
}

}  // namespace glisson::cutting
