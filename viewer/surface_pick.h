#pragma once
// Purpose: where a line of sight first meets a surface. Every triangle is tested: some milliseconds for a model, once a click.

#include <optional>

#include "reconstruction/mesh/surface_mesh.h"
#include "viewer/view_camera.h"

namespace glisson {

/// The distance along the ray, mm; nothing where it misses. Both sides of a triangle count.
std::optional<double> firstHit(const SurfaceMesh& mesh, const Ray& ray);

}  // namespace glisson
