// VTP as this program and other plain writers make it: one piece of triangles or polygons, inline text or inline uncompressed
// base64. VTK's own reader is not used: it aborts on files that lie about their sizes.
#include <array>
#include <limits>
#include <optional>

#include "planning/exchange/byte_reader.h"
#include "planning/exchange/mesh_formats.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

/// One element: its start tag and what stands between start and end tag. Enough XML for VTP's regular shape.
struct Element {
  std::string_view tag;
  std::string_view body;
};

std::optional<Element> findElement(std::string_view text, const std::string& name, std::size_t& from) {
  while (true) {
    const std::size_t start = text.find("<" + name, from);
    if (start == std::string_view::npos) {
      return std::nullopt;
    }
    const std::size_t tagEnd = text.find('>', start);
    if (tagEnd == std::string_view::npos) {
      return std::nullopt;
    }
    from = tagEnd + 1;
    const char next = text[start + 1 + name.size()];
    if (next != ' ' && next != '>' && next != '\n' && next != '\t' && next != '\r') {
      continue;  // <PointsX
    }
    if (text[tagEnd - 1] == '/') {
      return Element{text.substr(start, tagEnd - start), {}};
    }
    const std::size_t end = text.find("</" + name + ">", from);
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    from = end;
    return Element{text.substr(start, tagEnd - start), text.substr(tagEnd + 1, end - tagEnd - 1)};
  }
}

std::optional<Element> firstElement(std::string_view text, const std::string& name) {
  std::size_t from = 0;
  return findElement(text, name, from);
}

std::string attribute(std::string_view tag, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = tag.substr(at + key.size());
  return std::string(rest.substr(0, rest.find('"')));
}

std::string decodeBase64(std::string_view text, const std::string& file) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int digits = 0;
  for (const char c : text) {
    std::uint32_t value = 0;
    if (c >= 'A' && c <= 'Z') {
      value = static_cast<std::uint32_t>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      value = static_cast<std::uint32_t>(c - 'a' + 26);
    } else if (c >= '0' && c <= '9') {
      value = static_cast<std::uint32_t>(c - '0' + 52);
    } else if (c == '+' || c == '/') {
      value = c == '+' ? 62U : 63U;
    } else if (c == '=' || c == ' ' || c == '\n' || c == '\r' || c == '\t') {
      continue;
    } else {
      refuseMesh(file, "has a data block that is no base64 text");
    }
    group = group << 6U | value;
    if (++digits == 4) {
      for (const unsigned shift : {16U, 8U, 0U}) {
        bytes += static_cast<char>(group >> shift & 0xFFU);
      }
      group = 0;
      digits = 0;
    }
  }
  if (digits >= 2) {
    bytes += static_cast<char>(group >> (digits == 2 ? 4U : 10U) & 0xFFU);
  }
  if (digits == 3) {
    bytes += static_cast<char>(group >> 2U & 0xFFU);
  }
  return bytes;
}

template <typename T>
void appendAs(std::vector<double>& values, ByteReader& reader, std::uint64_t count) {
  values.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    values.push_back(static_cast<double>(reader.take<T>()));
  }
}

std::vector<double> arrayValues(const Element& array, const std::string& headerType, const std::string& file) {
  std::vector<double> values;
  if (attribute(array.tag, "format") == "ascii") {
    std::string_view rest = array.body;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
      const auto value = parseNumber(word);
      if (!value) {
        refuseMesh(file, "has \"" + std::string(word.substr(0, 20)) + "\" where a number belongs");
      }
      values.push_back(*value);
    }
    return values;
  }
  if (attribute(array.tag, "format") != "binary") {
    refuseMesh(file, "keeps its data as an appended block, which is not read");
  }
  const std::string bytes = decodeBase64(array.body, file);
  ByteReader reader(bytes, file);
  const std::uint64_t size = headerType == "UInt64" ? reader.take<std::uint64_t>() : reader.take<std::uint32_t>();
  if (size != reader.left()) {
    refuseMesh(file, "has a data block that is not as long as it says");
  }
  const std::string type = attribute(array.tag, "type");
  if (type == "Float32") {
    appendAs<float>(values, reader, size / 4);
  } else if (type == "Float64") {
    appendAs<double>(values, reader, size / 8);
  } else if (type == "Int32") {
    appendAs<std::int32_t>(values, reader, size / 4);
  } else if (type == "Int64") {
    appendAs<std::int64_t>(values, reader, size / 8);
  } else {
    refuseMesh(file, "has a data array of the type \"" + type.substr(0, 20) + "\", which is not read");
  }
  return values;
}

std::vector<double> namedArray(std::string_view polys, const std::string& name, const std::string& headerType,
                               const std::string& file) {
  std::size_t from = 0;
  while (const auto array = findElement(polys, "DataArray", from)) {
    if (attribute(array->tag, "Name") == name) {
      return arrayValues(*array, headerType, file);
    }
  }
  refuseMesh(file, "has no \"" + name + "\" of its polygons");
}

void addPolygons(SurfaceMesh& mesh, const std::vector<double>& connectivity, const std::vector<double>& offsets,
                 const std::string& file) {
  double begin = 0;
  for (const double end : offsets) {
    if (!(end >= begin + 3) || end > static_cast<double>(connectivity.size())) {
      refuseMesh(file, "has polygons whose offsets do not fit its connectivity");
    }
    const auto first = static_cast<std::size_t>(begin);
    for (auto at = first; at < static_cast<std::size_t>(end); ++at) {
      if (!(connectivity[at] >= 0) || connectivity[at] >= static_cast<double>(mesh.vertices.size())) {
        refuseMesh(file, "has a face that names a vertex it does not have");
      }
      if (at >= first + 2) {
        const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(connectivity[i]); };
        mesh.triangles.push_back({corner(first), corner(at - 1), corner(at)});
      }
    }
    begin = end;
  }
}

}  // namespace

SurfaceMesh parseVtp(std::string_view bytes, const std::string& file) {
  const auto root = firstElement(bytes, "VTKFile");
  if (!root || attribute(root->tag, "type") != "PolyData") {
    refuseMesh(file, "is no VTP file");
  }
  if (!attribute(root->tag, "compressor").empty() || attribute(root->tag, "byte_order") == "BigEndian") {
    refuseMesh(file, "is compressed or big-endian, which is not read");
  }
  const std::string headerType = attribute(root->tag, "header_type");
  const auto points = firstElement(root->body, "Points");
  const auto polys = firstElement(root->body, "Polys");
  const auto array = points ? firstElement(points->body, "DataArray") : std::nullopt;
  if (!array || !polys) {
    refuseMesh(file, "has no points or no polygons");
  }
  const std::vector<double> coordinates = arrayValues(*array, headerType, file);
  if (coordinates.size() % 3 != 0) {
    refuseMesh(file, "has points that are not three numbers each");
  }
  SurfaceMesh mesh;
  mesh.vertices.reserve(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    const Vec3 v(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    if (!v.allFinite()) {
      refuseMesh(file, "has a vertex that is no finite number");
    }
    mesh.vertices.push_back(v);
  }
  addPolygons(mesh, namedArray(polys->body, "connectivity", headerType, file), namedArray(polys->body, "offsets", headerType, file),
              file);
  turnToLps(mesh, bytes.substr(0, std::min<std::size_t>(bytes.size(), 512)));
  return mesh;
}

}  // namespace glisson
