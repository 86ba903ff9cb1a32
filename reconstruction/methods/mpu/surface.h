#pragma once
// Purpose: the surface f = 0 of MPU implicits, f the weighted mean of the patches whose balls hold the place (Ohtake et al. 2003,
// eq. 1): positive outside.

#include <functional>
#include <span>

#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/methods/mpu/octree.h"

namespace glisson::mpu {

struct Polygonising {
  int depth = 7;      ///< the cube has 2^depth cells a side; 3 or more
  double bandMm = 0;  ///< f is looked at no farther from the samples than this
};

/// Marching cubes with face-consistent cases (poisson/extraction.h): closed, oriented outward, manifold. Beyond the band, where
/// quadrics are extrapolated and give spurious sheets, the side of a place is what `isInside` says, which must be thread-safe. The
/// same bytes for any number of threads. Polls cancel every few layers.
SurfaceMesh polygonise(std::span<const Patch> patches, std::span<const Vec3> samples, const Cube& cube,
                       const Polygonising& polygonising, const std::function<bool(const Vec3&)>& isInside,
                       const ExecutionContext& context = {});

}  // namespace glisson::mpu
