#pragma once
// Purpose: the 256 cases of marching cubes (Lorensen and Cline 1987), made by rule instead of typed in, so that the surface is
// closed and manifold: on every face inside corners are separated (the two cells of a face agree), loops are traced over the faces,
// and polygons are triangulated without any diagonal that lies in a face (it could meet its twin of the cell beyond).

#include <array>
#include <cstdint>
#include <vector>

namespace glisson::poisson {

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2). Edge e = 4 * axis + n runs along `axis`, from corner kEdgeFrom[e].
inline constexpr std::array<int, 12> kEdgeFrom{0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};

/// Per case (bit c set: corner c inside) the edges of each triangle, counter-clockwise seen from outside.
using MarchingCases = std::array<std::vector<std::array<std::uint8_t, 3>>, 256>;

MarchingCases makeMarchingCases();

}  // namespace glisson::poisson
