#include "reconstruction/io/import/image_file.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr std::array kEndings{".nii.gz", ".nii", ".seg.nrrd", ".nrrd", ".nhdr", ".mha", ".mhd"};

void swapBytes(std::vector<std::uint8_t>& bytes, std::size_t width) {
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

void setSteps(const std::string& name, const Mat3& steps, ImageGeometry& geometry, std::vector<std::string>& notes) {
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
  if (!(worst <= 0.1)) {
    throw InputError(name + " has axes that are not at right angles (" + formatNumber(worst, 2) +
                     " mm at the corners); resample it to a straight grid first.");
  }
  geometry.direction = nearest;
  if (worst > kSameGridMm) {
    notes.push_back("The axes were set at right angles (" + formatNumber(worst, 3) + " mm at the corners).");
  }
}

void readValues(const std::string& name, ByteSource& source, ImageFile& file, Extent extent) {
  const std::size_t width = bytesOf(file.scalar);
  const std::size_t expected = file.valueCount() * width;
  const auto cutOff = [&](const std::string& found) {
    throw InputError(name + " is cut off: it holds " + found + " of the " + std::to_string(expected) +
                     " bytes of voxels its header promises; copy or export it again.");
  };
  if (source.mostBytesLeft() < expected) {
    cutOff("at most " + std::to_string(source.mostBytesLeft()));
  }
  constexpr std::size_t kPeekBytes = std::size_t{1} << 20;
  const std::size_t wanted = extent == Extent::Peek ? std::min(expected, kPeekBytes) : expected;
  file.bytes.resize(wanted);
  const std::size_t found = source.read(file.bytes.data(), wanted);
  if (found < wanted) {
    cutOff(std::to_string(found));
  }
  std::uint8_t extra = 0;
  if (extent == Extent::Whole && source.read(&extra, 1) != 0) {
    throw InputError(name + " holds more than the " + std::to_string(expected) +
                     " bytes of voxels its header promises; copy or export it again.");
  }
  if (file.bigEndian) {
    swapBytes(file.bytes, width);
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
