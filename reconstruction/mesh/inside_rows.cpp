#include "reconstruction/mesh/inside_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "reconstruction/cancel_poll.h"

namespace glisson {

namespace {
// Unequal and irrational-looking, so that neither axes nor diagonals of the grid are met.
constexpr double kBesideI = 0.00113;
constexpr double kBesideJ = 0.00173;
constexpr double kBesideK = 0.00097;
}  // namespace

InsideRows::InsideRows(const SurfaceMesh& mesh, const ImageGeometry& geometry, const ExecutionContext& context)
    : rowsJ_(geometry.size[1]), rowsK_(geometry.size[2]) {
  const Mat3 toIndex = geometry.spacing.cwiseInverse().asDiagonal() * geometry.direction.transpose();
  std::vector<Vec3> vertices(mesh.vertices.size());
  CancelPoll poll(context);
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    poll();
    vertices[n] = toIndex * (mesh.vertices[n] - geometry.origin) - Vec3(kBesideI, kBesideJ, kBesideK);
  }
  const int sense = geometry.leftHanded() ? -1 : 1;
  std::vector<Crossing> crossings;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    poll();
    const Triangle& t = mesh.triangles[n];
    addTriangle({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, t, crossings);
  }
  for (Crossing& crossing : crossings) {
    crossing.enters *= sense;
  }
  sortByRow(crossings);
}

void InsideRows::sortByRow(const std::vector<Crossing>& crossings) {
  first_.assign(static_cast<std::size_t>(rowsJ_) * static_cast<std::size_t>(rowsK_) + 1, 0);
  for (const Crossing& crossing : crossings) {
    ++first_[crossing.row + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  crossings_.resize(crossings.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Crossing& crossing : crossings) {
    // A row has a few, so each goes straight to its place among those before it.
    std::uint32_t at = next[crossing.row]++;
    for (; at > first_[crossing.row] && crossings_[at - 1].i > crossing.i; --at) {
      crossings_[at] = crossings_[at - 1];
    }
    crossings_[at] = crossing;
  }
}

void InsideRows::addTriangle(const std::array<Vec3, 3>& at, const Triangle& corners, std::vector<Crossing>& crossings) const {
  const auto [lowJ, highJ] = std::minmax({at[0][1], at[1][1], at[2][1]});
  const auto [lowK, highK] = std::minmax({at[0][2], at[1][2], at[2][2]});
  const auto inGrid = [](double row, int rows) { return static_cast<int>(std::clamp(row, -1.0, static_cast<double>(rows))); };
  const int firstJ = std::max(inGrid(std::ceil(lowJ), rowsJ_), 0);
  const int lastJ = std::min(inGrid(std::floor(highJ), rowsJ_), rowsJ_ - 1);
  const int firstK = std::max(inGrid(std::ceil(lowK), rowsK_), 0);
  const int lastK = std::min(inGrid(std::floor(highK), rowsK_), rowsK_ - 1);
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
        crossings.push_back({i, static_cast<std::uint32_t>(j) + static_cast<std::uint32_t>(rowsJ_) * static_cast<std::uint32_t>(k),
                             left == 3 ? -1 : 1});
      }
    }
  }
}

int InsideRows::insideOf(const VoxelRun& run) const {
  if (run.j < 0 || run.j >= rowsJ_ || run.k < 0 || run.k >= rowsK_) {
    return 0;
  }
  const std::size_t row = static_cast<std::size_t>(run.j) + static_cast<std::size_t>(rowsJ_) * static_cast<std::size_t>(run.k);
  int inside = 0;
  int depth = 0;
  int from = run.begin;
  for (auto at = crossings_.begin() + first_[row]; at != crossings_.begin() + first_[row + 1] && from < run.end; ++at) {
    const int to = std::clamp(static_cast<int>(std::ceil(std::clamp(at->i, -1e9, 1e9))), from, run.end);
    inside += depth > 0 ? to - from : 0;
    from = to;
    depth += at->enters;
  }
  return inside + (depth > 0 ? run.end - from : 0);
}

}  // namespace glisson
