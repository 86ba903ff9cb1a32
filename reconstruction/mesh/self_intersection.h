#pragma once
// Purpose: self-intersection, the one invariant that costs a spatial search.

#include <array>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// Pairs of triangles that share no vertex and intersect, or share one or two and overlap beyond them; the first number is the
/// lower, in ascending order. Robust predicates (exact on doubles); triangles that only touch count as intersecting. Vertices at
/// one place count as one, so that a vertex copied for each of its fans is no intersection. Triangles must have valid, finite
/// corners. Polls cancel every 512 triangles.
std::vector<std::array<std::uint32_t, 2>> selfIntersections(const SurfaceMesh& mesh, const ExecutionContext& context = {});

/// Those of the pairs that one of the triangles `among` belongs to: what has to be looked at again after these were changed.
std::vector<std::array<std::uint32_t, 2>> selfIntersections(const SurfaceMesh& mesh, std::span<const std::uint32_t> among,
                                                            const ExecutionContext& context = {});

/// The number of all pairs.
std::size_t countSelfIntersections(const SurfaceMesh& mesh, const ExecutionContext& context = {});

}  // namespace glisson
