#include "viewer/clustering.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace glisson {

SurfaceMesh clustered(const SurfaceMesh& mesh, std::size_t triangles) {
  if (mesh.triangles.size() <= triangles || triangles == 0) {
    return mesh;
  }
  // A surface of area A crosses about A / h^2 cells of edge h and leaves two triangles in each.
  const double cell = std::sqrt(2.0 * areaMm2(mesh) / static_cast<double>(triangles));
  const Vec3 low = boundsOf(mesh).low;
  SurfaceMesh coarse;
  std::vector<double> members;
  std::vector<std::uint32_t> clusterOf(mesh.vertices.size());
  std::unordered_map<std::uint64_t, std::uint32_t> clusterAt;
  clusterAt.reserve(triangles);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3 at = (mesh.vertices[v] - low) / cell;
    const std::uint64_t key = static_cast<std::uint64_t>(std::max(at.x(), 0.0)) |
                              (static_cast<std::uint64_t>(std::max(at.y(), 0.0)) << 21U) |
                              (static_cast<std::uint64_t>(std::max(at.z(), 0.0)) << 42U);
    const auto [place, isNew] = clusterAt.try_emplace(key, static_cast<std::uint32_t>(coarse.vertices.size()));
    if (isNew) {
      coarse.vertices.emplace_back(Vec3::Zero());
      members.push_back(0);
    }
    clusterOf[v] = place->second;
    coarse.vertices[place->second] += mesh.vertices[v];
    members[place->second] += 1;
  }
  for (std::size_t c = 0; c < members.size(); ++c) {
    coarse.vertices[c] /= members[c];
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle moved{clusterOf[t[0]], clusterOf[t[1]], clusterOf[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) {
      coarse.triangles.push_back(moved);
    }
  }
  return coarse;
}

}  // namespace glisson
