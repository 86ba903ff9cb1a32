#pragma once
// Purpose: fewer triangles for the same surface, by edge collapses in the order of their quadric error. Every collapse keeps the
// enclosed volume, the topology (link condition) and the sides of the triangles it moves. Frame: mm LPS.
// Sources: Garland, Heckbert, SIGGRAPH 1997 (quadrics); Lindstrom, Turk, "Fast and memory efficient polygonal simplification",
// IEEE Visualization 1998 (volume as a constraint).

#include <optional>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// Where to stop: exactly one of the two.
struct SimplifyTarget {
  std::optional<std::size_t> triangles = {};  ///< at most so many, 4 or more
  std::optional<double> distanceMm = {};      ///< no vertex of the given mesh lies farther from the simplified one, nor
                                              ///< its vertices and triangle centres farther from the given one

  /// Throws UsageError.
  void validate() const;
};

/// A closed manifold mesh with the pieces, handles and volume of `mesh` that does not cross itself where `mesh` did not. May keep
/// more triangles than asked where fewer would break that. Serial: the same bytes always. Throws CheckFailed where `mesh` is not
/// closed and manifold, UsageError, Cancelled (polled every few hundred collapses).
SurfaceMesh simplify(const SurfaceMesh& mesh, const SimplifyTarget& target, const ExecutionContext& context = {});

}  // namespace glisson
