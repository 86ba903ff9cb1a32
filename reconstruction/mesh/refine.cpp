#include "reconstruction/mesh/refine.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace glisson {

namespace {
using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edgeOf(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

Vec3 onFloats(const Vec3& v) {
  Vec3 placed = v;
  for (int axis = 0; axis < 3; ++axis) {
    // Volatile, because GCC 12 at -O2 drops the way through float where it makes vectors of it.
    const volatile auto narrow = static_cast<float>(v[axis]);
    placed[axis] = static_cast<double>(narrow);
  }
  return placed;
}

/// One round: the middle of every marked edge, and the triangles that come of it.
void splitMarked(SurfaceMesh& mesh, const std::map<Edge, std::uint32_t>& middles) {
  std::vector<Triangle> split;
  split.reserve(mesh.triangles.size() + 2 * middles.size());
  for (const Triangle& t : mesh.triangles) {
    constexpr auto kNotMade = static_cast<std::uint32_t>(-1);
    std::array<std::uint32_t, 3> middle{kNotMade, kNotMade, kNotMade};  // of the side from corner n to the next
    std::size_t count = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto found = middles.find(edgeOf(t[n], t[(n + 1) % 3]));
      if (found != middles.end()) {
        middle[n] = found->second;
        ++count;
      }
    }
    if (count == 0) {
      split.push_back(t);
      continue;
    }
    if (count == 3) {
      split.push_back({t[0], middle[0], middle[2]});
      split.push_back({t[1], middle[1], middle[0]});
      split.push_back({t[2], middle[2], middle[1]});
      split.push_back(middle);
      continue;
    }
    // Turned so that the first side is split and, of two, the last one is not.
    std::size_t n = 0;
    while (middle[n] == kNotMade || (count == 2 && middle[(n + 2) % 3] != kNotMade)) {
      ++n;
    }
    const std::uint32_t a = t[n];
    const std::uint32_t b = t[(n + 1) % 3];
    const std::uint32_t c = t[(n + 2) % 3];
    const std::uint32_t ab = middle[n];
    if (count == 1) {
      split.push_back({a, ab, c});
      split.push_back({ab, b, c});
      continue;
    }
    const std::uint32_t bc = middle[(n + 1) % 3];
    split.push_back({ab, b, bc});
    const auto& v = mesh.vertices;
    if ((v[a] - v[bc]).squaredNorm() < (v[ab] - v[c]).squaredNorm()) {
      split.push_back({a, ab, bc});
      split.push_back({a, bc, c});
    } else {
      split.push_back({a, ab, c});
      split.push_back({ab, bc, c});
    }
  }
  mesh.triangles = std::move(split);
}
}  // namespace

SurfaceMesh splitLongEdges(const SurfaceMesh& mesh, double longestMm,
                           const std::function<bool(const Vec3& a, const Vec3& b, const Vec3& c)>& wanted) {
  SurfaceMesh fine = mesh;
  constexpr int kRounds = 10;
  for (int round = 0; round < kRounds; ++round) {
    std::map<Edge, std::uint32_t> middles;
    for (const Triangle& t : fine.triangles) {
      const auto& v = fine.vertices;
      const auto tooLong = [&](std::size_t n) { return (v[t[n]] - v[t[(n + 1) % 3]]).norm() > longestMm; };
      if (!(tooLong(0) || tooLong(1) || tooLong(2)) || !wanted(v[t[0]], v[t[1]], v[t[2]])) {
        continue;
      }
      for (std::size_t n = 0; n < 3; ++n) {
        if (tooLong(n)) {
          middles.try_emplace(edgeOf(t[n], t[(n + 1) % 3]), 0U);
        }
      }
    }
    if (middles.empty()) {
      break;
    }
    for (auto& [edge, middle] : middles) {
      middle = static_cast<std::uint32_t>(fine.vertices.size());
      fine.vertices.push_back(onFloats(0.5 * (fine.vertices[edge.first] + fine.vertices[edge.second])));
    }
    splitMarked(fine, middles);
  }
  return fine;
}

}  // namespace glisson
