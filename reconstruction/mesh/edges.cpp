#include "reconstruction/mesh/edges.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include "reconstruction/cancel_poll.h"

namespace glisson {

MeshEdges::MeshEdges(std::size_t vertexCount, std::span<const Triangle> triangles, const ExecutionContext& context)
    : first_(vertexCount + 1, 0) {
  if (triangles.size() >= std::numeric_limits<std::uint32_t>::max() / 6) {
    throw std::length_error("MeshEdges: too many triangles");
  }
  const auto isSide = [&](std::uint32_t a, std::uint32_t b) { return a != b && a < vertexCount && b < vertexCount; };
  CancelPoll poll(context);
  for (const Triangle& t : triangles) {
    poll();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[k == 2 ? 0 : k + 1];
      if (isSide(a, b)) {
        ++first_[std::min(a, b)];
      }
    }
  }
  std::uint32_t sum = 0;
  for (auto& n : first_) {
    sum += std::exchange(n, sum);
  }
  sides_.resize(sum);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t n = 0; n < triangles.size(); ++n) {
    poll();
    const Triangle& t = triangles[n];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[k == 2 ? 0 : k + 1];
      if (isSide(a, b)) {
        sides_[next[std::min(a, b)]++] = {std::max(a, b), 2 * (3 * n + k) + (a < b ? 1U : 0U)};
      }
    }
  }
  const auto before = [](const Side& x, const Side& y) {
    return x.upper != y.upper ? x.upper < y.upper : x.cornerAndSense < y.cornerAndSense;
  };
  for (std::size_t v = 0; v < vertexCount; ++v) {
    poll();
    std::sort(sides_.begin() + first_[v], sides_.begin() + first_[v + 1], before);
  }
}

UnionFind cornerFans(std::span<const Triangle> triangles, const MeshEdges& edges, const ExecutionContext& context) {
  UnionFind fans(3 * triangles.size());
  CancelPoll poll(context);
  const auto following = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  edges.forEachEdge([&](std::span<const MeshEdges::Side> sides) {
    poll();
    for (std::size_t n = 1; n < sides.size(); ++n) {
      const std::uint32_t a = sides[0].corner();
      const std::uint32_t b = sides[n].corner();
      const bool sameSense = sides[0].along() == sides[n].along();
      fans.unite(a, sameSense ? b : following(b));
      fans.unite(following(a), sameSense ? following(b) : b);
    }
  });
  return fans;
}

std::size_t countVerticesOfSeveralFans(std::size_t vertexCount, std::span<const Triangle> triangles, const MeshEdges& edges,
                                       const ExecutionContext& context) {
  const UnionFind fans = cornerFans(triangles, edges, context);
  CancelPoll poll(context);
  std::vector<std::uint8_t> seen(vertexCount, 0);
  std::size_t several = 0;
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    poll();
    if (fans.isRoot(corner)) {
      auto& n = seen[triangles[corner / 3][corner % 3]];
      several += n == 1 ? 1 : 0;
      n = n < 2 ? static_cast<std::uint8_t>(n + 1) : n;
    }
  }
  return several;
}

std::size_t splitFans(SurfaceMesh& mesh) {
  UnionFind fans = cornerFans(mesh.triangles, MeshEdges(mesh.vertices.size(), mesh.triangles));
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const std::size_t before = mesh.vertices.size();
  std::vector<std::uint8_t> taken(before, 0);
  std::vector<std::uint32_t> copyOfFan(fans.size(), kNone);
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    const std::uint32_t vertex = mesh.triangles[corner / 3][corner % 3];
    if (!fans.isRoot(corner)) {
      continue;
    }
    if (taken[vertex] == 0) {
      taken[vertex] = 1;
      copyOfFan[corner] = vertex;
    } else {
      copyOfFan[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(Vec3(mesh.vertices[vertex]));
    }
  }
  if (mesh.vertices.size() != before) {
    for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
      mesh.triangles[corner / 3][corner % 3] = copyOfFan[fans.find(corner)];
    }
  }
  return mesh.vertices.size() - before;
}

void dropUnusedVertices(SurfaceMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      number[corner] = 0;
    }
  }
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] != kNone) {
      mesh.vertices[kept] = Vec3(mesh.vertices[v]);
      number[v] = kept++;
    }
  }
  mesh.vertices.resize(kept);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = number[corner];
    }
  }
}

}  // namespace glisson
