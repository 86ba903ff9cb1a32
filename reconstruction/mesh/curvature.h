#pragma once
// Purpose: the mean Gaussian curvature of a mesh, the smoothness measure of Palomar et al. 2016, eq. 13 (method.md 4).
//   K = (1 / vertices) sum 3 (2 pi - sum of angles) / (sum of incident areas), on the mesh with equal vertices merged.
// Units: 1/mm^2. Vertices on an open edge have no angle deficit of their own and are left out.

#include <cstddef>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

struct CurvatureSummary {
  double trimmedPerMm2 = 0;       ///< mean over the 5th..95th percentile of the vertices: the reported one
  double untrimmedPerMm2 = 0;     ///< mean over all vertices; a few tiny triangles can rule it
  std::size_t tinyTriangles = 0;  ///< triangles below 1e-6 mm^2
};

CurvatureSummary meanGaussianCurvature(const SurfaceMesh& mesh);
/// The same with the vertices as they are and none left out: a mesh whose normals are split has open edges along its sharp ones,
/// and each copy of a vertex has the deficit of its own fan alone. Inflates K 90x and more on unsmoothed marching cubes: likely the
/// large numbers of the paper's Table 4 (method.md 4).
CurvatureSummary gaussianCurvatureAsShipped(const SurfaceMesh& mesh);

/// The mesh with exactly equal vertices merged and unused ones dropped: what split normals and STL files take apart. Triangles keep
/// their order.
SurfaceMesh mergedVertices(const SurfaceMesh& mesh);

}  // namespace glisson
