#include "viewer/mesh_slices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson {

MeshSlices::MeshSlices(std::shared_ptr<const Reconstruction> source, const SliceGeometry& geometry)
    : source_(std::move(source)), geometry_(geometry) {
  const SurfaceMesh& mesh = source_->mesh;
  const auto axis = static_cast<Eigen::Index>(geometry_.sliceAxis);
  const Vec3 along = geometry_.grid.direction.col(axis) / geometry_.grid.spacing[axis];
  const double start = along.dot(geometry_.grid.origin);
  height_.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) {
    height_.push_back(static_cast<float>(along.dot(vertex) - start));
  }
  first_.assign(static_cast<std::size_t>(geometry_.slices()) + 1, 0);
  const auto forEach = [&](const auto& act) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [from, to] = slicesOf(mesh.triangles[t]);
      for (int s = from; s <= to; ++s) {
        act(static_cast<std::size_t>(s), t);
      }
    }
  };
  forEach([&](std::size_t slice, std::uint32_t /*triangle*/) { ++first_[slice + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  triangles_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  forEach([&](std::size_t slice, std::uint32_t triangle) { triangles_[next[slice]++] = triangle; });
}

/// The slices that lie between its corners; a corner in a slice counts as above it.
std::pair<int, int> MeshSlices::slicesOf(const Triangle& triangle) const {
  const auto [low, high] = std::minmax({height_[triangle[0]], height_[triangle[1]], height_[triangle[2]]});
  const double last = geometry_.slices() - 1;
  return {static_cast<int>(std::clamp(std::floor(static_cast<double>(low)) + 1, 0.0, last + 1)),
          static_cast<int>(std::clamp(std::floor(static_cast<double>(high)), -1.0, last))};
}

std::vector<std::pair<SlicePoint, SlicePoint>> MeshSlices::outline(int slice) const {
  std::vector<std::pair<SlicePoint, SlicePoint>> lines;
  if (slice < 0 || slice >= geometry_.slices()) {
    return lines;
  }
  const SurfaceMesh& mesh = source_->mesh;
  const auto at = static_cast<float>(slice);
  for (std::uint32_t n = first_[static_cast<std::size_t>(slice)]; n < first_[static_cast<std::size_t>(slice) + 1]; ++n) {
    const Triangle& triangle = mesh.triangles[triangles_[n]];
    std::array<SlicePoint, 2> ends;
    std::size_t count = 0;
    for (std::size_t e = 0; e < 3 && count < 2; ++e) {
      // from the lower number to the higher one: the triangle beyond the edge finds the same point to the last bit
      const auto [a, b] = std::minmax({triangle[e], triangle[(e + 1) % 3]});
      if ((height_[a] >= at) != (height_[b] >= at)) {
        const double share = static_cast<double>(at - height_[a]) / static_cast<double>(height_[b] - height_[a]);
        ends[count++] = geometry_.toSlice(mesh.vertices[a] + share * (mesh.vertices[b] - mesh.vertices[a]));
      }
    }
    if (count == 2) {
      lines.emplace_back(ends[0], ends[1]);
    }
  }
  return lines;
}

}  // namespace glisson
