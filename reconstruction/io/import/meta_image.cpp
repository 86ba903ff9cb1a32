// MetaImage (.mha, .mhd). Source: https://itk.org/Wiki/ITK/MetaIO/Documentation. Its world is LPS; TransformMatrix lists the axes'
// directions one after another.

#include <algorithm>
#include <array>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/image_file.h"
#include "reconstruction/io/import/itk_folder.h"
#include "reconstruction/io/import/text_header.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
struct MetaHeader {
  std::map<std::string, std::string> fields;  ///< keys in lower case
  std::uint64_t offset = 0;
};

MetaHeader parseMetaHeader(const std::filesystem::path& path) {
  const TextHeader text =
      readTextHeader(path, [](std::string_view line) { return toLower(line.substr(0, 16)).starts_with("elementdatafile"); });
  MetaHeader header;
  header.offset = text.offset;
  for (const std::string& line : text.lines) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) {
      if (!trim(line).empty()) {
        throw InputError(path.string() + " has a line without \"=\" in its MetaImage header; export it again.");
      }
      continue;
    }
    const std::string key = toLower(trim(line.substr(0, equals)));
    if (key.size() > 255) {
      throw InputError(path.string() +
                       " has a header field with a name of more than 255 bytes; it is damaged, so export it again.");
    }
    header.fields[key] = trim(line.substr(equals + 1));
  }
  return header;
}

/// The first of several names of one field that is there, else `otherwise`.
std::string field(const MetaHeader& header, std::initializer_list<const char*> keys, const std::string& otherwise) {
  for (const char* key : keys) {
    if (const auto found = header.fields.find(key); found != header.fields.end()) {
      return found->second;
    }
  }
  return otherwise;
}

constexpr std::initializer_list<const char*> kPosition{"offset", "position", "origin"};
constexpr std::initializer_list<const char*> kMatrix{"transformmatrix", "rotation", "orientation"};
constexpr std::initializer_list<const char*> kSpacing{"elementspacing", "elementsize"};

bool isTrue(const std::string& text) { return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1'); }

bool isBigEndian(const MetaHeader& header) {
  return isTrue(field(header, {"elementbyteordermsb", "binarydatabyteordermsb"}, "False"));
}

Scalar scalarOfMetaImage(const std::string& name, const std::string& type) {
  static const std::map<std::string, Scalar> kTypes{
      {"MET_UCHAR", Scalar::U8},  {"MET_CHAR", Scalar::I8},       {"MET_USHORT", Scalar::U16},     {"MET_SHORT", Scalar::I16},
      {"MET_UINT", Scalar::U32},  {"MET_INT", Scalar::I32},       {"MET_ULONG", Scalar::U32},      {"MET_LONG", Scalar::I32},
      {"MET_FLOAT", Scalar::F32}, {"MET_LONG_LONG", Scalar::I64}, {"MET_ULONG_LONG", Scalar::U64}, {"MET_DOUBLE", Scalar::F64}};
  const auto found = kTypes.find(type);
  if (found == kTypes.end()) {
    throw InputError(name + " holds voxels of the MetaImage type \"" + type +
                     "\", which is not read; save it as integers or floats.");
  }
  return found->second;
}

void setGrid(const std::string& name, const MetaHeader& header, const ReadOptions& options, ImageFile& file) {
  if (const std::string dims = field(header, {"ndims"}, ""); dims != "3") {
    throw InputError(name + " has " + (dims.empty() ? "an unknown number of" : dims) +
                     " dimensions; save the one volume with three that is meant.");
  }
  if (field(header, {"elementnumberofchannels"}, "1") != "1") {
    throw InputError(name + " has several values per voxel; save one value per voxel.");
  }
  const auto sizes = numbers(name, "DimSize", field(header, {"dimsize"}, ""), 3);
  for (const double size : sizes) {
    if (size != std::floor(size)) {
      throw InputError(name + " has a size that is not a whole number in its MetaImage header; export it again.");
    }
  }
  requireBudget(name, {sizes[0], sizes[1], sizes[2]}, 1, static_cast<double>(bytesOf(file.scalar)), options);
  for (std::size_t a = 0; a < 3; ++a) {
    file.geometry.size[a] = static_cast<int>(sizes[a]);
  }
  const std::string positionText = field(header, kPosition, "");
  const std::string matrixText = field(header, kMatrix, "");
  const std::string spacingText = field(header, kSpacing, "");
  if (positionText.empty() || matrixText.empty() || spacingText.empty()) {
    throw InputError(name +
                     " says nowhere how it lies in the patient (Offset, TransformMatrix, ElementSpacing); export it again with "
                     "its orientation.");
  }
  const auto position = numbers(name, "Offset", positionText, 3);
  const auto matrix = numbers(name, "TransformMatrix", matrixText, 9);
  const auto spacing = numbers(name, "ElementSpacing", spacingText, 3);
  Mat3 steps;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(spacing[axis] > 0)) {
      throw InputError(name + " has a voxel size that is not above zero in its MetaImage header; export it again.");
    }
    const Vec3 direction(matrix[3 * axis], matrix[3 * axis + 1], matrix[3 * axis + 2]);
    if (std::abs(direction.norm() - 1) > 1e-3) {
      throw InputError(name +
                       " has an axis in its TransformMatrix that is not a unit vector; resample it to a straight grid first.");
    }
    steps.col(static_cast<Eigen::Index>(axis)) = direction.normalized() * spacing[axis];
  }
  file.geometry.origin = Vec3(position[0], position[1], position[2]);
  setSteps(name, steps, file);
}

/// The lines that say where and what the voxels are, word for word, in front of a link to them.
ItkFile headerForItk(const std::string& name, const ItkFolder& folder, const MetaHeader& header, const std::filesystem::path& data,
                     std::uint64_t offset) {
  const auto truth = [](bool value) { return std::string(value ? "True" : "False"); };
  const bool compressed = isTrue(field(header, {"compresseddata"}, "False"));
  std::string text = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = " + truth(isBigEndian(header)) +
                     "\nCompressedData = " + truth(compressed);
  if (compressed) {
    text += "\nCompressedDataSize = " + std::to_string(std::filesystem::file_size(data) - offset);
  }
  text += "\nTransformMatrix = " + field(header, kMatrix, "") + "\nOffset = " + field(header, kPosition, "") +
          "\nElementSpacing = " + field(header, kSpacing, "") + "\nDimSize = " + field(header, {"dimsize"}, "");
  if (offset > 0) {
    text += "\nHeaderSize = " + std::to_string(offset);
  }
  text += "\nElementType = " + field(header, {"elementtype"}, "") + "\nElementDataFile = voxels\n";
  folder.link("voxels", data);
  return {ItkFormat::MetaImage, name, folder.write("header.mhd", text), {}};
}
}  // namespace

ImageFile readMetaImage(const std::filesystem::path& path, const ReadOptions& options, Extent extent) {
  const std::string name = path.string();
  const MetaHeader header = parseMetaHeader(path);
  if (const std::string type = field(header, {"objecttype"}, "Image"); type != "Image") {
    throw InputError(name + " is a MetaIO file of type \"" + type + "\", not an image; give the image.");
  }
  ImageFile file;
  file.scalar = scalarOfMetaImage(name, field(header, {"elementtype"}, ""));
  setGrid(name, header, options, file);
  file.bigEndian = isBigEndian(header);
  if (!isTrue(field(header, {"binarydata"}, "True")) || field(header, {"headersize"}, "0") != "0") {
    throw InputError(name + " stores its voxels as text or behind a foreign header, which is not read; save it as one .mha file.");
  }
  const bool compressed = isTrue(field(header, {"compresseddata"}, "False"));
  const std::string data = field(header, {"elementdatafile"}, "");
  const bool local = toLower(data) == "local";
  if (!local && (data.starts_with("LIST") || data.find('%') != std::string::npos)) {
    throw InputError(name + " spreads its slices over several files, which is not read; save it as one .mha file.");
  }
  const std::filesystem::path dataPath = local ? path : besideHeader(path, data);
  const std::uint64_t offset = local ? header.offset : 0;
  ByteSource source(dataPath, offset, compressed ? Coding::Zlib : Coding::Raw);
  const ItkFolder folder(path);
  readValues(dataPath.string(), source, {headerForItk(name, folder, header, dataPath, offset)}, file, extent);
  return file;
}

}  // namespace glisson::import
