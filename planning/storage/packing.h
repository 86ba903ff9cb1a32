#pragma once
// Purpose: masks and meshes as compressed bytes. A mask: one bit per voxel of its box, i fastest, lowest bit first. A mesh: its
// vertices (3 doubles each), then its triangles (3 uint32 each), little-endian. Both through zlib, whose checksum guards them.

#include <span>

#include "reconstruction/image/mask.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

struct Packed {
  std::size_t rawBytes = 0;  ///< what it unpacks to
  std::vector<std::byte> data;
};

Packed packMask(const Mask& mask);
Packed packMesh(const SurfaceMesh& mesh);

/// `data` must unpack to exactly the bytes that the box or the counts ask for, and the indices must exist; else std::runtime_error
/// that says what is wrong. Nothing larger than 4 GiB is allocated.
Mask unpackMask(std::span<const std::byte> data, const IndexBox& box);
SurfaceMesh unpackMesh(std::span<const std::byte> data, std::size_t vertices, std::size_t triangles);

}  // namespace glisson
