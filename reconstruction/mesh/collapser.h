#pragma once
// Purpose: edge collapses that keep the enclosed volume, the topology (link condition) and the sides of the triangles they move:
// what simplify.h and methods/graded_triangles.h are made of. Frame: mm LPS. Private to reconstruction/. Sources: as simplify.h.

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/half_edges.h"
#include "reconstruction/mesh/quadric.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// When to stop one run of collapses.
struct CollapseLimit {
  std::size_t triangles = 0;
  double rmsMm = std::numeric_limits<double>::infinity();  ///< root mean square distance of a collapse's vertex to its planes
};

class Collapser {
 public:
  /// Closed and manifold: CheckFailed. `edgesMm`, where it is not empty: for each vertex the length that edges are to have there;
  /// then only edges shorter than that are collapsed, the shortest in proportion first, and none becomes much longer. Polls cancel.
  explicit Collapser(const SurfaceMesh& mesh, const ExecutionContext& context, std::vector<double> edgesMm = {});
  /// Collapses edges pass by pass: the cheaper fifth of those that are left, in the order of the mesh. So no queue is needed, the
  /// memory is walked in order and the costs are found on several threads, and the result is as good as by strict order.
  void run(const CollapseLimit& limit, const ExecutionContext& context);
  /// The vertices keep their numbers: those that were merged away are used by no triangle.
  [[nodiscard]] SurfaceMesh mesh() const;

 private:
  static constexpr float kNever = std::numeric_limits<float>::infinity();

  struct Collapse {
    Vec3 place;
    double error;  ///< mm^4
    Vec3 ring;     ///< area vector of the ring's outline
  };
  [[nodiscard]] bool isEdge(std::uint32_t h) const { return connectivity_.alive(h) && h < connectivity_.twin(h); }
  [[nodiscard]] Collapse best(std::uint32_t h) const;
  [[nodiscard]] bool keepsSides(std::uint32_t h, const Collapse& collapse) const;
  [[nodiscard]] bool keepsEdgesShort(std::uint32_t h, const Vec3& place) const;
  [[nodiscard]] double wantedEdge(std::uint32_t h, const Vec3& place) const;
  /// What decides the order; kNever where the edge must not be collapsed.
  [[nodiscard]] float costOf(std::uint32_t h, const Collapse& collapse, double rmsMm) const;
  void findCosts(double rmsMm, const ExecutionContext& context);
  [[nodiscard]] float costOfPass() const;
  void collapseIfCheap(std::uint32_t h, float most, double rmsMm);

  HalfEdges connectivity_;
  Vec3 centre_;
  std::vector<Vec3> position_;  ///< about the centre
  std::vector<Quadric> quadric_;
  std::vector<double> wanted_;     ///< per vertex, mm; empty: the error alone decides
  std::vector<float> cost_;        ///< per edge at the lower of its half-edges; kNever where it must not be collapsed
  std::vector<std::uint8_t> old_;  ///< per half-edge: its cost is to be found again
};

/// The collapser's mesh without unused vertices, few crossings moved apart; nothing where that fails or takes volume.
std::optional<SurfaceMesh> soundMesh(const Collapser& collapser, const ExecutionContext& context);

}  // namespace glisson
