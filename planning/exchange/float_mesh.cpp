#include "planning/exchange/float_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "reconstruction/errors.h"

namespace glisson {

namespace {

using Point = std::array<float, 3>;

struct PointHash {
  std::size_t operator()(const Point& p) const {
    std::size_t hash = 1469598103934665603U;
    for (const float value : p) {
      hash = (hash ^ std::hash<float>{}(value)) * 1099511628211U;
    }
    return hash;
  }
};

Vec3 toVec(const Point& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}; }

Point rounded(const Vec3& v) {
  Point p{};
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(v[axis]) || std::abs(v[axis]) > static_cast<double>(std::numeric_limits<float>::max())) {
      throw CheckFailed("The mesh has a coordinate that is no finite number: reconstruct the structure again.");
    }
    p[static_cast<std::size_t>(axis)] = static_cast<float>(v[axis]) + 0.0F;  // + 0 makes -0 the same vertex as 0
  }
  return p;
}

Vec3 doubleAreaNormal(const FloatMesh& mesh, const Triangle& t) {
  const Vec3 a = toVec(mesh.vertices[t[0]]);
  return (toVec(mesh.vertices[t[1]]) - a).cross(toVec(mesh.vertices[t[2]]) - a);
}

bool hasRepeatedCorner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Even permutations of a triangle are the same; the smallest corner comes first.
Triangle canonical(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Two triangles on the same corners with opposite sense enclose nothing: both go. Their edges stay paired through the neighbours.
void dropFoldedPairs(std::vector<Triangle>& triangles) {
  std::map<Triangle, std::vector<std::size_t>> seen;
  std::vector<bool> gone(triangles.size(), false);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle t = canonical(triangles[i]);
    const auto opposite = seen.find(Triangle{t[0], t[2], t[1]});
    if (opposite != seen.end() && !opposite->second.empty()) {
      gone[i] = gone[opposite->second.back()] = true;
      opposite->second.pop_back();
    } else {
      seen[t].push_back(i);
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!gone[i]) {
      triangles[kept++] = triangles[i];
    }
  }
  triangles.resize(kept);
}

using EdgeMap = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;

EdgeMap edgesOf(const std::vector<Triangle>& triangles) {
  EdgeMap edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges[{triangles[i][k], triangles[i][(k + 1) % 3]}] = i;
    }
  }
  return edges;
}

/// A triangle without area but with three corners cannot simply be dropped: its long edge would stay open against the two short
/// ones. The long edge is flipped into its neighbour instead; true where that was possible.
bool flipLongEdge(FloatMesh& mesh, EdgeMap& edges, std::size_t index) {
  const Triangle t = mesh.triangles[index];
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double l = (toVec(mesh.vertices[t[(k + 1) % 3]]) - toVec(mesh.vertices[t[k]])).squaredNorm();
    if (l > length) {
      length = l;
      longest = k;
    }
  }
  const std::uint32_t a = t[longest];
  const std::uint32_t c = t[(longest + 1) % 3];
  const std::uint32_t b = t[(longest + 2) % 3];
  const auto found = edges.find({c, a});
  if (found == edges.end() || found->second == index) {
    return false;
  }
  const std::size_t other = found->second;
  const Triangle& o = mesh.triangles[other];
  std::uint32_t d = o[0];
  for (const std::uint32_t corner : o) {
    d = corner != a && corner != c ? corner : d;
  }
  if (d == b || edges.contains({b, d}) || edges.contains({d, b})) {
    return false;
  }
  mesh.triangles[index] = {a, d, b};
  mesh.triangles[other] = {d, c, b};
  edges.erase({a, c});
  edges.erase({c, a});
  for (const std::size_t i : {index, other}) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges[{mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]}] = i;
    }
  }
  return true;
}

void removeFlatTriangles(FloatMesh& mesh) {
  std::vector<std::size_t> flat;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (doubleAreaNormal(mesh, mesh.triangles[i]).norm() == 0.0) {
      flat.push_back(i);
    }
  }
  if (flat.empty()) {
    return;
  }
  EdgeMap edges = edgesOf(mesh.triangles);
  constexpr int kPasses = 8;
  for (int pass = 0; pass < kPasses && !flat.empty(); ++pass) {
    std::vector<std::size_t> next;
    for (const std::size_t i : flat) {
      if (doubleAreaNormal(mesh, mesh.triangles[i]).norm() == 0.0 && !flipLongEdge(mesh, edges, i)) {
        next.push_back(i);
      }
    }
    flat.clear();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (doubleAreaNormal(mesh, mesh.triangles[i]).norm() == 0.0) {
        flat.push_back(i);
      }
    }
    if (next.size() == flat.size()) {
      break;  // nothing moved: what is left is named by defects()
    }
  }
}

void dropUnusedVertices(FloatMesh& mesh) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), kUnused);
  FloatMesh used;
  used.triangles = mesh.triangles;
  for (Triangle& t : used.triangles) {
    for (std::uint32_t& corner : t) {
      if (number[corner] == kUnused) {
        number[corner] = static_cast<std::uint32_t>(used.vertices.size());
        used.vertices.push_back(mesh.vertices[corner]);
        used.source.push_back(mesh.source[corner]);
      }
      corner = number[corner];
    }
  }
  mesh = std::move(used);
}

}  // namespace

FloatMesh toFloatMesh(const SurfaceMesh& mesh) {
  FloatMesh result;
  std::unordered_map<Point, std::uint32_t, PointHash> numbers;
  numbers.reserve(mesh.vertices.size());
  std::vector<std::uint32_t> welded(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point p = rounded(mesh.vertices[i]);
    const auto [at, isNew] = numbers.try_emplace(p, static_cast<std::uint32_t>(result.vertices.size()));
    if (isNew) {
      result.vertices.push_back(p);
      result.source.push_back(static_cast<std::uint32_t>(i));
    }
    welded[i] = at->second;
  }
  result.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle w{welded.at(t[0]), welded.at(t[1]), welded.at(t[2])};
    if (!hasRepeatedCorner(w)) {
      result.triangles.push_back(w);
    }
  }
  if (result.triangles.size() != mesh.triangles.size() || result.vertices.size() != mesh.vertices.size()) {
    dropFoldedPairs(result.triangles);
  }
  removeFlatTriangles(result);
  dropUnusedVertices(result);
  return result;
}

std::vector<Point> vertexNormals(const FloatMesh& mesh) {
  std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = doubleAreaNormal(mesh, t);
    for (const std::uint32_t corner : t) {
      sums[corner] += normal;
    }
  }
  std::vector<Point> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double length = sums[i].norm();
    const Vec3 unit = length > 0 ? Vec3(sums[i] / length) : Vec3::UnitZ();
    normals[i] = {static_cast<float>(unit.x()), static_cast<float>(unit.y()), static_cast<float>(unit.z())};
  }
  return normals;
}

SurfaceMesh roundedToFloat(const SurfaceMesh& mesh) {
  const FloatMesh floats = toFloatMesh(mesh);
  SurfaceMesh result;
  result.vertices.reserve(floats.vertices.size());
  for (const Point& p : floats.vertices) {
    result.vertices.push_back(toVec(p));
  }
  result.triangles = floats.triangles;
  return result;
}

}  // namespace glisson
