#include "reconstruction/mesh/inside_rows.h"

#include <algorithm>
#include <cmath>

namespace glisson {

namespace {
// Unequal and irrational-looking, so that neither axes nor diagonals of the grid are met.
constexpr double kBesideI = 0.00113;
constexpr double kBesideJ = 0.00173;
constexpr double kBesideK = 0.00097;
}  // namespace

std::uint64_t InsideRows::rowKey(int j, int k) {
  constexpr std::int64_t kShift = std::int64_t{1} << 31;
  return (static_cast<std::uint64_t>(k + kShift) << 32U) | static_cast<std::uint64_t>(j + kShift);
}

InsideRows::InsideRows(const SurfaceMesh& mesh, const ImageGeometry& geometry, const ExecutionContext& context) {
  const Mat3 toIndex = geometry.spacing.cwiseInverse().asDiagonal() * geometry.direction.transpose();
  std::vector<Vec3> vertices(mesh.vertices.size());
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    vertices[n] = toIndex * (mesh.vertices[n] - geometry.origin) - Vec3(kBesideI, kBesideJ, kBesideK);
  }
  const int sense = geometry.leftHanded() ? -1 : 1;
  constexpr std::size_t kPoll = 65536;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    if (n % kPoll == 0) {
      context.throwIfCancelled();
    }
    const Triangle& t = mesh.triangles[n];
    addTriangle({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, t);
  }
  for (Crossing& crossing : crossings_) {
    crossing.enters *= sense;
  }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& x, const Crossing& y) { return x.row != y.row ? x.row < y.row : x.i < y.i; });
}

void InsideRows::addTriangle(const std::array<Vec3, 3>& at, const Triangle& corners) {
  const auto [lowJ, highJ] = std::minmax({at[0][1], at[1][1], at[2][1]});
  const auto [lowK, highK] = std::minmax({at[0][2], at[1][2], at[2][2]});
  const int firstJ = static_cast<int>(std::ceil(lowJ));
  const int lastJ = static_cast<int>(std::floor(highJ));
  const int firstK = static_cast<int>(std::ceil(lowK));
  const int lastK = static_cast<int>(std::floor(highK));
  for (int k = firstK; k <= lastK; ++k) {
    for (int j = firstJ; j <= lastJ; ++j) {
      std::array<double, 3> area{};
      int left = 0;
      for (std::size_t n = 0; n < 3; ++n) {
        // Each side from its lower to its upper corner, so that its two triangles find the ray on the same side of it.
        std::size_t a = (n + 1) % 3;
        std::size_t b = (n + 2) % 3;
        const double sign = corners[a] < corners[b] ? 1.0 : -1.0;
        if (sign < 0) {
          std::swap(a, b);
        }
        const double twice = (at[b][1] - at[a][1]) * (k - at[a][2]) - (at[b][2] - at[a][2]) * (j - at[a][1]);
        area[n] = sign * twice;
        left += (twice >= 0) == (sign > 0) ? 1 : 0;
      }
      const double sum = area[0] + area[1] + area[2];
      if ((left == 0 || left == 3) && sum != 0) {
        const double i = (area[0] * at[0][0] + area[1] * at[1][0] + area[2] * at[2][0]) / sum;
        // Counter-clockwise seen along +i from outside is where the ray leaves.
        crossings_.push_back({rowKey(j, k), i, left == 3 ? -1 : 1});
      }
    }
  }
}

int InsideRows::insideOf(const VoxelRun& run) const {
  const std::uint64_t row = rowKey(run.j, run.k);
  auto at =
      std::lower_bound(crossings_.begin(), crossings_.end(), row, [](const Crossing& x, std::uint64_t r) { return x.row < r; });
  int inside = 0;
  int depth = 0;
  int from = run.begin;
  for (; at != crossings_.end() && at->row == row && from < run.end; ++at) {
    const int to = std::clamp(static_cast<int>(std::ceil(std::clamp(at->i, -1e9, 1e9))), from, run.end);
    inside += depth > 0 ? to - from : 0;
    from = to;
    depth += at->enters;
  }
  return inside + (depth > 0 ? run.end - from : 0);
}

}  // namespace glisson
