#pragma once
// Purpose: the triangle mesh every room exchanges. Frame: mm LPS, double precision, triangles counter-clockwise seen from outside.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/image_geometry.h"

namespace glisson {

using Triangle = std::array<std::uint32_t, 3>;

/// Counts of each broken invariant; all zero on a sound mesh.
struct MeshDefects {
  bool noTriangles = false;             ///< nothing there: "open"
  std::size_t openEdges = 0;            ///< edges with an odd number of triangles: the surface ends there
  std::size_t orientationEdges = 0;     ///< edges not run through as often one way as the other
  bool inward = false;                  ///< a closed mesh whose signed volume is negative
  std::size_t nonManifoldEdges = 0;     ///< edges with more than two triangles
  std::size_t nonManifoldVertices = 0;  ///< vertices whose triangles do not form one fan
  std::size_t degenerateTriangles =
      0;                              ///< repeated vertex, no such vertex, not finite, or a height within its coordinates' rounding
  std::size_t selfIntersections = 0;  ///< pairs of intersecting triangles; counted only by checks that ask for it

  [[nodiscard]] bool any() const;
  /// One short text per broken invariant, in the fixed words: "open: 3 edges", "orientation: ...", "edge: ...", "vertex: ...",
  /// "degenerate: ...", "self-intersection: ...". Empty on a sound mesh.
  [[nodiscard]] std::vector<std::string> names() const;
};

struct SurfaceMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
  /// Names every broken invariant but self-intersection (mesh/self_intersection.h). Linear time. An empty mesh is "open". Polls
  /// cancel.
  [[nodiscard]] MeshDefects defects(const ExecutionContext& context = {}) const;
};

struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

/// Bounds of the vertices that triangles use. Throws std::invalid_argument on an empty mesh. Polls cancel.
Bounds boundsOf(const SurfaceMesh& mesh, const ExecutionContext& context = {});
/// Signed volume by the divergence theorem, mm^3, summed about the mesh's own centre. Meaningless on an open mesh: see
/// volumeMl(mesh). Polls cancel.
double signedVolumeMm3(const SurfaceMesh& mesh, const ExecutionContext& context = {});
/// Volume of a closed mesh in mL. Throws ReconstructionError where the mesh is open: that is an error, not a number.
double volumeMl(const SurfaceMesh& mesh);
double areaMm2(const SurfaceMesh& mesh);
/// Centroid of the enclosed volume of a closed mesh, mm.
Vec3 centroidOf(const SurfaceMesh& mesh);
/// V - E + F over used vertices.
long long eulerCharacteristic(const SurfaceMesh& mesh);
/// Edge-connected pieces: for every triangle its component's number, 0..n-1 by first triangle.
std::vector<std::uint32_t> componentOfTriangles(const SurfaceMesh& mesh, std::uint32_t& count);

}  // namespace glisson
