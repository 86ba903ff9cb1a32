#include "reconstruction/mesh/untangle.h"

#include <algorithm>

#include "reconstruction/mesh/edges.h"
#include "reconstruction/mesh/self_intersection.h"

namespace glisson {

namespace {
/// Moves every marked vertex half the way to the mean of its neighbours.
void relax(SurfaceMesh& mesh, const std::vector<std::uint8_t>& marked) {
  std::vector<Vec3> sum(mesh.vertices.size(), Vec3::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      if (marked[t[n]] != 0) {
        // On a closed mesh every neighbour is met twice.
        sum[t[n]] += mesh.vertices[t[(n + 1) % 3]] + mesh.vertices[t[(n + 2) % 3]];
        count[t[n]] += 2;
      }
    }
  }
  for (std::size_t v = 0; v < marked.size(); ++v) {
    if (marked[v] != 0 && count[v] > 0) {
      mesh.vertices[v] = (0.5 * mesh.vertices[v] + 0.5 / count[v] * sum[v]).eval();
    }
  }
}

std::vector<std::uint32_t> trianglesAt(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& marked) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n) {
    const Triangle& t = mesh.triangles[n];
    if (marked[t[0]] != 0 || marked[t[1]] != 0 || marked[t[2]] != 0) {
      triangles.push_back(n);
    }
  }
  return triangles;
}
}  // namespace

Untangled untangle(SurfaceMesh& mesh, std::size_t mostPairs, const ExecutionContext& context) {
  constexpr int kRounds = 8;
  Untangled result;
  auto pairs = selfIntersections(mesh, context);
  result.before = result.after = pairs.size();
  if (pairs.empty() || result.before > mostPairs) {
    return result;
  }
  std::vector<Vec3> best = mesh.vertices;
  std::vector<std::uint8_t> marked(mesh.vertices.size(), 0);
  for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
    for (const auto& pair : pairs) {
      for (const std::uint32_t triangle : pair) {
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
          marked[corner] = 1;
        }
      }
    }
    relax(mesh, marked);
    relax(mesh, marked);
    pairs = selfIntersections(mesh, trianglesAt(mesh, marked), context);
    if (pairs.size() < result.after) {
      result.after = pairs.size();
      result.movedVertices = static_cast<std::size_t>(std::count(marked.begin(), marked.end(), 1));
      best = mesh.vertices;
    }
  }
  mesh.vertices = std::move(best);
  return result;
}

}  // namespace glisson
