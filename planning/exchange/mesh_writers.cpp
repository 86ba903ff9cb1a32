// Binary STL, PLY, OBJ and VTP as bytes. VTK's own writers are not used: its STL writer deletes the old file on a full disk, and
// its ASCII numbers follow the locale.
#include <Eigen/Geometry>
#include <bit>
#include <cstring>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/float_mesh.h"
#include "planning/exchange/mesh_formats.h"
#include "planning/exchange/version.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

static_assert(std::endian::native == std::endian::little, "the binary formats are little-endian");

namespace {

template <typename T>
void append(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

std::array<float, 3> facetNormal(const FloatMesh& mesh, const Triangle& t) {
  const auto at = [&](std::size_t k) {
    const auto& p = mesh.vertices[t[k]];
    return Vec3(p[0], p[1], p[2]);
  };
  const Vec3 cross = (at(1) - at(0)).cross(at(2) - at(0));
  const double length = cross.norm();
  const Vec3 unit = length > 0 ? Vec3(cross / length) : Vec3::Zero();
  return {static_cast<float>(unit.x()), static_cast<float>(unit.y()), static_cast<float>(unit.z())};
}

/// What may stand in a header or comment: printable ASCII on one line.
std::string printable(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c >= ' ' && c <= '~' ? c : '_';
  }
  return result;
}

/// The same inside an XML comment, which must not hold two hyphens.
std::string printableInXml(std::string_view text) {
  std::string result = printable(text);
  for (std::size_t at = 0; (at = result.find("--", at)) != std::string::npos;) {
    result[at + 1] = '_';
  }
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// VTK's inline binary: a UInt64 byte count, then the data, encoded as one.
std::string vtkBlock(std::string_view data) {
  std::string block;
  append(block, static_cast<std::uint64_t>(data.size()));
  block += data;
  return base64(block);
}

}  // namespace

std::string stlBytes(const NamedMesh& mesh, const FloatMesh& floats) {
  // "Glisson ..." and never "solid": some readers take a header that begins so for an ASCII file.
  std::string bytes = "Glisson " + std::string(glissonVersion()) + " SPACE=LPS UNIT=mm " + printable(mesh.id);
  bytes.resize(80, '\0');
  append(bytes, static_cast<std::uint32_t>(floats.triangles.size()));
  bytes.reserve(84 + 50 * floats.triangles.size());
  for (const Triangle& t : floats.triangles) {
    append(bytes, facetNormal(floats, t));
    for (const std::uint32_t corner : t) {
      append(bytes, floats.vertices[corner]);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string plyBytes(const NamedMesh& mesh, const FloatMesh& floats) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Glisson " + std::string(glissonVersion()) +
                      "\ncomment SPACE=LPS\ncomment UNIT=mm\ncomment " + printable(mesh.id) + "\nelement vertex " +
                      std::to_string(floats.vertices.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(floats.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& vertex : floats.vertices) {
    append(bytes, vertex);
  }
  for (const Triangle& t : floats.triangles) {
    append(bytes, std::uint8_t{3});
    append(bytes, t);
  }
  return bytes;
}

std::string objBytes(const NamedMesh& mesh, const FloatMesh& floats) {
  std::string text = "# Glisson " + std::string(glissonVersion()) + "\n# SPACE=LPS\n# UNIT=mm\no " + printable(mesh.id) + "\n";
  for (const auto& v : floats.vertices) {
    text += "v";
    for (const float value : v) {
      text += ' ';
      text += formatExact(static_cast<double>(value));
    }
    text += '\n';
  }
  for (const Triangle& t : floats.triangles) {
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  }
  return text;
}

std::string vtpBytes(const NamedMesh& mesh, const FloatMesh& floats) {
  std::string points;
  for (const auto& v : floats.vertices) {
    append(points, v);
  }
  std::string connectivity;
  std::string offsets;
  std::int64_t end = 0;
  for (const Triangle& t : floats.triangles) {
    for (const std::uint32_t corner : t) {
      append(connectivity, static_cast<std::int64_t>(corner));
    }
    append(offsets, end += 3);
  }
  const std::string array = "      <DataArray type=\"";
  std::string text =
      "<?xml version=\"1.0\"?>\n<!-- Glisson " + std::string(glissonVersion()) + " SPACE=LPS UNIT=mm " + printableInXml(mesh.id) +
      " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PolyData>\n"
      "    <FieldData>\n      <Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">76 80 83 0</Array>\n"
      "    </FieldData>\n    <Piece NumberOfPoints=\"" +
      std::to_string(floats.vertices.size()) + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(floats.triangles.size()) + "\">\n    <Points>\n" + array +
      "Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"binary\">" + vtkBlock(points) +
      "</DataArray>\n    </Points>\n    <Polys>\n" + array + "Int64\" Name=\"connectivity\" format=\"binary\">" +
      vtkBlock(connectivity) + "</DataArray>\n" + array + "Int64\" Name=\"offsets\" format=\"binary\">" + vtkBlock(offsets) +
      "</DataArray>\n    </Polys>\n    </Piece>\n  </PolyData>\n</VTKFile>\n";
  return text;
}

void writeMesh(const NamedMesh& mesh, const std::filesystem::path& path) {
  const std::string extension = toLower(path.extension().string());
  if (extension == ".glb") {
    writeGlb({mesh}, path);
    return;
  }
  if (extension != ".stl" && extension != ".ply" && extension != ".obj" && extension != ".vtp") {
    throw UsageError("\"" + path.string() + "\" has no mesh format's extension: use .stl, .ply, .obj, .vtp or .glb.");
  }
  const FloatMesh floats = toFloatMesh(mesh.mesh);
  if (extension == ".stl") {
    writeFileAtomically(path, stlBytes(mesh, floats));
  } else if (extension == ".ply") {
    writeFileAtomically(path, plyBytes(mesh, floats));
  } else if (extension == ".obj") {
    writeFileAtomically(path, objBytes(mesh, floats));
  } else {
    writeFileAtomically(path, vtpBytes(mesh, floats));
  }
}

}  // namespace glisson
