#pragma once
// Purpose: the reference chain of method.md 3, written plainly on VTK's filters, and bodies to run it on.

#include "reconstruction/mcsd/mcsd.h"

namespace glisson::test {

/// A body without symmetry: a ball with an arm along each axis, of different lengths. `size` holds it from 27 x 22 x 21 voxels on.
Mask asymmetricBody(const Index3& size);
/// A grid of 0.57 x 0.71 x 1.6 mm that lies askew.
ImageGeometry obliqueGeometry(const Index3& size, bool leftHanded);

/// The chain on the whole grid (inside 201: see mcsd.h), one filter behind the other, in mm behind the last one. `consistency` is
/// that of vtkPolyDataNormals.
SurfaceMesh plainChain(const Mask& mask, const ImageGeometry& geometry, const McsdParameters& p, bool consistency = true);
/// Fails where a corner of a triangle differs by a bit, or their order.
void expectSameTriangles(const SurfaceMesh& a, const SurfaceMesh& b);

}  // namespace glisson::test
