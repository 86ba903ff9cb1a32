#pragma once
// Purpose: distances from points to a mesh, and the two errors of method.md 4 that need no analytic body.
// Frame: mm LPS. Every distance is exact for the triangle it belongs to; no point is left out.
// Source: closest point on a triangle after Ericson, Real-Time Collision Detection, 2005, section 5.1.5; the search is a bounding
// volume tree with median splits.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// Distance of a point to a triangle as a set of points, also where the triangle is degenerate.
double distanceToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

/// Searches the triangle nearest to a point. Const and thread-safe once built.
class MeshDistance {
 public:
  /// Copies what it needs of `mesh`. Throws std::invalid_argument on a mesh without triangles. Polls cancel.
  explicit MeshDistance(const SurfaceMesh& mesh, const ExecutionContext& context = {});

  /// Unsigned distance, mm.
  [[nodiscard]] double to(const Vec3& point) const;
  /// Distances of all points, in their order, on several threads: quicker where neighbours in the list are near each other, since
  /// each search begins with the triangle found before. The same bytes for any number of threads. Polls cancel every few thousand
  /// points.
  [[nodiscard]] std::vector<double> to(std::span<const Vec3> points, const ExecutionContext& context = {}) const;

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    std::uint32_t first = 0;  ///< leaf: first corner triple; inner node: the right child (the left one follows its parent)
    std::uint32_t count = 0;  ///< triangles of a leaf; 0 in an inner node
  };
  /// The squared distance and in `triangle` the number of the nearest one; there the one to begin with, or kNoTriangle.
  [[nodiscard]] double squaredTo(const Vec3& point, std::size_t& triangle) const;
  std::uint32_t build(std::vector<std::uint32_t>& order, const std::vector<Vec3>& centres, const SurfaceMesh& mesh,
                      std::uint32_t begin, std::uint32_t end, const ExecutionContext& context);

  std::vector<Node> nodes_;
  std::vector<Vec3> corners_;  ///< three per triangle, in the order of the leaves
};

/// Summary of distances, mm. All zero where there are none.
struct ErrorSummary {
  double mean = 0;
  double median = 0;
  double p95 = 0;
  double max = 0;
};
/// Percentiles are the nearest rank.
ErrorSummary summarise(std::vector<double> distances);

/// method.md 4, paperError: from all inside-surface voxel centres of the mask to the mesh. Nothing where no voxel of the mask has
/// a normal (voxels by themselves). Throws ReconstructionError on an empty mask, std::invalid_argument on an empty mesh.
std::optional<ErrorSummary> paperError(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry,
                                       const ExecutionContext& context = {});

/// method.md 4, voxelError: between the mesh and the 0.5 level set of the mask (marching cubes, neither smoothed nor decimated),
/// from the vertices of each to the surface of the other, both directions pooled. Throws ReconstructionError on an empty mask,
/// std::invalid_argument on an empty mesh.
ErrorSummary voxelError(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry,
                        const ExecutionContext& context = {});

}  // namespace glisson
