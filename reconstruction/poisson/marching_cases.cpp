#include "reconstruction/poisson/marching_cases.h"

#include <algorithm>
#include <stdexcept>

namespace glisson::poisson {

namespace {

/// Corners of the six faces, counter-clockwise seen from outside the cell.
constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

int edgeBetween(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  const int from = std::min(a, b);
  for (int n = 0; n < 4; ++n) {
    if (kEdgeFrom[static_cast<std::size_t>(4 * axis + n)] == from) {
      return 4 * axis + n;
    }
  }
  throw std::logic_error("marching cases: no such edge");
}

bool shareFace(int edgeA, int edgeB) {
  const auto onFace = [](int edge, const std::array<int, 4>& face) {
    const int from = kEdgeFrom[static_cast<std::size_t>(edge)];
    const int to = from | (1 << (edge / 4));
    return std::count(face.begin(), face.end(), from) + std::count(face.begin(), face.end(), to) == 2;
  };
  return std::any_of(kFaces.begin(), kFaces.end(), [&](const auto& face) { return onFace(edgeA, face) && onFace(edgeB, face); });
}

/// On a face, each run of inside corners is cut off from the rest: a directed segment from the edge where the run ends to the edge
/// where it begins.
std::array<int, 12> segmentsOf(int inside) {
  std::array<int, 12> next{};
  next.fill(-1);
  const auto isInside = [inside](int corner) { return ((inside >> corner) & 1) != 0; };
  for (const auto& face : kFaces) {
    for (std::size_t first = 0; first < 4; ++first) {
      const std::size_t before = (first + 3) % 4;
      if (!isInside(face[first]) || isInside(face[before])) {
        continue;  // not the first corner of a run
      }
      std::size_t last = first;
      while (isInside(face[(last + 1) % 4])) {
        last = (last + 1) % 4;
      }
      const int start = edgeBetween(face[before], face[first]);
      const int end = edgeBetween(face[last], face[(last + 1) % 4]);
      next[static_cast<std::size_t>(start)] = end;
    }
  }
  return next;
}

using Triangles = std::vector<std::array<std::uint8_t, 3>>;

/// Triangulates a polygon as a fan none of whose diagonals lies in a face. A fan's triangles cross each other nowhere, wherever the
/// vertices lie on their edges; other triangulations of seven corners do (a test tries them all).
void addFan(const std::vector<int>& loop, Triangles& out) {
  const std::size_t size = loop.size();
  for (std::size_t apex = size; apex-- > 0;) {
    const auto at = [&](std::size_t n) { return loop[(apex + n) % size]; };
    bool inside = true;
    for (std::size_t n = 2; n + 1 < size; ++n) {
      inside = inside && !shareFace(loop[apex], at(n));
    }
    if (inside) {
      for (std::size_t n = 1; n + 1 < size; ++n) {
        out.push_back(
            {static_cast<std::uint8_t>(at(n)), static_cast<std::uint8_t>(at(n + 1)), static_cast<std::uint8_t>(loop[apex])});
      }
      return;
    }
  }
  throw std::logic_error("marching cases: a polygon has no fan inside its cell");
}

}  // namespace

MarchingCases makeMarchingCases() {
  MarchingCases cases;
  for (int inside = 1; inside < 255; ++inside) {
    std::array<int, 12> next = segmentsOf(inside);
    for (int edge = 0; edge < 12; ++edge) {
      std::vector<int> loop;
      for (int at = edge; next[static_cast<std::size_t>(at)] >= 0;) {
        loop.push_back(at);
        const int following = next[static_cast<std::size_t>(at)];
        next[static_cast<std::size_t>(at)] = -1;
        at = following;
      }
      if (!loop.empty()) {
        addFan(loop, cases[static_cast<std::size_t>(inside)]);
      }
    }
  }
  return cases;
}

}  // namespace glisson::poisson
