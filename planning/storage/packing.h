#pragma once
// Purpose: masks, meshes and voxels as compressed bytes. A mask: one bit per voxel of its box, i fastest, lowest bit first. A mesh:
// its vertices (3 doubles each), then its triangles (3 uint32 each), little-endian. Voxels (int16): each one's difference from the
// one before modulo 65536, the sign in the lowest bit; first the low bytes of all, then the high ones. All through zlib, whose
// checksum guards them.

#include <cstdint>
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
Packed packVoxels(std::span<const std::int16_t> voxels);

/// `data` must unpack to exactly the bytes that the box or the counts ask for, and the indices must exist; else std::runtime_error
/// that says what is wrong. Nothing larger than 4 GiB is allocated.
Mask unpackMask(std::span<const std::byte> data, const IndexBox& box);
SurfaceMesh unpackMesh(std::span<const std::byte> data, std::size_t vertices, std::size_t triangles);
std::vector<std::int16_t> unpackVoxels(std::span<const std::byte> data, std::size_t count);

}  // namespace glisson
