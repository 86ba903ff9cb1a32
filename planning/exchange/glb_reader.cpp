#include "planning/exchange/glb_reader.h"

#include "planning/exchange/byte_reader.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

struct Chunks {
  Json json;
  std::string_view binary;
};

Chunks chunksOf(std::string_view bytes, const std::string& file) {
  ByteReader reader(bytes, file);
  if (reader.take<std::uint32_t>() != kGlbMagic || reader.take<std::uint32_t>() != 2 ||
      reader.take<std::uint32_t>() != bytes.size()) {
    refuseMesh(file, "is no GLB 2.0 file of its own length");
  }
  const auto jsonLength = reader.take<std::uint32_t>();
  if (reader.take<std::uint32_t>() != kJsonChunk) {
    refuseMesh(file, "does not begin with its JSON");
  }
  Chunks chunks;
  chunks.json = Json::parse(reader.take(jsonLength));
  const auto binaryLength = reader.take<std::uint32_t>();
  if (reader.take<std::uint32_t>() != kBinaryChunk) {
    refuseMesh(file, "has no binary chunk after its JSON");
  }
  chunks.binary = reader.take(binaryLength);
  if (reader.left() != 0) {
    refuseMesh(file, "has bytes after its binary chunk");
  }
  return chunks;
}

/// The bytes of an accessor of `count` elements of `elementBytes`, tightly packed.
std::string_view accessorBytes(const Chunks& chunks, const Json& accessor, int component, const std::string& type,
                               std::size_t elementBytes, const std::string& file) {
  if (accessor.at("componentType").get<int>() != component || accessor.at("type").get<std::string>() != type) {
    refuseMesh(file, "has an accessor of another type than this program writes");
  }
  const Json& view = chunks.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const auto count = accessor.at("count").get<std::size_t>();
  const auto offset = view.value("byteOffset", std::size_t{0});
  const auto length = view.at("byteLength").get<std::size_t>();
  if (view.contains("byteStride") || accessor.value("byteOffset", std::size_t{0}) != 0 || length / elementBytes != count ||
      length % elementBytes != 0 || offset > chunks.binary.size() || length > chunks.binary.size() - offset) {
    refuseMesh(file, "has an accessor that does not fit its bytes");
  }
  return chunks.binary.substr(offset, length);
}

SurfaceMesh meshOf(const Chunks& chunks, const Json& primitive, const std::string& file) {
  const Json& accessors = chunks.json.at("accessors");
  const std::string_view points =
      accessorBytes(chunks, accessors.at(primitive.at("attributes").at("POSITION").get<std::size_t>()), kFloat, "VEC3", 12, file);
  const std::string_view indices =
      accessorBytes(chunks, accessors.at(primitive.at("indices").get<std::size_t>()), kUnsignedInt, "SCALAR", 4, file);
  SurfaceMesh mesh;
  ByteReader pointReader(points, file);
  while (pointReader.left() > 0) {
    const auto p = pointReader.take<std::array<float, 3>>();
    mesh.vertices.emplace_back(p[0], p[1], p[2]);
    if (!mesh.vertices.back().allFinite()) {
      refuseMesh(file, "has a vertex that is no finite number");
    }
  }
  if (indices.size() % sizeof(Triangle) != 0) {
    refuseMesh(file, "has indices that are not three for each triangle");
  }
  ByteReader indexReader(indices, file);
  while (indexReader.left() > 0) {
    const auto t = indexReader.take<Triangle>();
    if (std::max({t[0], t[1], t[2]}) >= mesh.vertices.size()) {
      refuseMesh(file, "has a face that names a vertex it does not have");
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

GlbNode nodeOf(const Chunks& chunks, const Json& node, const std::string& file) {
  if (node.contains("matrix") || node.contains("translation") || node.contains("rotation") || node.contains("scale")) {
    refuseMesh(file, "has a structure with a transformation of its own");
  }
  const Json& primitives = chunks.json.at("meshes").at(node.at("mesh").get<std::size_t>()).at("primitives");
  if (primitives.size() != 1) {
    refuseMesh(file, "has a structure of several primitives");
  }
  const Json& primitive = primitives.at(0);
  const Json& material = chunks.json.at("materials").at(primitive.at("material").get<std::size_t>());
  GlbNode result;
  result.id = node.at("name").get<std::string>();
  result.mesh = meshOf(chunks, primitive, file);
  result.baseColour = material.at("pbrMetallicRoughness").at("baseColorFactor").get<std::array<double, 4>>();
  result.alphaMode = material.value("alphaMode", std::string("OPAQUE"));
  result.doubleSided = material.value("doubleSided", false);
  return result;
}

}  // namespace

GlbContent parseGlb(std::string_view bytes, const std::string& file) {
  try {
    const Chunks chunks = chunksOf(bytes, file);
    const Json& nodes = chunks.json.at("nodes");
    const Json& scene = chunks.json.at("scenes").at(chunks.json.value("scene", std::size_t{0}));
    if (scene.at("nodes").size() != 1) {
      refuseMesh(file, "has more than one root node");
    }
    const Json& root = nodes.at(scene.at("nodes").at(0).get<std::size_t>());
    GlbContent content;
    content.rootMatrix = root.at("matrix").get<std::array<double, 16>>();
    for (const Json& child : root.at("children")) {
      content.nodes.push_back(nodeOf(chunks, nodes.at(child.get<std::size_t>()), file));
    }
    return content;
  } catch (const Json::exception&) {
    refuseMesh(file, "has JSON that is damaged or not of this program");
  }
}

Vec3 toScene(const std::array<double, 16>& matrix, const Vec3& point) {
  Vec3 result;
  for (std::size_t row = 0; row < 3; ++row) {
    result[static_cast<int>(row)] =
        matrix[row] * point.x() + matrix[4 + row] * point.y() + matrix[8 + row] * point.z() + matrix[12 + row];
  }
  return result;
}

}  // namespace glisson
