#include "reconstruction/methods/graded_triangles.h"

#include <algorithm>
#include <cmath>

#include "reconstruction/mesh/collapser.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/methods/local_radius.h"
#include "reconstruction/methods/point_tree.h"

namespace glisson {

namespace {

constexpr double kShorter = 0.6;  ///< edges around a place that is off

/// Around every vertex that lies too far from the simplified mesh edges become shorter; false where none does.
bool shortenWhereOff(std::vector<double>& edgesMm, const SurfaceMesh& mesh, const PointTree& tree,
                     const std::vector<double>& distances, double distanceMm) {
  constexpr double kReach = 2;  // edges
  std::vector<std::uint8_t> off(edgesMm.size(), 0);
  std::vector<std::uint32_t> near;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (distances[v] > distanceMm) {
      tree.within(mesh.vertices[v], kReach * edgesMm[v], near);
      off[v] = 1;
      std::ranges::for_each(near, [&](std::uint32_t n) { off[n] = 1; });
    }
  }
  for (std::size_t v = 0; v < edgesMm.size(); ++v) {
    edgesMm[v] *= off[v] != 0 ? kShorter : 1.0;
  }
  return std::ranges::find(off, 1) != off.end();
}

}  // namespace

SurfaceMesh gradeTriangles(const SurfaceMesh& mesh, double ratio, double distanceMm, const ExecutionContext& context) {
  constexpr int kRounds = 4;         // where they do not suffice the steps of the voxels decide, not the calibre
  constexpr double kRmsShare = 0.5;  // of the bound: what is farther off in the mean would not hold it anyway
  std::vector<double> edgesMm = localRadii(mesh, context.range(0.0, 0.3));
  // an edge of length s on a circle of radius r leaves it by s^2 / (8 r), half of that on either side where the volume is kept
  std::ranges::for_each(edgesMm, [&](double& radius) { radius = std::min(ratio * radius, std::sqrt(16 * radius * distanceMm)); });
  const PointTree tree(mesh.vertices);
  for (int round = 0; round < kRounds; ++round) {
    const ExecutionContext part = context.range(0.3 + 0.1 * round, 0.4 + 0.1 * round);
    Collapser collapser(mesh, part, edgesMm);
    collapser.run({.rmsMm = kRmsShare * distanceMm}, part);
    const std::optional<SurfaceMesh> graded = soundMesh(collapser, part);
    if (!graded) {
      std::ranges::for_each(edgesMm, [](double& edge) { edge *= kShorter; });
      continue;
    }
    if (!shortenWhereOff(edgesMm, mesh, tree, MeshDistance(*graded, part).to(mesh.vertices, part), distanceMm)) {
      return *graded;
    }
  }
  return simplify(mesh, {.distanceMm = distanceMm}, context.range(0.7, 1.0));
}

}  // namespace glisson
