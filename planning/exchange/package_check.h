#pragma once
// Purpose: what was written, read back by other code and held against the mesh it was made from or the manifest that describes it.
// Private to planning/exchange.

#include <filesystem>
#include <string>
#include <string_view>

#include "planning/exchange/float_mesh.h"
#include "planning/exchange/glb_reader.h"
#include "planning/exchange/package_parts.h"

namespace glisson {

/// What the manifest says of a mesh, measured on the double mesh.
struct MeshFigures {
  std::size_t triangles = 0;  ///< in the files, after rounding
  Bounds bounds;
  double volumeMm3 = 0;  ///< 0 where open
  double areaMm2 = 0;
  bool closed = true;
};
MeshFigures figuresOf(const PackageMesh& mesh, const FloatMesh& floats);

/// 1e-4 mm; more than 2 m from the origin, where floats are coarser, the distance of rounding itself.
double fileToleranceMm(const Bounds& bounds);

/// Empty, or how `read` (mm LPS) differs from `figures`: triangles, bounds, volume or its sign.
std::string differenceFrom(const MeshFigures& figures, const SurfaceMesh& read);
/// Empty, or how `read` differs from the mesh it was written from: a corner farther than the tolerance, and differenceFrom().
std::string differenceFrom(const PackageMesh& original, const FloatMesh& floats, const SurfaceMesh& read);

/// Empty, or what is wrong with an STL's 80 bytes of header.
std::string stlHeaderProblem(std::string_view bytes);
/// Empty, or how the root's matrix is not mm LPS -> m, +Y up.
std::string rootMatrixProblem(const GlbContent& content);

}  // namespace glisson
