#pragma once
// Purpose: the connectivity of a closed triangle mesh that shrinks by edge collapses. Half-edge 3 t + k runs from corner k of
// triangle t to the next one; a half-edge's twin runs the other way in the neighbouring triangle. No positions here.
// Source: link condition after Dey, Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction", 1999.

#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

class HalfEdges {
 public:
  /// Throws ReconstructionError unless every edge has two triangles that run through it in opposite directions and every vertex
  /// one fan. Polls cancel.
  HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles, const ExecutionContext& context = {});

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }
  [[nodiscard]] std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
  [[nodiscard]] std::uint32_t target(std::uint32_t h) const { return origin_[next(h)]; }
  /// The corner of h's triangle that h does not touch.
  [[nodiscard]] std::uint32_t apex(std::uint32_t h) const { return origin_[previous(h)]; }
  [[nodiscard]] bool alive(std::uint32_t h) const { return origin_[h] != kDead; }
  /// Half-edges, dead ones too: 3 per triangle.
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(origin_.size()); }
  [[nodiscard]] std::size_t triangleCount() const { return triangles_; }

  /// Calls visit(h) for every half-edge that starts at v, in turn around it.
  template <typename Visit>
  void forEachOutgoing(std::uint32_t v, Visit&& visit) const {
    std::uint32_t h = outgoing_[v];
    do {
      visit(h);
      h = twin_[previous(h)];
    } while (h != outgoing_[v]);
  }

  /// Whether collapsing h keeps the surface a closed manifold of the same genus (the link condition).
  bool canCollapse(std::uint32_t h);
  /// Merges the target of h into its origin: two triangles go. Only where canCollapse(h).
  void collapse(std::uint32_t h);

  /// The triangles that are left, in their order.
  [[nodiscard]] std::vector<Triangle> triangles() const;

 private:
  static constexpr std::uint32_t kDead = 0xFFFFFFFFU;
  void closeTriangle(std::uint32_t h);

  std::vector<std::uint32_t> origin_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> outgoing_;  ///< per vertex one half-edge that starts there
  std::vector<std::uint32_t> mark_;      ///< per vertex: the round in which canCollapse() met it
  std::uint32_t round_ = 0;
  std::size_t triangles_ = 0;
};

}  // namespace glisson
