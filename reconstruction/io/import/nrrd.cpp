// NRRD (.nrrd, .nhdr) and 3D Slicer's .seg.nrrd. Source: http://teem.sourceforge.net/nrrd/format.html and
// https://slicer.readthedocs.io (Modules/Segmentations, "segmentation file format"). LPS, RAS and LAS spaces are turned to LPS
// here.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/image_file.h"
#include "reconstruction/io/import/itk_folder.h"
#include "reconstruction/io/import/text_header.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
using Fields = std::map<std::string, std::string>;

struct NrrdHeader {
  Fields fields;  ///< "key: value", keys in lower case without blanks
  Fields values;  ///< "key:=value"
  std::uint64_t offset = 0;
  std::size_t lines = 0;
};

std::string fieldKey(std::string_view key) {
  std::string plain = toLower(key);
  std::erase_if(plain, [](char c) { return c == ' ' || c == '\t'; });
  return plain;
}

std::string unescaped(const std::string& text) {
  std::string plain;
  for (std::size_t n = 0; n < text.size(); ++n) {
    if (text[n] == '\\' && n + 1 < text.size() && (text[n + 1] == 'n' || text[n + 1] == '\\')) {
      plain.push_back(text[++n] == 'n' ? ' ' : '\\');
    } else {
      plain.push_back(text[n]);
    }
  }
  return plain;
}

NrrdHeader parseNrrdHeader(const std::filesystem::path& path) {
  const TextHeader text = readTextHeader(path, [](std::string_view line) { return line.empty(); });
  if (!text.lines.front().starts_with("NRRD000")) {
    throw InputError(path.string() + " is not a NRRD file although its name says so; export it again.");
  }
  NrrdHeader header;
  header.offset = text.offset;
  header.lines = text.lines.size();
  for (const std::string& line : text.lines) {
    const std::size_t colon = line.find(':');
    if (line.starts_with('#') || colon == std::string::npos) {
      continue;
    }
    if (line.compare(colon, 2, ":=") == 0) {
      header.values[line.substr(0, colon)] = unescaped(line.substr(colon + 2));
    } else {
      header.fields[fieldKey(line.substr(0, colon))] = trim(line.substr(colon + 1));
    }
  }
  return header;
}

const std::string& require(const std::string& name, const NrrdHeader& header, const std::string& key) {
  const auto found = header.fields.find(key);
  if (found == header.fields.end()) {
    throw InputError(name + " has no \"" + key + "\" in its NRRD header; export it again.");
  }
  return found->second;
}

std::string optional(const NrrdHeader& header, const std::string& key) {
  const auto found = header.fields.find(key);
  return found == header.fields.end() ? std::string() : found->second;
}

Scalar scalarOfNrrd(const std::string& name, const std::string& type) {
  static const std::map<std::string, Scalar> kTypes{{"signed char", Scalar::I8},
                                                    {"int8", Scalar::I8},
                                                    {"int8_t", Scalar::I8},
                                                    {"uchar", Scalar::U8},
                                                    {"unsigned char", Scalar::U8},
                                                    {"uint8", Scalar::U8},
                                                    {"uint8_t", Scalar::U8},
                                                    {"short", Scalar::I16},
                                                    {"short int", Scalar::I16},
                                                    {"signed short", Scalar::I16},
                                                    {"signed short int", Scalar::I16},
                                                    {"int16", Scalar::I16},
                                                    {"int16_t", Scalar::I16},
                                                    {"ushort", Scalar::U16},
                                                    {"unsigned short", Scalar::U16},
                                                    {"unsigned short int", Scalar::U16},
                                                    {"uint16", Scalar::U16},
                                                    {"uint16_t", Scalar::U16},
                                                    {"int", Scalar::I32},
                                                    {"signed int", Scalar::I32},
                                                    {"int32", Scalar::I32},
                                                    {"int32_t", Scalar::I32},
                                                    {"uint", Scalar::U32},
                                                    {"unsigned int", Scalar::U32},
                                                    {"uint32", Scalar::U32},
                                                    {"uint32_t", Scalar::U32},
                                                    {"longlong", Scalar::I64},
                                                    {"long long", Scalar::I64},
                                                    {"long long int", Scalar::I64},
                                                    {"int64", Scalar::I64},
                                                    {"int64_t", Scalar::I64},
                                                    {"ulonglong", Scalar::U64},
                                                    {"unsigned long long", Scalar::U64},
                                                    {"unsigned long long int", Scalar::U64},
                                                    {"uint64", Scalar::U64},
                                                    {"uint64_t", Scalar::U64},
                                                    {"float", Scalar::F32},
                                                    {"double", Scalar::F64}};
  const auto found = kTypes.find(type);
  if (found == kTypes.end()) {
    throw InputError(name + " holds voxels of NRRD type \"" + type + "\", which is not read; save it as integers or floats.");
  }
  return found->second;
}

/// The factors that turn the file's space into LPS.
Vec3 spaceToLps(const std::string& name, const std::string& space) {
  const std::string lower = toLower(space);
  if (lower == "left-posterior-superior" || lower == "lps") {
    return {1, 1, 1};
  }
  if (lower == "right-anterior-superior" || lower == "ras") {
    return {-1, -1, 1};
  }
  if (lower == "left-anterior-superior" || lower == "las") {
    return {1, -1, 1};
  }
  if (space.empty()) {
    throw InputError(name + " says nowhere how it lies in the patient (no \"space\"); export it again with its orientation.");
  }
  throw InputError(name + " lies in the space \"" + space + "\", which is not read; save it in LPS or RAS.");
}

/// "(1,0,0) none (0,1,0)" as texts, one per axis.
std::vector<std::string> axisVectors(const std::string& text) {
  std::vector<std::string> vectors;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string::npos) {
    const std::size_t end =
        text[at] == '(' ? std::min(text.find(')', at), text.size() - 1) + 1 : std::min(text.find_first_of(" \t(", at), text.size());
    vectors.push_back(text.substr(at, end - at));
    at = end;
  }
  return vectors;
}

Vec3 vectorOf(const std::string& name, const std::string& field, std::string text) {
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') {
    throw InputError(name + " has no vector in its header field \"" + field + "\"; export it again.");
  }
  text = text.substr(1, text.size() - 2);
  std::ranges::replace(text, ',', ' ');
  const auto values = numbers(name, field, text, 3);
  return {values[0], values[1], values[2]};
}

/// Sizes, geometry and layers. The layer axis is the one without a direction; ITK puts it first where it comes last.
void setGrid(const std::string& name, const NrrdHeader& header, const ReadOptions& options, ImageFile& file, ItkInput& itk) {
  const std::uint64_t dimension = countOf(name, "dimension", require(name, header, "dimension"));
  if (dimension != 3 && dimension != 4) {
    throw InputError(name + " has " + std::to_string(dimension) + " dimensions; a volume with three is needed.");
  }
  const auto sizes = numbers(name, "sizes", require(name, header, "sizes"), dimension);
  const std::vector<std::string> directions = axisVectors(require(name, header, "spacedirections"));
  const std::vector<std::string> kinds = words(toLower(optional(header, "kinds")));
  if (directions.size() != dimension || (!kinds.empty() && kinds.size() != dimension)) {
    throw InputError(name + " does not have one direction and kind per axis in its NRRD header; export it again.");
  }
  const Vec3 toLps = spaceToLps(name, optional(header, "space"));
  Mat3 steps = Mat3::Zero();
  std::array<double, 3> gridSize{};
  double layers = 1;
  std::size_t domain = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (!kinds.empty() && kinds[axis] == "time" && sizes[axis] > 1) {
      throw InputError(name + " is a time series; save the one volume that is meant.");
    }
    if (directions[axis] == "none") {
      const bool listed = !kinds.empty() && kinds[axis] == "list";
      const bool segments = header.values.contains("Segment0_ID") || header.values.contains("Segment0_Name");
      if (dimension != 4 || layers != 1 || (sizes[axis] > 1 && !listed && !segments) || (axis != 0 && axis != 3)) {
        throw InputError(name + " is a time series or has several values per voxel; save the one volume that is meant.");
      }
      layers = sizes[axis];
      itk.reorders = axis != 0 && layers > 1;
      continue;
    }
    if (domain == 3) {
      throw InputError(name + " is a time series; save the one volume that is meant.");
    }
    gridSize[domain] = sizes[axis];
    steps.col(static_cast<Eigen::Index>(domain)) = toLps.cwiseProduct(vectorOf(name, "space directions", directions[axis]));
    ++domain;
  }
  if (domain != 3 || !(layers >= 1) || layers > 4096) {
    throw InputError(name + " does not have three axes with a direction in its NRRD header; export it again.");
  }
  for (const double size : {gridSize[0], gridSize[1], gridSize[2], layers}) {
    if (size != std::floor(size)) {
      throw InputError(name + " has a size that is not a whole number in its NRRD header; export it again.");
    }
  }
  requireBudget(name, gridSize, layers, static_cast<double>(bytesOf(file.scalar)), options);
  for (std::size_t a = 0; a < 3; ++a) {
    file.geometry.size[a] = static_cast<int>(gridSize[a]);
  }
  file.layers = static_cast<int>(layers);
  // ITK 5.2 turns LAS to LPS by the wrong axis (it mirrors left and right): its values are right, its place is not.
  itk.judgesPlace = toLps != spaceToLps(name, "las");
  file.geometry.origin = toLps.cwiseProduct(vectorOf(name, "space origin", require(name, header, "spaceorigin")));
  setSteps(name, steps, file);
  const std::string units = toLower(optional(header, "spaceunits"));
  if (!units.empty() && units.find("\"mm\"") == std::string::npos) {
    throw InputError(name + " gives its lengths in " + units + "; save it in mm.");
  }
}

std::optional<Rgb> colourOf(const std::string& text) {
  std::array<std::uint8_t, 3> rgb{};
  const auto parts = words(text);
  for (std::size_t n = 0; n < 3; ++n) {
    const auto value = n < parts.size() ? parseNumber(parts[n]) : std::nullopt;
    if (!value) {
      return std::nullopt;
    }
    rgb[n] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(*value, 0.0, 1.0)));
  }
  return Rgb{rgb[0], rgb[1], rgb[2]};
}

void setSegments(const std::string& name, const NrrdHeader& header, ImageFile& file) {
  const auto value = [&](const std::string& key) {
    const auto found = header.values.find(key);
    return found == header.values.end() ? std::string() : found->second;
  };
  for (int n = 0; n < 4096; ++n) {
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    if (value(prefix + "ID").empty() && value(prefix + "Name").empty()) {
      break;
    }
    Segment segment;
    segment.name = value(prefix + "Name").empty() ? value(prefix + "ID") : value(prefix + "Name");
    segment.colour = colourOf(value(prefix + "Color"));
    if (const auto label = parseInteger(value(prefix + "LabelValue"))) {
      segment.label = static_cast<int>(*label);
    }
    const auto layer = parseInteger(value(prefix + "Layer"));
    segment.layer = layer ? static_cast<int>(*layer) : (file.layers > 1 ? n : 0);  // before Slicer 4.11: one layer per segment
    if (segment.layer < 0 || segment.layer >= file.layers) {
      throw InputError(name + " has no layer " + std::to_string(segment.layer) + " for its segment \"" + segment.name +
                       "\"; export it again.");
    }
    if (!segment.label && file.layers == 1) {
      segment.label = n + 1;
    }
    file.segments.push_back(std::move(segment));
  }
}

/// The fields that say where and what the voxels are, word for word and in the order that the format asks for, in front of a link
/// to them.
ItkFile headerForItk(const std::string& name, const ItkFolder& folder, const NrrdHeader& header, const std::filesystem::path& data,
                     bool attached) {
  std::string kinds;
  for (const std::string& direction : axisVectors(optional(header, "spacedirections"))) {
    kinds += direction == "none" ? " list" : " domain";
  }
  std::string text = "NRRD0004\n";
  for (const char* key : {"type", "dimension", "sizes", "space"}) {
    text += std::string(key) + ": " + optional(header, key) + "\n";
  }
  text += "kinds:" + kinds + "\nspace directions: " + optional(header, "spacedirections") +
          "\nspace origin: " + optional(header, "spaceorigin") + "\nencoding: " + optional(header, "encoding") + "\n";
  if (const std::string endian = optional(header, "endian"); !endian.empty()) {
    text += "endian: " + endian + "\n";
  }
  if (attached) {
    text += "line skip: " + std::to_string(header.lines) + "\n";
  }
  folder.link("voxels", data);
  return {ItkFormat::Nrrd, name, folder.write("header.nhdr", text + "data file: voxels\n"), {}};
}
}  // namespace

ImageFile readNrrd(const std::filesystem::path& path, const ReadOptions& options, Extent extent) {
  const std::string name = path.string();
  const NrrdHeader header = parseNrrdHeader(path);
  ImageFile file;
  file.scalar = scalarOfNrrd(name, toLower(require(name, header, "type")));
  ItkInput itk;
  setGrid(name, header, options, file, itk);
  setSegments(name, header, file);
  if (bytesOf(file.scalar) > 1) {
    const std::string endian = toLower(require(name, header, "endian"));
    if (endian != "little" && endian != "big") {
      throw InputError(name + " gives no byte order in its NRRD header; export it again.");
    }
    file.bigEndian = endian == "big";
  }
  for (const char* skip : {"lineskip", "byteskip"}) {
    if (!optional(header, skip).empty() && optional(header, skip) != "0") {
      throw InputError(name + " skips part of its data (\"" + skip + "\"), which is not read; save it as one plain .nrrd file.");
    }
  }
  const std::string encoding = toLower(require(name, header, "encoding"));
  if (encoding != "raw" && encoding != "gzip" && encoding != "gz") {
    throw InputError(name + " is stored with the encoding \"" + encoding + "\"; save it as raw or gzip.");
  }
  const std::string data = optional(header, "datafile") + optional(header, "data file");
  const std::filesystem::path dataPath = data.empty() ? path : besideHeader(path, data);
  ByteSource source(dataPath, data.empty() ? header.offset : 0, encoding == "raw" ? Coding::Raw : Coding::Gzip);
  const ItkFolder folder(path);
  itk.file = headerForItk(name, folder, header, dataPath, data.empty());
  readValues(dataPath.string(), source, itk, file, extent);
  return file;
}

}  // namespace glisson::import
