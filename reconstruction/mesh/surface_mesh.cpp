#include "reconstruction/mesh/surface_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reconstruction/cancel_poll.h"
#include "reconstruction/errors.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/mesh/edges.h"

namespace glisson {

namespace {
/// A triangle is as good as flat where its height is within the rounding of its own coordinates.
bool isDegenerate(const SurfaceMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.vertices[t[0]];
  const Vec3& b = mesh.vertices[t[1]];
  const Vec3& c = mesh.vertices[t[2]];
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const double longest2 = std::max({u.squaredNorm(), v.squaredNorm(), (c - b).squaredNorm()});
  const double largest = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * largest;
  // Negated, so that a coordinate that is not a number counts as degenerate too.
  return !(u.cross(v).squaredNorm() > longest2 * rounding * rounding) || !std::isfinite(largest);
}

bool hasValidCorners(const SurfaceMesh& mesh, const Triangle& t) {
  const std::size_t n = mesh.vertices.size();
  return t[0] < n && t[1] < n && t[2] < n && t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

void countEdges(const MeshEdges& edges, MeshDefects& defects, const ExecutionContext& context) {
  CancelPoll poll(context);
  edges.forEachEdge([&](std::span<const MeshEdges::Side> sides) {
    poll();
    const auto along =
        static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.along(); }));
    const std::size_t against = sides.size() - along;
    if (sides.size() > 2) {
      ++defects.nonManifoldEdges;
    }
    if (sides.size() % 2 == 1) {
      ++defects.openEdges;
    } else if (along != against) {
      ++defects.orientationEdges;
    }
  });
}

/// Vec3 about which sums are formed, so that a far origin costs no digits.
Vec3 centreOf(const SurfaceMesh& mesh, const ExecutionContext& context) {
  if (mesh.vertices.empty()) {
    return Vec3::Zero();
  }
  const Bounds bounds = boundsOf(mesh, context);
  return 0.5 * (bounds.low + bounds.high);
}

std::string counted(const char* what, std::size_t n, const char* one, const char* many) {
  return std::string(what) + ": " + std::to_string(n) + " " + (n == 1 ? one : many);
}
}  // namespace

bool MeshDefects::any() const {
  return noTriangles || openEdges > 0 || orientationEdges > 0 || inward || nonManifoldEdges > 0 || nonManifoldVertices > 0 ||
         degenerateTriangles > 0 || selfIntersections > 0;
}

std::vector<std::string> MeshDefects::names() const {
  std::vector<std::string> names;
  if (noTriangles) {
    names.emplace_back("open: no triangles");
  }
  if (openEdges > 0) {
    names.push_back(counted("open", openEdges, "edge", "edges"));
  }
  if (orientationEdges > 0) {
    names.push_back(counted("orientation", orientationEdges, "edge", "edges"));
  }
  if (inward) {
    names.emplace_back("orientation: inward");
  }
  if (nonManifoldEdges > 0) {
    names.push_back(counted("edge", nonManifoldEdges, "edge is not manifold", "edges are not manifold"));
  }
  if (nonManifoldVertices > 0) {
    names.push_back(counted("vertex", nonManifoldVertices, "vertex is not manifold", "vertices are not manifold"));
  }
  if (degenerateTriangles > 0) {
    names.push_back(counted("degenerate", degenerateTriangles, "triangle", "triangles"));
  }
  if (selfIntersections > 0) {
    names.push_back(counted("self-intersection", selfIntersections, "pair of triangles", "pairs of triangles"));
  }
  return names;
}

MeshDefects SurfaceMesh::defects(const ExecutionContext& context) const {
  MeshDefects defects;
  if (triangles.empty()) {
    defects.noTriangles = true;
    return defects;
  }
  // Triangles without three corners of their own have no edges to speak of: the hole they leave is counted as open.
  std::vector<Triangle> sound;
  CancelPoll poll(context);
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    poll();
    if (!hasValidCorners(*this, triangles[n])) {
      if (defects.degenerateTriangles++ == 0) {
        sound.assign(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(n));
      }
      continue;
    }
    if (defects.degenerateTriangles > 0) {
      sound.push_back(triangles[n]);
    }
  }
  const std::vector<Triangle>& checked = defects.degenerateTriangles > 0 ? sound : triangles;
  for (const Triangle& t : checked) {
    poll();
    defects.degenerateTriangles += isDegenerate(*this, t) ? 1 : 0;
  }
  const MeshEdges edges(vertices.size(), checked, context);
  countEdges(edges, defects, context);
  defects.nonManifoldVertices = countVerticesOfSeveralFans(vertices.size(), checked, edges, context);
  defects.inward = defects.openEdges == 0 && defects.orientationEdges == 0 && signedVolumeMm3(*this, context) < 0;
  return defects;
}

Bounds boundsOf(const SurfaceMesh& mesh, const ExecutionContext& context) {
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("boundsOf: the mesh is empty");
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  CancelPoll poll(context);
  for (const Triangle& t : mesh.triangles) {
    poll();
    for (const std::uint32_t corner : t) {
      if (corner < mesh.vertices.size()) {
        bounds.low = bounds.low.cwiseMin(mesh.vertices[corner]);
        bounds.high = bounds.high.cwiseMax(mesh.vertices[corner]);
      }
    }
  }
  return bounds;
}

double signedVolumeMm3(const SurfaceMesh& mesh, const ExecutionContext& context) {
  if (mesh.triangles.empty()) {
    return 0.0;
  }
  const Vec3 centre = centreOf(mesh, context);
  double six = 0.0;
  CancelPoll poll(context);
  for (const Triangle& t : mesh.triangles) {
    poll();
    if (hasValidCorners(mesh, t)) {
      six += (mesh.vertices[t[0]] - centre).dot((mesh.vertices[t[1]] - centre).cross(mesh.vertices[t[2]] - centre));
    }
  }
  return six / 6.0;
}

double volumeMl(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw ReconstructionError("The mesh has no triangles and encloses no volume; reconstruct it again.");
  }
  MeshDefects open;
  countEdges(MeshEdges(mesh.vertices.size(), mesh.triangles), open, {});
  if (open.openEdges > 0 || open.orientationEdges > 0) {
    const std::string what = open.names().front();
    throw ReconstructionError("The mesh encloses no volume (" + what + "); reconstruct it again or close it first.");
  }
  return signedVolumeMm3(mesh) * kMlPerMm3;
}

double areaMm2(const SurfaceMesh& mesh) {
  double twice = 0.0;
  for (const Triangle& t : mesh.triangles) {
    if (hasValidCorners(mesh, t)) {
      const Vec3& a = mesh.vertices[t[0]];
      twice += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
  }
  return 0.5 * twice;
}

Vec3 centroidOf(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("centroidOf: the mesh is empty");
  }
  const Vec3 centre = centreOf(mesh, {});
  double six = 0.0;
  Vec3 moment = Vec3::Zero();
  for (const Triangle& t : mesh.triangles) {
    if (hasValidCorners(mesh, t)) {
      const Vec3 a = mesh.vertices[t[0]] - centre;
      const Vec3 b = mesh.vertices[t[1]] - centre;
      const Vec3 c = mesh.vertices[t[2]] - centre;
      const double part = a.dot(b.cross(c));
      six += part;
      moment += part * (a + b + c);
    }
  }
  return centre + moment / (4.0 * six);
}

long long eulerCharacteristic(const SurfaceMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      used[corner] = 1;
    }
  }
  const auto vertexCount = static_cast<long long>(std::count(used.begin(), used.end(), 1));
  long long edgeCount = 0;
  MeshEdges(mesh.vertices.size(), mesh.triangles).forEachEdge([&](auto) { ++edgeCount; });
  return vertexCount - edgeCount + static_cast<long long>(mesh.triangles.size());
}

std::vector<std::uint32_t> componentOfTriangles(const SurfaceMesh& mesh, std::uint32_t& count) {
  UnionFind pieces(mesh.triangles.size());
  MeshEdges(mesh.vertices.size(), mesh.triangles).forEachEdge([&](std::span<const MeshEdges::Side> sides) {
    for (std::size_t n = 1; n < sides.size(); ++n) {
      pieces.unite(sides[0].triangle(), sides[n].triangle());
    }
  });
  return pieces.numbered(count);
}

}  // namespace glisson
