#include "planning/storage/surface_hash.h"

#include <span>

#include "planning/storage/sha256.h"

namespace glisson {

std::string surfaceHash(const SurfaceMesh& mesh) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(mesh.vertices)));
  sum.update(std::as_bytes(std::span(mesh.triangles)));
  return sum.hex();
}

}  // namespace glisson
