#pragma once
// Purpose: a distance at every vertex that a 3D view draws of a surface, made ahead of the frame that shows it, on a worker.
// Display only. mm LPS.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "viewer/display_mesh.h"

namespace glisson {

/// Immutable and shared between threads; what it holds is private to viewer/.
struct SurfaceErrors;

/// One value for each point, mm.
using ValuesAt = std::function<std::vector<double>(std::span<const Vec3> points)>;

/// Asks `valuesAt` for the surface's own vertices, and for those of its stand-ins. Any thread. Throws what `valuesAt` throws.
std::shared_ptr<const SurfaceErrors> makeSurfaceErrors(const DisplayMesh& mesh, const ValuesAt& valuesAt);

}  // namespace glisson
