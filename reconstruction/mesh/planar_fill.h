#pragma once
// Purpose: fills a planar region given by its directed border with triangles: a constrained Delaunay triangulation of the border's
// points and nothing else, so that neighbours meet it corner by corner. Loops may be nested (holes, islands) and touch in points.
// Source: S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations, 1993; exact orientation tests.

#include <optional>
#include <span>
#include <vector>

#include "reconstruction/mesh/predicates.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

/// A border edge from one point to another; the region lies to its left.
using BorderEdge = std::array<std::uint32_t, 2>;

/// Counter-clockwise triangles that cover the region; every border edge is a side of exactly one of them. Nothing where that cannot
/// be done: points at one place, edges that cross or run through a point, borders that do not close. At most 2^31 points. O(n log
/// n) in practice.
std::optional<std::vector<Triangle>> fillRegion(std::span<const Vec2> points, std::span<const BorderEdge> border);

}  // namespace glisson
