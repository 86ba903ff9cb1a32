#pragma once
// Purpose: marching cubes, decimation and smoothing on the VTK filters, as 3D Slicer 4.4's ModelMaker does it (method.md 3).
// The work is done in index space (spacing 1), on the mask's box padded by one voxel, and mapped to mm LPS at the end.
//
// Two deviations from the reference chain. Inside is 201, not 200: at 100.5 between 0 and 200 the surface lies 0.0025 voxel inside
// the voxels' faces (0.004 mm at 1.6 mm slices); between 0 and 201 it lies on them. The triangles are the same ones. And the mesh
// does not pass through vtkPolyDataNormals: where decimation has left edges of more than two triangles, its Consistency turns
// triangles around them the wrong way (ircadb01's liver at 90 %: 179 edges), elsewhere it changes none. Sharp edges are split in mm
// by mesh/sharp_edges.h, which gives the same copies.

#include <functional>
#include <span>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

enum class SmoothingFilter : std::uint8_t { Sinc, Laplacian };
enum class McsdOrder : std::uint8_t { DecimateFirst, SmoothFirst };

struct McsdParameters {
  int smoothing = 10;  ///< iterations, 0..1000; 0 = none; 1 is refused for Sinc (VTK finds no filter of that length)
  SmoothingFilter filter = SmoothingFilter::Sinc;
  double decimation = 0.25;  ///< share of triangles to remove, 0..0.99
  McsdOrder order = McsdOrder::DecimateFirst;
  bool splitNormals = false;  ///< duplicates vertices at sharp edges (mesh/sharp_edges.h)

  /// Throws UsageError.
  void validate() const;
};

/// The seconds are those of the stages that led to this mesh; a stage that several meshes of a sweep share counts in each.
struct McsdResult {
  SurfaceMesh mesh;
  double extractSeconds = 0.0;  ///< marching cubes
  double decimateSeconds = 0.0;
  double smoothSeconds = 0.0;
};

/// Cancel is passed on to the running filter in its progress events and checked between filters (some VTK filters run to their end,
/// at most 2 s). Throws ReconstructionError on an empty mask.
McsdResult reconstructMcsd(const Mask& mask, const ImageGeometry& geometry, const McsdParameters& parameters,
                           const ExecutionContext& context = {});

/// Takes the mesh of set number `set`; `share` is its part of the sweep's progress, for what the visitor computes of it. Called on
/// several threads at once, in no fixed order.
using McsdVisitor = std::function<void(std::size_t set, McsdResult result, const ExecutionContext& share)>;

/// reconstructMcsd() of every set of parameters, the same bytes, with what they have in common computed once: the marching cubes,
/// each decimation (DecimateFirst), each smoothing (SmoothFirst), and the first iterations of longer Laplacian smoothings. Works on
/// as many sets at once as there are threads and keeps nothing of a set that the visitor has taken: memory is that of a few meshes
/// per thread. The first exception of a visitor ends the sweep and is thrown here.
void sweepMcsd(const Mask& mask, const ImageGeometry& geometry, std::span<const McsdParameters> sets, const McsdVisitor& visit,
               const ExecutionContext& context = {});

}  // namespace glisson
