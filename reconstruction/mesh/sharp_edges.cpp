#include "reconstruction/mesh/sharp_edges.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "reconstruction/mesh/edges.h"

namespace glisson {

namespace {

std::vector<Vec3> unitNormals(const SurfaceMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    normals.push_back((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized());
  }
  return normals;
}

/// The corner of the side's triangle at its lower or at its upper vertex.
std::uint32_t cornerAt(const MeshEdges::Side& side, bool lower) {
  const std::uint32_t from = side.corner();
  const std::uint32_t to = from % 3 == 2 ? from - 2 : from + 1;
  return side.along() == lower ? from : to;
}

}  // namespace

SurfaceMesh splitAtSharpEdges(const SurfaceMesh& mesh, double featureAngleDegrees) {
  const double leastCosine = std::cos(featureAngleDegrees * std::numbers::pi / 180.0);
  const std::vector<Vec3> normals = unitNormals(mesh);
  UnionFind smooth(3 * mesh.triangles.size());
  MeshEdges(mesh.vertices.size(), mesh.triangles).forEachEdge([&](auto sides) {
    if (sides.size() == 2 && normals[sides[0].triangle()].dot(normals[sides[1].triangle()]) > leastCosine) {
      smooth.unite(cornerAt(sides[0], true), cornerAt(sides[1], true));
      smooth.unite(cornerAt(sides[0], false), cornerAt(sides[1], false));
    }
  });
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> vertexOfCorner = smooth.numbered(count);
  SurfaceMesh split;
  split.vertices.resize(count);
  split.triangles.resize(mesh.triangles.size());
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = vertexOfCorner[3 * n + corner];
      split.vertices[vertex] = mesh.vertices[mesh.triangles[n][corner]];
      split.triangles[n][corner] = vertex;
    }
  }
  return split;
}

}  // namespace glisson
