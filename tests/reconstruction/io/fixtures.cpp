#include "tests/reconstruction/io/fixtures.h"

#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "reconstruction/text.h"

namespace glisson::fixtures {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "glisson-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("no temporary folder");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string refusalOfCt(const fs::path& path, const ReadOptions& options) {
  return refusal([&] { readCt(path, options); });
}

ReadOptions accepting(std::set<Consent> consents) {
  ReadOptions options;
  options.consents = std::move(consents);
  return options;
}

void writeFile(const fs::path& path, const Bytes& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) {
    throw std::runtime_error("fixture not written");
  }
}

Bytes readFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

namespace {
Bytes deflated(const Bytes& bytes, int windowBits) {
  z_stream stream{};
  if (deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib");
  }
  Bytes out(deflateBound(&stream, bytes.size()) + 64);
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

void append(Bytes& bytes, const std::string& text) { bytes.insert(bytes.end(), text.begin(), text.end()); }
void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }
}  // namespace

Bytes gzip(const Bytes& bytes) { return deflated(bytes, 15 + 16); }
Bytes zlibCompressed(const Bytes& bytes) { return deflated(bytes, 15); }

ImageGeometry permutedGrid(int code, double degrees) {
  constexpr std::array<Index3, 6> kOrders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  const Index3& order = kOrders[static_cast<std::size_t>(code / 8)];
  ImageGeometry geometry;
  geometry.size = {9, 8, 7};
  geometry.spacing = Vec3(0.75, 1.25, 2.5);
  geometry.direction.setZero();
  for (int a = 0; a < 3; ++a) {
    geometry.direction(order[static_cast<std::size_t>(a)], a) = ((code >> a) & 1) != 0 ? -1 : 1;
  }
  const Mat3 turn = Eigen::AngleAxisd(degrees * 3.14159265358979 / 180, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  geometry.direction = turn * geometry.direction;
  geometry.origin = Vec3(-37.5, 81.25, 1203.125);
  return geometry;
}

std::vector<std::uint8_t> asymmetricBody(const ImageGeometry& geometry) {
  const Index3& size = geometry.size;
  const Vec3 centre = geometry.toWorld(Vec3(size[0] - 1, size[1] - 1, size[2] - 1) / 2);
  std::vector<std::uint8_t> values;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const Vec3 p = geometry.toWorld(Vec3(i, j, k)) - centre;
        const bool bar = std::abs(p[0]) < 1.4 && std::abs(p[1]) < 1.4;
        const bool arm = p[0] > 0 && p[0] < 4.1 && std::abs(p[1]) < 1.4 && std::abs(p[2]) < 1.4;
        const bool knob = p[1] > 0 && p[1] < 2.8 && std::abs(p[0]) < 1.4 && p[2] > 1.2;
        values.push_back(bar || arm || knob ? 1 : 0);
      }
    }
  }
  return values;
}

std::string faultOfBody(const Segmentation& read, const ImageGeometry& expected) {
  const double apart = read.geometry.cornerDistance(expected);
  if (!(apart <= 1e-3)) {
    return formatNumber(apart, 4) + " mm off: " + read.geometry.describe();
  }
  if (read.structures.size() != 1) {
    return std::to_string(read.structures.size()) + " structures";
  }
  const Mask mask = Mask::fromGrid(expected.size, asymmetricBody(expected));
  const Mask& found = *read.structures[0].mask;
  return !mask.empty() && found.box() == mask.box() && std::ranges::equal(found.values(), mask.values()) ? "" : "another body";
}

namespace {
class NiftiHeader {
 public:
  explicit NiftiHeader(bool bigEndian) : bigEndian_(bigEndian), bytes_(352, 0) {}
  template <typename T>
  void put(std::size_t offset, T value) {
    const Bytes raw = bytesOf(std::vector<T>{value}, bigEndian_);
    std::copy(raw.begin(), raw.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(offset));
  }
  void real(std::size_t offset, double value) { put(offset, static_cast<float>(value)); }
  Bytes& bytes() { return bytes_; }

 private:
  bool bigEndian_;
  Bytes bytes_;
};

void putQform(NiftiHeader& header, const ImageGeometry& geometry) {
  const Mat3 toRas = Vec3(-1, -1, 1).asDiagonal();
  Mat3 rotation = toRas * geometry.direction;
  double flip = 1;
  if (rotation.determinant() < 0) {
    rotation.col(2) = -rotation.col(2);
    flip = -1;
  }
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0) {
    q.coeffs() = -q.coeffs();
  }
  const Vec3 origin = toRas * geometry.origin;
  header.real(76, flip);
  header.real(256, q.x());
  header.real(260, q.y());
  header.real(264, q.z());
  for (int a = 0; a < 3; ++a) {
    header.real(268 + 4 * static_cast<std::size_t>(a), origin[a]);
  }
  header.put<std::int16_t>(252, 1);
}
}  // namespace

Bytes nifti(const ImageGeometry& geometry, const Bytes& voxels, const NiftiOptions& options) {
  NiftiHeader header(options.bigEndian);
  header.put<std::int32_t>(0, 348);
  header.put<std::int16_t>(40, options.timePoints > 1 ? 4 : 3);
  for (std::size_t a = 0; a < 3; ++a) {
    header.put(42 + 2 * a, static_cast<std::int16_t>(geometry.size[a]));
    header.real(80 + 4 * a, geometry.spacing[static_cast<Eigen::Index>(a)]);
  }
  header.put(48, static_cast<std::int16_t>(options.timePoints));
  header.put(70, options.datatype);
  header.put(72, options.bitpix);
  header.real(76, 1);
  header.real(108, 352 + static_cast<double>(options.extension.size()));
  header.real(112, options.slope);
  header.real(116, options.intercept);
  header.bytes()[123] = 2;
  if (options.qform) {
    putQform(header, geometry);
  }
  if (options.sform) {
    header.put<std::int16_t>(254, 1);
    const Mat3 steps = geometry.indexToWorldMatrix();
    for (int row = 0; row < 3; ++row) {
      const double sign = row < 2 ? -1 : 1;
      const std::size_t offset = 280 + 16 * static_cast<std::size_t>(row);
      for (int column = 0; column < 3; ++column) {
        header.real(offset + 4 * static_cast<std::size_t>(column), sign * steps(row, column));
      }
      header.real(offset + 12, sign * geometry.origin[row] + (row == 0 ? options.sformShiftMm : 0));
    }
  }
  std::memcpy(&header.bytes()[344], "n+1", 4);
  Bytes file = header.bytes();
  append(file, options.extension);
  append(file, voxels);
  return file;
}

Bytes nrrd(const ImageGeometry& geometry, const Bytes& voxels, const std::string& type, const std::string& space, bool compressed,
           const std::string& extra, bool bigEndian) {
  Vec3 sign(1, 1, 1);
  if (space.starts_with("right")) {
    sign = Vec3(-1, -1, 1);
  } else if (space == "left-anterior-superior") {
    sign = Vec3(1, -1, 1);
  }
  const auto vector = [&](const Vec3& v) {
    return "(" + formatExact(sign[0] * v[0]) + "," + formatExact(sign[1] * v[1]) + "," + formatExact(sign[2] * v[2]) + ")";
  };
  const Mat3 steps = geometry.indexToWorldMatrix();
  const bool layered = extra.find("dimension: 4") != std::string::npos;
  std::string header = "NRRD0004\n# a comment\ntype: " + type + "\n";
  if (!layered) {
    header += "dimension: 3\nsizes: " + std::to_string(geometry.size[0]) + " " + std::to_string(geometry.size[1]) + " " +
              std::to_string(geometry.size[2]) + "\nkinds: domain domain domain\n";
  }
  header += std::string("space directions: ") + (layered ? "none " : "") + vector(steps.col(0)) + " " + vector(steps.col(1)) + " " +
            vector(steps.col(2)) + "\n";
  header += "space: " + space + "\nspace origin: " + vector(geometry.origin) + "\nendian: " + (bigEndian ? "big" : "little") +
            "\nencoding: " + (compressed ? "gzip" : "raw") + "\n" + extra + "\n";
  Bytes file;
  append(file, header);
  append(file, compressed ? gzip(voxels) : voxels);
  return file;
}

Bytes metaImage(const ImageGeometry& geometry, const Bytes& voxels, const std::string& type, bool compressed) {
  const Bytes data = compressed ? zlibCompressed(voxels) : voxels;
  std::string matrix;
  std::string offset;
  std::string spacing;
  std::string size;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      matrix += " " + formatExact(geometry.direction(b, a));
    }
    offset += " " + formatExact(geometry.origin[a]);
    spacing += " " + formatExact(geometry.spacing[a]);
    size += " " + std::to_string(geometry.size[static_cast<std::size_t>(a)]);
  }
  Bytes file;
  append(file, "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = " +
                   std::string(compressed ? "True\nCompressedDataSize = " + std::to_string(data.size()) : "False") +
                   "\nTransformMatrix =" + matrix + "\nOffset =" + offset +
                   "\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing =" + spacing + "\nDimSize =" + size +
                   "\nElementType = " + type + "\nElementDataFile = LOCAL\n");
  append(file, data);
  return file;
}

namespace {
void element(Bytes& out, std::uint16_t group, std::uint16_t number, const char* vr, Bytes value) {
  if (value.size() % 2 != 0) {
    value.push_back(std::string(vr) == "UI" || std::string(vr) == "OB" ? 0 : ' ');
  }
  append(out, bytesOf(std::vector<std::uint16_t>{group, number}));
  append(out, std::string(vr));
  if (std::string(vr) == "OW" || std::string(vr) == "OB") {
    append(out, Bytes{0, 0});
    append(out, bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value.size())}));
  } else {
    append(out, bytesOf(std::vector<std::uint16_t>{static_cast<std::uint16_t>(value.size())}));
  }
  append(out, value);
}

void text(Bytes& out, std::uint16_t group, std::uint16_t number, const char* vr, const std::string& value) {
  element(out, group, number, vr, Bytes(value.begin(), value.end()));
}

void shortNumber(Bytes& out, std::uint16_t group, std::uint16_t number, int value) {
  element(out, group, number, "US", bytesOf(std::vector<std::uint16_t>{static_cast<std::uint16_t>(value)}));
}

std::string ds(double value) { return formatNumber(value, 9); }
std::string ds(const Vec3& v) { return ds(v[0]) + "\\" + ds(v[1]) + "\\" + ds(v[2]); }
std::string orElse(const std::string& given, const std::string& made) { return given.empty() ? made : given; }
}  // namespace

Bytes dicomSlice(const DicomOptions& o, const Bytes& pixels) {
  const std::string& sopClass = o.sopClass;
  Bytes meta;
  text(meta, 2, 2, "UI", sopClass);
  text(meta, 2, 3, "UI", o.seriesUid + "." + std::to_string(o.instance));
  text(meta, 2, 0x10, "UI", "1.2.840.10008.1.2.1");
  Bytes file(128, 0);
  append(file, std::string("DICM"));
  append(file, bytesOf(std::vector<std::uint16_t>{2, 0}));
  append(file, std::string("UL"));
  append(file, bytesOf(std::vector<std::uint16_t>{4}));
  append(file, bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(meta.size())}));
  append(file, meta);
  text(file, 8, 8, "CS", o.imageType);
  text(file, 8, 0x16, "UI", sopClass);
  text(file, 8, 0x18, "UI", o.seriesUid + "." + std::to_string(o.instance));
  text(file, 8, 0x60, "CS", o.modality);
  text(file, 0x10, 0x20, "LO", o.patientId);
  text(file, 0x20, 0xE, "UI", o.seriesUid);
  text(file, 0x20, 0x13, "IS", std::to_string(o.instance));
  text(file, 0x20, 0x32, "DS", orElse(o.positionText, ds(o.position)));
  text(file, 0x20, 0x37, "DS", orElse(o.orientationText, ds(o.row) + "\\" + ds(o.column)));
  text(file, 0x20, 0x52, "UI", o.frameOfReferenceUid);
  shortNumber(file, 0x28, 2, 1);
  text(file, 0x28, 4, "CS", "MONOCHROME2");
  shortNumber(file, 0x28, 0x10, o.rows);
  shortNumber(file, 0x28, 0x11, o.columns);
  text(file, 0x28, 0x30, "DS", orElse(o.pixelSpacingText, ds(o.rowSpacing) + "\\" + ds(o.columnSpacing)));
  shortNumber(file, 0x28, 0x100, o.bits);
  shortNumber(file, 0x28, 0x101, o.bitsStored);
  shortNumber(file, 0x28, 0x102, o.bitsStored - 1);
  shortNumber(file, 0x28, 0x103, o.isSigned ? 1 : 0);
  if (o.rescaleIntercept) {
    text(file, 0x28, 0x1052, "DS", ds(o.intercept));
  }
  text(file, 0x28, 0x1053, "DS", orElse(o.slopeText, ds(o.slope)));
  element(file, 0x7FE0, 0x10, o.bits == 8 ? "OB" : "OW", pixels);
  return file;
}

void writeCtSeries(const fs::path& folder, const std::vector<double>& heights, DicomOptions options) {
  const Vec3 normal = options.row.cross(options.column);
  const Vec3 start = options.position;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    std::vector<std::int16_t> pixels;
    for (int j = 0; j < options.rows; ++j) {
      for (int i = 0; i < options.columns; ++i) {
        pixels.push_back(static_cast<std::int16_t>(static_cast<int>(k) * 100 + 10 * j + i - 500));
      }
    }
    options.position = start + heights[k] * normal;
    options.instance = static_cast<int>(heights.size() - k);  // names and numbers run against the positions
    std::string name = "slice_" + std::to_string(100 - k);
    writeFile(folder / name, dicomSlice(options, bytesOf(pixels)));
  }
}

}  // namespace glisson::fixtures
