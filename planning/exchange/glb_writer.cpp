// glTF 2.0 binary through tinygltf. Source: Khronos glTF 2.0 specification, 3.6 (accessors), 3.9 (materials), 4 (GLB).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/mesh_formats.h"
#include "planning/exchange/tiny_gltf_config.h"
#include "planning/exchange/version.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

/// sRGB 8 bit -> linear factor (IEC 61966-2-1): glTF's base colour is linear, so an importer shows the colour of the window.
double linearFromSrgb(std::uint8_t value) {
  const double s = value / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// JSON is UTF-8: a name in another encoding keeps only its ASCII characters.
std::string utf8(const std::string& text) {
  std::size_t follow = 0;
  bool valid = true;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) {
      valid = valid && follow > 0;
      follow -= follow > 0 ? 1 : 0;
      continue;
    }
    valid = valid && follow == 0 && (byte < 0x80U || (byte >= 0xC2U && byte < 0xF0U));
    follow = byte < 0x80U ? 0 : (byte < 0xE0U ? 1 : 2);
  }
  if (valid && follow == 0) {
    return text;
  }
  std::string ascii;
  for (const char c : text) {
    ascii += static_cast<unsigned char>(c) < 0x80U ? c : '_';
  }
  return ascii;
}

int addView(tinygltf::Model& model, const void* data, std::size_t bytes, int target) {
  std::vector<unsigned char>& buffer = model.buffers.front().data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = bytes;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(data);
  buffer.insert(buffer.end(), first, first + bytes);
  model.bufferViews.push_back(std::move(view));
  return static_cast<int>(model.bufferViews.size()) - 1;
}

int addAccessor(tinygltf::Model& model, int view, int component, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.byteOffset = 0;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

int addPositions(tinygltf::Model& model, const std::vector<std::array<float, 3>>& points) {
  const int view = addView(model, points.data(), points.size() * sizeof(points[0]), TINYGLTF_TARGET_ARRAY_BUFFER);
  const int accessor = addAccessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, points.size());
  std::vector<double> low(3, std::numeric_limits<double>::max());
  std::vector<double> high(3, std::numeric_limits<double>::lowest());
  for (const auto& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], static_cast<double>(p[axis]));
      high[axis] = std::max(high[axis], static_cast<double>(p[axis]));
    }
  }
  model.accessors.back().minValues = std::move(low);
  model.accessors.back().maxValues = std::move(high);
  return accessor;
}

int addMaterial(tinygltf::Model& model, const NamedMesh& mesh, bool open) {
  tinygltf::Material material;
  material.name = mesh.id;
  const double alpha = std::clamp(mesh.opacity, 0.0, 1.0);
  material.pbrMetallicRoughness.baseColorFactor = {linearFromSrgb(mesh.colour.r), linearFromSrgb(mesh.colour.g),
                                                   linearFromSrgb(mesh.colour.b), alpha};
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  material.alphaMode = alpha < 1.0 ? "BLEND" : "OPAQUE";
  material.doubleSided = open;
  model.materials.push_back(std::move(material));
  return static_cast<int>(model.materials.size()) - 1;
}

int addMesh(tinygltf::Model& model, const NamedMesh& mesh, const FloatMesh& floats) {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.attributes["POSITION"] = addPositions(model, floats.vertices);
  const auto normals = vertexNormals(floats);
  const int normalView = addView(model, normals.data(), normals.size() * sizeof(normals[0]), TINYGLTF_TARGET_ARRAY_BUFFER);
  primitive.attributes["NORMAL"] =
      addAccessor(model, normalView, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, normals.size());
  const int indexView =
      addView(model, floats.triangles.data(), floats.triangles.size() * sizeof(Triangle), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  primitive.indices =
      addAccessor(model, indexView, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, 3 * floats.triangles.size());
  primitive.material = addMaterial(model, mesh, mesh.mesh.defects().openEdges > 0);
  tinygltf::Mesh entry;
  entry.name = mesh.id;
  entry.primitives.push_back(std::move(primitive));
  model.meshes.push_back(std::move(entry));
  return static_cast<int>(model.meshes.size()) - 1;
}

}  // namespace

std::string glbBytes(const std::vector<NamedMesh>& meshes, const std::vector<FloatMesh>& floats) {
  if (meshes.empty()) {
    throw PlanningError("There is no mesh to write as GLB: build the model first.");
  }
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "Glisson " + std::string(glissonVersion());
  model.buffers.emplace_back();
  tinygltf::Node root;
  root.name = "glisson_mm_lps";
  root.matrix.assign(kGlbRootMatrix.begin(), kGlbRootMatrix.end());
  tinygltf::Value::Object frame;
  frame["space"] = tinygltf::Value(std::string("LPS"));
  frame["unit"] = tinygltf::Value(std::string("mm"));
  root.extras = tinygltf::Value(std::move(frame));
  model.nodes.push_back(std::move(root));
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (floats[i].triangles.empty()) {
      throw PlanningError("The mesh \"" + meshes[i].id + "\" has no triangles and cannot be written as GLB: leave it out.");
    }
    tinygltf::Node node;
    node.name = meshes[i].id;
    node.mesh = addMesh(model, meshes[i], floats[i]);
    tinygltf::Value::Object extras;
    extras["name"] = tinygltf::Value(utf8(meshes[i].name));
    node.extras = tinygltf::Value(std::move(extras));
    model.nodes.front().children.push_back(static_cast<int>(model.nodes.size()));
    model.nodes.push_back(std::move(node));
  }
  if (model.buffers.front().data.size() > kLargestMeshFile) {
    throw PlanningError("The model is larger than a GLB file can be: simplify it first.");
  }
  tinygltf::Scene scene;
  scene.name = "Glisson";
  scene.nodes.push_back(0);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, stream, false, true) || !stream) {
    throw PlanningError("The GLB could not be composed: export without it.");
  }
  return std::move(stream).str();
}

void writeGlb(const std::vector<NamedMesh>& meshes, const std::filesystem::path& path) {
  std::vector<FloatMesh> floats;
  floats.reserve(meshes.size());
  for (const NamedMesh& mesh : meshes) {
    floats.push_back(toFloatMesh(mesh.mesh));
  }
  writeFileAtomically(path, glbBytes(meshes, floats));
}

}  // namespace glisson
