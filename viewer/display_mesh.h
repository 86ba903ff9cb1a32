#pragma once
// Purpose: what the 3D view needs of a surface (normals, buffers, a coarse stand-in), made ahead of the frame that shows it. Costs
// some 100 ms per 100,000 triangles: make it on a worker. Display only: nothing is measured on it. Frame: mm LPS.

#include <memory>

#include "planning/case/liver_model.h"

namespace glisson {

/// Immutable and shared between threads; what it holds is private to viewer/.
struct DisplayMesh;

/// The reconstruction must have a mesh that is not empty. Any thread.
std::shared_ptr<const DisplayMesh> makeDisplayMesh(std::shared_ptr<const Reconstruction> reconstruction);
/// The surface alone, without stand-ins: some 15 ms per 100,000 triangles, for a first frame that is waited for.
std::shared_ptr<const DisplayMesh> makeBareDisplayMesh(std::shared_ptr<const Reconstruction> reconstruction);
/// The same surface with its stand-ins. Any thread, also while the bare one is drawn.
std::shared_ptr<const DisplayMesh> withStandIns(const DisplayMesh& bare);
/// The surface it was made from.
const Reconstruction& sourceOf(const DisplayMesh& mesh);

}  // namespace glisson
