#include "planning/storage/packing.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace glisson {

namespace {
static_assert(std::endian::native == std::endian::little, "case files are little-endian");
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));

constexpr std::size_t kLargest = std::size_t{4} << 30;

Packed compressed(std::span<const std::byte> raw, int level) {
  Packed packed;
  packed.rawBytes = raw.size();
  uLongf size = compressBound(raw.size());
  packed.data.resize(size);
  const int code =
      compress2(reinterpret_cast<Bytef*>(packed.data.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size(), level);
  if (code != Z_OK) {
    throw std::bad_alloc();
  }
  packed.data.resize(size);
  return packed;
}

std::vector<std::byte> decompressed(std::span<const std::byte> data, std::size_t rawBytes) {
  if (rawBytes > kLargest) {
    throw std::runtime_error("a part is larger than 4 GiB");
  }
  // zlib gains at most a factor of 1032: a larger claim is a lie and is not allocated.
  if (rawBytes / 1032 > data.size() + 64) {
    throw std::runtime_error("a part claims more bytes than it can hold");
  }
  std::vector<std::byte> raw(rawBytes);
  uLongf size = rawBytes;
  const int code =
      uncompress(reinterpret_cast<Bytef*>(raw.data()), &size, reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (code != Z_OK || size != rawBytes) {
    throw std::runtime_error("a part does not unpack to its size");
  }
  return raw;
}
}  // namespace

Packed packMask(const Mask& mask) {
  const auto values = mask.values();
  std::vector<std::byte> bits((values.size() + 7) / 8);
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (values[n] != 0) {
      bits[n / 8] |= static_cast<std::byte>(1U << (n % 8));
    }
  }
  return compressed(bits, Z_DEFAULT_COMPRESSION);
}

Mask unpackMask(std::span<const std::byte> data, const IndexBox& box) {
  std::size_t voxels = 1;
  for (const int size : box.size) {
    if (size < 0 || (size > 0 && voxels > 8 * kLargest / static_cast<std::size_t>(size))) {
      throw std::runtime_error("a mask has an impossible size");
    }
    voxels *= static_cast<std::size_t>(size);
  }
  if (voxels > kLargest) {
    throw std::runtime_error("a mask is larger than 4 GiB");
  }
  const std::vector<std::byte> bits = decompressed(data, (voxels + 7) / 8);
  std::vector<std::uint8_t> values(voxels);
  for (std::size_t n = 0; n < voxels; ++n) {
    values[n] = static_cast<std::uint8_t>((std::to_integer<unsigned>(bits[n / 8]) >> (n % 8)) & 1U);
  }
  return {box, values};
}

Packed packMesh(const SurfaceMesh& mesh) {
  const auto vertices = std::as_bytes(std::span(mesh.vertices));
  const auto triangles = std::as_bytes(std::span(mesh.triangles));
  std::vector<std::byte> raw(vertices.begin(), vertices.end());
  raw.insert(raw.end(), triangles.begin(), triangles.end());
  return compressed(raw, Z_BEST_SPEED);
}

Packed packVoxels(std::span<const std::int16_t> voxels) {
  // Neighbours are alike: their differences are small, of either sign, and so the high bytes are nearly all zero.
  std::vector<std::byte> raw(2 * voxels.size());
  std::uint16_t before = 0;
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    const auto value = static_cast<std::uint16_t>(voxels[n]);
    const auto difference = static_cast<std::uint16_t>(value - before);
    const bool negative = (difference & 0x8000U) != 0;
    const auto folded = static_cast<std::uint16_t>((difference << 1U) ^ (negative ? 0xFFFFU : 0U));
    raw[n] = static_cast<std::byte>(folded & 0xFFU);
    raw[voxels.size() + n] = static_cast<std::byte>(folded >> 8U);
    before = value;
  }
  return compressed(raw, Z_BEST_SPEED);
}

std::vector<std::int16_t> unpackVoxels(std::span<const std::byte> data, std::size_t count) {
  if (count > kLargest / 2) {
    throw std::runtime_error("a part is larger than 4 GiB");
  }
  const std::vector<std::byte> raw = decompressed(data, 2 * count);
  std::vector<std::int16_t> voxels(count);
  std::uint16_t value = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const auto folded =
        static_cast<std::uint16_t>(std::to_integer<unsigned>(raw[n]) | (std::to_integer<unsigned>(raw[count + n]) << 8U));
    const auto difference = static_cast<std::uint16_t>((folded >> 1U) ^ ((folded & 1U) != 0 ? 0xFFFFU : 0U));
    value = static_cast<std::uint16_t>(value + difference);
    voxels[n] = static_cast<std::int16_t>(value);
  }
  return voxels;
}

SurfaceMesh unpackMesh(std::span<const std::byte> data, std::size_t vertices, std::size_t triangles) {
  if (vertices > kLargest / sizeof(Vec3) || triangles > kLargest / sizeof(Triangle)) {
    throw std::runtime_error("a mesh has an impossible size");
  }
  const std::size_t vertexBytes = vertices * sizeof(Vec3);
  const std::vector<std::byte> raw = decompressed(data, vertexBytes + triangles * sizeof(Triangle));
  SurfaceMesh mesh;
  mesh.vertices.resize(vertices);
  mesh.triangles.resize(triangles);
  if (vertexBytes > 0) {
    std::memcpy(mesh.vertices.front().data(), raw.data(), vertexBytes);
  }
  if (triangles > 0) {
    std::memcpy(mesh.triangles.front().data(), raw.data() + vertexBytes, raw.size() - vertexBytes);
  }
  for (const Vec3& vertex : mesh.vertices) {
    if (!vertex.allFinite()) {
      throw std::runtime_error("a mesh has a vertex that is not finite");
    }
  }
  for (const Triangle& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) >= vertices) {
      throw std::runtime_error("a mesh has a triangle without its vertex");
    }
  }
  return mesh;
}

}  // namespace glisson
