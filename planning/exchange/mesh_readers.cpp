// STL, PLY and OBJ from bytes that may be hostile; the door readMesh().
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/byte_reader.h"
#include "planning/exchange/mesh_formats.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

double numberOf(std::string_view word, const std::string& file) {
  const auto value = parseNumber(word);
  if (!value) {
    refuseMesh(file, "has \"" + std::string(word.substr(0, 20)) + "\" where a number belongs");
  }
  return *value;
}

Vec3 threeNumbers(std::string_view& line, const std::string& file) {
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) {
    v[axis] = numberOf(nextWord(line), file);
  }
  return v;
}

void addSoupTriangle(SurfaceMesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

SurfaceMesh parseAsciiStl(std::string_view bytes, const std::string& file) {
  SurfaceMesh mesh;
  ByteReader reader(bytes, file);
  std::string_view line;
  std::size_t corners = 0;
  bool ended = false;
  while (reader.line(line)) {
    const std::string word = toLower(nextWord(line));
    if (word == "vertex") {
      mesh.vertices.push_back(threeNumbers(line, file));
      ++corners;
    } else if (word == "endfacet") {
      if (corners != 3) {
        refuseMesh(file, "has a facet with " + std::to_string(corners) + " corners");
      }
      addSoupTriangle(mesh);
      corners = 0;
    } else if (word == "endsolid") {
      ended = true;
    }
  }
  if (!ended || corners != 0) {
    refuseMesh(file, "ends before \"endsolid\"");
  }
  return mesh;
}

struct PlyProperty {
  std::string name;
  std::string type;
  std::string countType;  ///< set on lists
};
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};
struct PlyHeader {
  bool ascii = false;
  std::vector<PlyElement> elements;
};

std::size_t plySize(const std::string& type, const std::string& file) {
  static const std::map<std::string, std::size_t> kSizes{
      {"char", 1}, {"uchar", 1}, {"int8", 1},  {"uint8", 1},  {"short", 2}, {"ushort", 2}, {"int16", 2},   {"uint16", 2},
      {"int", 4},  {"uint", 4},  {"int32", 4}, {"uint32", 4}, {"float", 4}, {"double", 8}, {"float32", 4}, {"float64", 8}};
  const auto found = kSizes.find(type);
  if (found == kSizes.end()) {
    refuseMesh(file, "has a property of the unknown type \"" + type.substr(0, 20) + "\"");
  }
  return found->second;
}

PlyHeader parsePlyHeader(ByteReader& reader, const std::string& file) {
  PlyHeader header;
  std::string_view line;
  bool formatSeen = false;
  while (reader.line(line)) {
    const std::string_view word = nextWord(line);
    if (word == "end_header") {
      if (!formatSeen) {
        refuseMesh(file, "names no PLY format");
      }
      return header;
    }
    if (word == "format") {
      const std::string_view format = nextWord(line);
      if (format != "ascii" && format != "binary_little_endian") {
        refuseMesh(file, "is a PLY of the format \"" + std::string(format.substr(0, 30)) + "\", which is not read");
      }
      header.ascii = format == "ascii";
      formatSeen = true;
    } else if (word == "element") {
      PlyElement element;
      element.name = nextWord(line);
      const auto count = parseInteger(nextWord(line));
      if (!count || *count < 0) {
        refuseMesh(file, "has an element without a count");
      }
      element.count = static_cast<std::uint64_t>(*count);
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty()) {
        refuseMesh(file, "has a property before its first element");
      }
      PlyProperty property;
      property.type = nextWord(line);
      if (property.type == "list") {
        property.countType = nextWord(line);
        property.type = nextWord(line);
        plySize(property.countType, file);
      }
      plySize(property.type, file);
      property.name = nextWord(line);
      header.elements.back().properties.push_back(std::move(property));
    }
  }
  refuseMesh(file, "ends inside its PLY header");
}

double plyNumber(ByteReader& reader, const std::string& type, const std::string& file) {
  switch (plySize(type, file)) {
    case 1:
      return type.starts_with('u') ? static_cast<double>(reader.take<std::uint8_t>())
                                   : static_cast<double>(reader.take<std::int8_t>());
    case 2:
      return type.starts_with('u') ? static_cast<double>(reader.take<std::uint16_t>())
                                   : static_cast<double>(reader.take<std::int16_t>());
    case 8:
      return reader.take<double>();
    default:
      break;
  }
  if (type.starts_with('f')) {
    return static_cast<double>(reader.take<float>());
  }
  return type.starts_with('u') ? static_cast<double>(reader.take<std::uint32_t>())
                               : static_cast<double>(reader.take<std::int32_t>());
}

/// One row of an element: every property's numbers in turn, from binary or text.
class PlyRow {
 public:
  PlyRow(ByteReader& reader, bool ascii, const std::string& file) : reader_(reader), ascii_(ascii), file_(file) {}

  void begin() {
    if (ascii_) {
      do {
        if (!reader_.line(line_)) {
          refuseMesh(file_, "has fewer rows than its header says");
        }
      } while (line_.find_first_not_of(" \t\r") == std::string_view::npos);
    }
  }
  double next(const std::string& type) { return ascii_ ? numberOf(nextWord(line_), file_) : plyNumber(reader_, type, file_); }

 private:
  ByteReader& reader_;
  bool ascii_;
  const std::string& file_;
  std::string_view line_;
};

std::uint32_t indexOf(double value, std::size_t vertices, const std::string& file) {
  if (!(value >= 0) || value >= static_cast<double>(vertices) || value != std::floor(value)) {
    refuseMesh(file, "has a face that names a vertex it does not have");
  }
  return static_cast<std::uint32_t>(value);
}

/// A polygon as a fan of triangles.
void addFace(SurfaceMesh& mesh, const std::vector<std::uint32_t>& corners, const std::string& file) {
  if (corners.size() < 3) {
    refuseMesh(file, "has a face with fewer than three corners");
  }
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

void readPlyElement(const PlyElement& element, ByteReader& reader, bool ascii, SurfaceMesh& mesh, const std::string& file) {
  // A row takes at least one byte per property (text: a digit and a blank), so a count that the file cannot hold is caught here.
  if (element.properties.empty() || element.count > reader.left()) {
    refuseMesh(file, "says it has " + std::to_string(element.count) + " rows of \"" + element.name.substr(0, 20) +
                         "\", more than its bytes can hold");
  }
  PlyRow row(reader, ascii, file);
  std::vector<std::uint32_t> corners;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    row.begin();
    Vec3 position = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const PlyProperty& property : element.properties) {
      if (property.countType.empty()) {
        const double value = row.next(property.type);
        const std::string_view axes = "xyz";
        if (property.name.size() == 1 && axes.find(property.name[0]) != std::string_view::npos) {
          position[static_cast<int>(axes.find(property.name[0]))] = value;
        }
        continue;
      }
      const double count = row.next(property.countType);
      if (!(count >= 0) || count > 64) {
        refuseMesh(file, "has a list of more than 64 entries");
      }
      corners.clear();
      for (int k = 0; k < static_cast<int>(count); ++k) {
        const double value = row.next(property.type);
        if (element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index")) {
          corners.push_back(indexOf(value, mesh.vertices.size(), file));
        }
      }
      if (element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index")) {
        addFace(mesh, corners, file);
      }
    }
    if (element.name == "vertex") {
      if (!position.allFinite()) {
        refuseMesh(file, "has a vertex without finite x, y and z");
      }
      mesh.vertices.push_back(position);
    }
  }
}

/// "7", "7/1", "7//3" or "-1": an OBJ corner.
std::uint32_t objIndex(std::string_view word, std::size_t vertices, const std::string& file) {
  const auto number = parseInteger(word.substr(0, word.find('/')));
  if (!number) {
    refuseMesh(file, "has a face with \"" + std::string(word.substr(0, 20)) + "\" where an index belongs");
  }
  const double zeroBased = static_cast<double>(*number < 0 ? static_cast<long long>(vertices) + *number : *number - 1);
  return indexOf(zeroBased, vertices, file);
}

SurfaceMesh welded(const SurfaceMesh& soup) {
  SurfaceMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> at(soup.vertices.size());
  for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
    const Vec3& v = soup.vertices[i];
    const auto [found, isNew] = numbers.try_emplace({v.x(), v.y(), v.z()}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (isNew) {
      mesh.vertices.push_back(v);
    }
    at[i] = found->second;
  }
  for (const Triangle& t : soup.triangles) {
    mesh.triangles.push_back({at[t[0]], at[t[1]], at[t[2]]});
  }
  return mesh;
}

}  // namespace

SurfaceMesh parseStlSoup(std::string_view bytes, const std::string& file) {
  if (bytes.size() >= 84) {
    ByteReader reader(bytes, file);
    const std::string_view header = reader.take(80);
    const auto count = reader.take<std::uint32_t>();
    // A binary file is exactly as long as its count says; that also tells a binary file whose header begins with "solid".
    if (reader.left() == std::uint64_t{50} * count) {
      SurfaceMesh mesh;
      mesh.vertices.reserve(std::size_t{3} * count);
      mesh.triangles.reserve(count);
      for (std::uint32_t i = 0; i < count; ++i) {
        reader.take(12);
        for (int corner = 0; corner < 3; ++corner) {
          const auto p = reader.take<std::array<float, 3>>();
          const Vec3 v(p[0], p[1], p[2]);
          if (!v.allFinite()) {
            refuseMesh(file, "has a vertex that is no finite number");
          }
          mesh.vertices.push_back(v);
        }
        reader.take(2);
        addSoupTriangle(mesh);
      }
      turnToLps(mesh, header);
      return mesh;
    }
    if (!toLower(bytes.substr(0, 5)).starts_with("solid")) {
      refuseMesh(file,
                 "says it has " + std::to_string(count) + " triangles but is " + std::to_string(bytes.size()) + " bytes long");
    }
  }
  if (!toLower(bytes.substr(0, 5)).starts_with("solid")) {
    refuseMesh(file, "is no STL file");
  }
  SurfaceMesh mesh = parseAsciiStl(bytes, file);
  turnToLps(mesh, bytes.substr(0, bytes.find('\n')));
  return mesh;
}

SurfaceMesh parsePly(std::string_view bytes, const std::string& file) {
  ByteReader reader(bytes, file);
  std::string_view line;
  if (!reader.line(line) || line != "ply") {
    refuseMesh(file, "is no PLY file");
  }
  const PlyHeader header = parsePlyHeader(reader, file);
  const std::size_t headerEnd = reader.at();
  SurfaceMesh mesh;
  for (const PlyElement& element : header.elements) {
    readPlyElement(element, reader, header.ascii, mesh, file);
  }
  turnToLps(mesh, bytes.substr(0, headerEnd));
  return mesh;
}

SurfaceMesh parseObj(std::string_view bytes, const std::string& file) {
  SurfaceMesh mesh;
  ByteReader reader(bytes, file);
  std::string_view line;
  std::string comments;
  std::vector<std::uint32_t> corners;
  while (reader.line(line)) {
    const std::string_view word = nextWord(line);
    if (word == "v") {
      mesh.vertices.push_back(threeNumbers(line, file));
    } else if (word == "f") {
      corners.clear();
      for (std::string_view corner = nextWord(line); !corner.empty(); corner = nextWord(line)) {
        corners.push_back(objIndex(corner, mesh.vertices.size(), file));
      }
      addFace(mesh, corners, file);
    } else if (word.starts_with('#') && comments.size() < 4096) {
      comments += line;
      comments += '\n';
    }
  }
  turnToLps(mesh, comments);
  return mesh;
}

void turnToLps(SurfaceMesh& mesh, std::string_view header) {
  if (header.find("SPACE=RAS") == std::string_view::npos) {
    return;
  }
  for (Vec3& v : mesh.vertices) {
    v.x() = -v.x();
    v.y() = -v.y();
  }
}

SurfaceMesh readMesh(const std::filesystem::path& path) {
  const std::string extension = toLower(path.extension().string());
  const std::string file = path.string();
  SurfaceMesh mesh;
  if (extension == ".stl") {
    mesh = welded(parseStlSoup(readWholeFile(path), file));
  } else if (extension == ".ply") {
    mesh = parsePly(readWholeFile(path), file);
  } else if (extension == ".obj") {
    mesh = parseObj(readWholeFile(path), file);
  } else if (extension == ".vtp") {
    mesh = parseVtp(readWholeFile(path), file);
  } else {
    throw InputError("\"" + file + "\" has no mesh format's extension: name an .stl, .ply, .obj or .vtp file.");
  }
  if (mesh.empty()) {
    refuseMesh(file, "has no triangles");
  }
  return mesh;
}

}  // namespace glisson
