#pragma once
// Purpose: the edges of a triangle list with the triangles at each, in linear time: triangle sides are counting-sorted by their
// lower vertex, then the few of a vertex by their upper one. Sides between equal vertices and beyond the vertices are left out.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/mesh/union_find.h"

namespace glisson {

class MeshEdges {
 public:
  /// One side of one triangle. Corner c = 3 * triangle + k stands for the side from corner k to the next one.
  struct Side {
    std::uint32_t upper;           ///< the greater of the side's two vertices
    std::uint32_t cornerAndSense;  ///< 2 * c, + 1 where the side runs from the lower to the upper vertex
    [[nodiscard]] bool along() const { return (cornerAndSense & 1U) != 0; }
    [[nodiscard]] std::uint32_t corner() const { return cornerAndSense >> 1U; }
    [[nodiscard]] std::uint32_t triangle() const { return corner() / 3; }
  };

  /// At most 2^31 / 3 triangles: throws std::length_error above. Polls cancel.
  MeshEdges(std::size_t vertexCount, std::span<const Triangle> triangles, const ExecutionContext& context = {});

  /// Calls visit(span of Side) once per edge, edges by lower then upper vertex; the sides of an edge in the order of triangles.
  template <typename Visit>
  void forEachEdge(Visit&& visit) const {
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      for (std::size_t n = first_[v]; n < first_[v + 1];) {
        std::size_t end = n + 1;
        while (end < first_[v + 1] && sides_[end].upper == sides_[n].upper) {
          ++end;
        }
        visit(std::span<const Side>(sides_).subspan(n, end - n));
        n = end;
      }
    }
  }

 private:
  std::vector<std::uint32_t> first_;  ///< per lower vertex: its first side; one more at the end
  std::vector<Side> sides_;
};

/// Corners of triangles joined to fans: two corners at one vertex belong together where their triangles share an edge there.
UnionFind cornerFans(std::span<const Triangle> triangles, const MeshEdges& edges, const ExecutionContext& context = {});

/// Vertices whose triangles form more than one fan.
std::size_t countVerticesOfSeveralFans(std::size_t vertexCount, std::span<const Triangle> triangles, const MeshEdges& edges,
                                       const ExecutionContext& context = {});

/// Gives every fan of triangles a vertex of its own (a copy where a vertex has several): edge-manifold meshes become
/// vertex-manifold without a triangle changed. Returns the number of copies.
std::size_t splitFans(SurfaceMesh& mesh);

/// Removes vertices that no triangle uses; the order of the others stays.
void dropUnusedVertices(SurfaceMesh& mesh);

}  // namespace glisson
