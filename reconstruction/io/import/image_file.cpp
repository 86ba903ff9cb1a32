#include "reconstruction/io/import/image_file.h"

#include <zlib.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr std::array kEndings{".nii.gz", ".nii", ".seg.nrrd", ".nrrd", ".nhdr", ".mha", ".mhd"};

void swapBytes(std::span<std::uint8_t> bytes, std::size_t width) {
  for (std::size_t n = 0; n + width <= bytes.size(); n += width) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(n), bytes.begin() + static_cast<std::ptrdiff_t>(n + width));
  }
}
}  // namespace

std::size_t bytesOf(Scalar scalar) {
  switch (scalar) {
    case Scalar::U8:
    case Scalar::I8:
      return 1;
    case Scalar::U16:
    case Scalar::I16:
      return 2;
    case Scalar::U32:
    case Scalar::I32:
    case Scalar::F32:
      return 4;
    case Scalar::U64:
    case Scalar::I64:
    case Scalar::F64:
      break;
  }
  return 8;
}

bool isImageFileName(const std::filesystem::path& path) {
  const std::string name = toLower(path.filename().string());
  return std::ranges::any_of(kEndings, [&](const char* ending) { return name.ends_with(ending); });
}

std::string stemOf(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  const std::string lower = toLower(name);
  for (const std::string_view ending : kEndings) {
    if (lower.ends_with(ending)) {
      return name.substr(0, name.size() - ending.size());
    }
  }
  return name;
}

ImageFile readImageFile(const std::filesystem::path& path, const ReadOptions& options, Extent extent) {
  const std::string name = toLower(path.filename().string());
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) {
    return readNifti(path, options, extent);
  }
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) {
    return readNrrd(path, options, extent);
  }
  if (name.ends_with(".mha") || name.ends_with(".mhd")) {
    return readMetaImage(path, options, extent);
  }
  throw InputError(path.string() + " is of no known format; give a DICOM folder, .nii, .nii.gz, .nrrd, .seg.nrrd, .mha or .mhd.");
}

void requireBudget(const std::string& name, const std::array<double, 3>& sizes, double layers, double bytesPerVoxel,
                   const ReadOptions& options) {
  for (const double size : sizes) {
    if (!(size >= 1) || size > 1e9) {
      throw InputError(name + " has an impossible grid of " + formatNumber(sizes[0], 0) + "x" + formatNumber(sizes[1], 0) + "x" +
                       formatNumber(sizes[2], 0) + " voxels; export it again.");
    }
  }
  const double bytes = sizes[0] * sizes[1] * sizes[2] * layers * bytesPerVoxel;
  if (bytes > static_cast<double>(options.budgetBytes)) {
    throw InputError(name + " promises " + formatNumber(bytes / 1073741824.0, 1) + " GiB of voxels, more than the " +
                     formatNumber(static_cast<double>(options.budgetBytes) / 1073741824.0, 1) +
                     " GiB that are allowed; crop or resample it first.");
  }
}

void setSteps(const std::string& name, const Mat3& steps, ImageFile& file) {
  ImageGeometry& geometry = file.geometry;
  if (!steps.allFinite() || !geometry.origin.allFinite()) {
    throw InputError(name + " has a position or direction in its header that is not a finite number; export it again.");
  }
  for (int a = 0; a < 3; ++a) {
    geometry.spacing[a] = steps.col(a).norm();
    if (!(geometry.spacing[a] > 1e-6)) {
      throw InputError(name + " has a voxel size of zero in its header; export it again.");
    }
    geometry.direction.col(a) = steps.col(a) / geometry.spacing[a];
  }
  const Eigen::JacobiSVD<Mat3> svd(geometry.direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 nearest = svd.matrixU() * svd.matrixV().transpose();
  double worst = 0;
  for (int corner = 1; corner < 8; ++corner) {
    Vec3 index;
    for (int a = 0; a < 3; ++a) {
      index[a] = ((corner >> a) & 1) != 0 ? geometry.size[static_cast<std::size_t>(a)] - 1 : 0;
    }
    worst = std::max(worst, ((geometry.direction - nearest) * geometry.spacing.cwiseProduct(index)).norm());
  }
  if (!(worst <= kSamePlaceMm)) {
    throw InputError(name + " has axes that are not at right angles (" + formatNumber(worst, 2) +
                     " mm at the corners); resample it to a straight grid first.");
  }
  geometry.direction = nearest;
  file.ambiguityMm += worst;
  if (worst > kSameGridMm) {
    file.notes.push_back("The axes were set at right angles (" + formatNumber(worst, 3) + " mm at the corners).");
  }
}

namespace {
[[noreturn]] void refuseCutOff(const std::string& name, const std::string& found, std::size_t expected) {
  throw InputError(name + " is cut off: it holds " + found + " of the " + std::to_string(expected) +
                   " bytes of voxels its header promises; copy or export it again.");
}

template <typename T>
bool allFinite(std::span<const std::uint8_t> bytes) {
  for (std::size_t n = 0; n + sizeof(T) <= bytes.size(); n += sizeof(T)) {
    T value{};
    std::memcpy(&value, &bytes[n], sizeof(T));
    if (!std::isfinite(value)) {
      return false;
    }
  }
  return true;
}

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

/// Reads the source to its end, piece by piece, and returns the checksum of the values in native byte order. ITK sets what is not
/// finite to zero without a word, so that is looked for here.
unsigned long verifyValues(const std::string& name, ByteSource& source, const ImageFile& file) {
  const std::size_t width = bytesOf(file.scalar);
  const std::size_t expected = file.valueCount() * width;
  std::vector<std::uint8_t> buffer(std::min(expected, kPieceBytes));
  unsigned long checksum = adler32_z(0, nullptr, 0);
  for (std::size_t done = 0; done < expected;) {
    const std::span piece = std::span(buffer).first(std::min(expected - done, buffer.size()));
    const std::size_t found = source.read(piece.data(), piece.size());
    if (found < piece.size()) {
      refuseCutOff(name, std::to_string(done + found), expected);
    }
    if (file.bigEndian) {
      swapBytes(piece, width);
    }
    if ((file.scalar == Scalar::F32 && !allFinite<float>(piece)) || (file.scalar == Scalar::F64 && !allFinite<double>(piece))) {
      throw InputError(name + " holds voxels that are not finite numbers; export it again.");
    }
    checksum = adler32_z(checksum, piece.data(), piece.size());
    done += piece.size();
  }
  std::uint8_t extra = 0;
  if (source.read(&extra, 1) != 0) {
    throw InputError(name + " holds more than the " + std::to_string(expected) +
                     " bytes of voxels its header promises; copy or export it again.");
  }
  return checksum;
}

/// Of the values in the file's order, where `layers` that lie side by side follow one another in the file.
unsigned long checksumOf(std::span<const std::uint8_t> bytes, std::size_t width, std::size_t layers) {
  unsigned long checksum = adler32_z(0, nullptr, 0);
  if (layers == 1) {
    return adler32_z(checksum, bytes.data(), bytes.size());
  }
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for (std::size_t at = layer * width; at < bytes.size(); at += layers * width) {
      checksum = adler32_z(checksum, &bytes[at], width);
    }
  }
  return checksum;
}

/// How far a corner lies from where ITK sees it (mm). A header without a place tells the size of a voxel still.
double apartFromItk(const ImageGeometry& ours, const ItkHeader& header) {
  ImageGeometry theirs = ours;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto column = static_cast<Eigen::Index>(a);
    theirs.spacing[column] = header.spacing[a];
    if (header.placed) {
      theirs.origin[column] = header.origin[a];
      theirs.direction.col(column) = Vec3(header.axes[a][0], header.axes[a][1], header.axes[a][2]);
    }
  }
  return ours.cornerDistance(theirs);
}

/// A second reading of the same header, by other code: where the two differ, one of them would mirror or shift the patient.
void requireAgreement(const ItkInput& itk, const ImageFile& file, const ItkHeader& header) {
  const auto refuse = [&](const std::string& fact) {
    throw InputError(itk.file.name + " has a header that ITK reads otherwise: " + fact + "; export it again.");
  };
  const auto text = [](const auto& sizes) {
    std::string joined;
    for (const auto size : sizes) {
      joined += (joined.empty() ? "" : "x") + std::to_string(size);
    }
    return joined;
  };
  if (!std::ranges::equal(header.sizes, file.geometry.size, {}, {}, [](int size) { return static_cast<std::size_t>(size); })) {
    refuse(text(header.sizes) + " voxels instead of " + text(file.geometry.size));
  }
  if (header.valuesPerVoxel != static_cast<std::size_t>(file.layers)) {
    refuse(std::to_string(header.valuesPerVoxel) + " values per voxel instead of " + std::to_string(file.layers));
  }
  if (header.scalar != file.scalar) {
    refuse("voxels of another type");
  }
  if (!itk.judgesPlace) {
    return;
  }
  const double apart = apartFromItk(file.geometry, header);
  if (!(apart <= kSamePlaceMm + file.ambiguityMm)) {
    const std::string fact = "a corner lies " + (std::isfinite(apart) ? formatNumber(apart, 2) + " mm" : "far") + " from ours";
    if (itk.file.format == ItkFormat::Nifti) {
      throw InputError(itk.file.name + " has a header that ITK reads otherwise: " + fact +
                       ", as a voxel size (pixdim) unlike the sform makes it do; choose with --prefer sform or --prefer qform.");
    }
    refuse(fact);
  }
}
}  // namespace

void readValues(const std::string& name, ByteSource& source, const ItkInput& itk, ImageFile& file, Extent extent) {
  const std::size_t width = bytesOf(file.scalar);
  const std::size_t expected = file.valueCount() * width;
  if (source.mostBytesLeft() < expected) {
    refuseCutOff(name, "at most " + std::to_string(source.mostBytesLeft()), expected);
  }
  if (extent == Extent::Peek) {
    file.bytes.resize(std::min(expected, kPieceBytes));
    const std::size_t found = source.read(file.bytes.data(), file.bytes.size());
    if (found < file.bytes.size()) {
      refuseCutOff(name, std::to_string(found), expected);
    }
    if (file.bigEndian) {
      swapBytes(file.bytes, width);
    }
    return;
  }
  const unsigned long checksum = verifyValues(name, source, file);
  file.bytes = decodeWithItk(itk.file, [&](const ItkHeader& header) { requireAgreement(itk, file, header); });
  const std::size_t layers = itk.reorders ? static_cast<std::size_t>(file.layers) : 1;
  if (file.bytes.size() != expected || checksumOf(file.bytes, width, layers) != checksum) {
    throw InputError(itk.file.name + " holds other voxels than ITK finds in it; export it again.");
  }
}

std::filesystem::path besideHeader(const std::filesystem::path& header, const std::string& dataFile) {
  const std::filesystem::path named(dataFile);
  if (dataFile.empty() || named.has_parent_path() || dataFile == "." || dataFile == "..") {
    throw InputError(header.string() + " names its data file \"" + dataFile +
                     "\", which is not a plain name beside it; save header and data as one file.");
  }
  std::filesystem::path data = header.parent_path() / named;
  if (!std::filesystem::is_regular_file(data)) {
    throw InputError(header.string() + " names its data file \"" + dataFile + "\", which is not beside it; copy both files.");
  }
  return data;
}

}  // namespace glisson::import
