#include "planning/volumetry/box_corners.h"

#include <algorithm>
#include <array>
#include <map>

namespace glisson {

namespace {
/// A corner in its plane, in half voxels: whole numbers, so the hull is exact.
using Corner = std::array<std::int64_t, 2>;

std::int64_t turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// One chain of the hull of sorted corners, both ends included.
template <typename Iterator>
std::vector<Corner> chain(Iterator begin, Iterator end) {
  std::vector<Corner> kept;
  for (Iterator at = begin; at != end; ++at) {
    while (kept.size() > 1 && turn(kept[kept.size() - 2], kept.back(), *at) <= 0) {
      kept.pop_back();
    }
    kept.push_back(*at);
  }
  return kept;
}
}  // namespace

std::vector<Vec3> hullCorners(const VoxelRows& rows, const Vec3& spacing) {
  std::map<std::int64_t, std::vector<Corner>> planes;
  for (const RowRun& run : rows.runs) {
    for (const std::int64_t k : {2 * run.k - 1, 2 * run.k + 1}) {
      for (const std::int64_t j : {2 * run.j - 1, 2 * run.j + 1}) {
        planes[k].push_back({2 * run.i - 1, j});
        planes[k].push_back({2 * (run.i + run.n) - 1, j});
      }
    }
  }
  std::vector<Vec3> corners;
  for (auto& [k, plane] : planes) {
    std::sort(plane.begin(), plane.end());
    plane.erase(std::unique(plane.begin(), plane.end()), plane.end());
    std::vector<Corner> hull = chain(plane.begin(), plane.end());
    const std::vector<Corner> back = chain(plane.rbegin(), plane.rend());
    hull.insert(hull.end(), back.begin() + 1, back.end() - 1);
    for (const Corner& corner : hull) {
      corners.push_back(
          0.5 * spacing.cwiseProduct(Vec3(static_cast<double>(corner[0]), static_cast<double>(corner[1]), static_cast<double>(k))));
    }
  }
  return corners;
}

std::pair<Vec3, Vec3> farthestCorners(const VoxelRows& rows, const Vec3& spacing) {
  const std::vector<Vec3> corners = hullCorners(rows, spacing);
  std::pair<Vec3, Vec3> farthest{Vec3::Zero(), Vec3::Zero()};
  double longest = -1;
  for (std::size_t a = 0; a < corners.size(); ++a) {
    for (std::size_t b = a + 1; b < corners.size(); ++b) {
      const double squared = (corners[b] - corners[a]).squaredNorm();
      if (squared > longest) {
        longest = squared;
        farthest = {corners[a], corners[b]};
      }
    }
  }
  return farthest;
}

}  // namespace glisson
