#pragma once
// Purpose: the stages of MCSD on VTK's filters, one function each (method.md 3). Frame: index space, spacing 1, of the whole grid.
// A surface between two stages is a plain value, so that several threads may go on from the same one.
// Every function passes its context's cancel on to the running filter in its progress events and checks it behind the filter; some
// VTK filters run to their end, at most 2 s. All throw Cancelled.

#include <array>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/mcsd/mcsd.h"

namespace glisson::mcsd {

/// In single precision, as VTK's filters hold it.
struct IndexSurface {
  std::vector<std::array<float, 3>> points;
  std::vector<Triangle> triangles;
};

/// Marching cubes on the mask's box padded by one voxel.
IndexSurface extractSurface(const Mask& mask, const ExecutionContext& context);
/// vtkDecimatePro; `share` of the triangles is removed, above 0.
IndexSurface decimate(const IndexSurface& surface, double share, const ExecutionContext& context);
/// `iterations` above 0. The Laplacian filter goes on where it ended: two runs of 22 and 23 are one of 45 bit for bit where
/// everyEdgeHasTwoTriangles() (elsewhere it may take another vertex for fixed). Sinc does not.
IndexSurface smooth(const IndexSurface& surface, SmoothingFilter filter, int iterations, const ExecutionContext& context);
/// Every triangle the other way round, as vtkReverseSense.
IndexSurface reversed(IndexSurface surface);

bool everyEdgeHasTwoTriangles(const IndexSurface& surface);
/// Into mm LPS; points that no triangle uses are dropped.
SurfaceMesh toWorld(const IndexSurface& surface, const ImageGeometry& geometry);

}  // namespace glisson::mcsd
