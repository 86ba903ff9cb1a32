#pragma once
// Purpose: small files of every format, written byte by byte here, so that the readers are tested against other code than their
// own.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"

namespace glisson::fixtures {

/// A folder of its own that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The sentence of the refusal; empty where nothing was refused.
template <typename Read>
std::string refusal(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}
std::string refusalOfCt(const std::filesystem::path& path, const ReadOptions& options = {});
ReadOptions accepting(std::set<Consent> consents);

using Bytes = std::vector<std::uint8_t>;
void writeFile(const std::filesystem::path& path, const Bytes& bytes);
Bytes readFile(const std::filesystem::path& path);
Bytes gzip(const Bytes& bytes);
Bytes zlibCompressed(const Bytes& bytes);

/// Values of any type as bytes, little endian or swapped.
template <typename T>
Bytes bytesOf(const std::vector<T>& values, bool bigEndian = false) {
  Bytes bytes;
  for (const T value : values) {
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    for (std::size_t n = 0; n < sizeof(T); ++n) {
      bytes.push_back(raw[bigEndian ? sizeof(T) - 1 - n : n]);
    }
  }
  return bytes;
}

/// A body without any symmetry, by world position (mm LPS) around `centre`: a bar with one arm to the left, one short one up and a
/// knob behind. 1 or 0 per voxel of the grid.
std::vector<std::uint8_t> asymmetricBody(const ImageGeometry& geometry);
/// What is wrong with a segmentation that should hold this body alone, on this grid; empty where nothing is.
std::string faultOfBody(const Segmentation& read, const ImageGeometry& expected);
/// A grid of 9x8x7 voxels with unequal spacing whose axes are permuted and flipped as `code` (0..47) says, then turned by
/// `degrees` about an oblique axis.
ImageGeometry permutedGrid(int code, double degrees);

struct NiftiOptions {
  std::int16_t datatype = 2;
  std::int16_t bitpix = 8;
  bool bigEndian = false;
  bool sform = true;
  bool qform = false;
  double sformShiftMm = 0;  ///< moves the sform away from the qform
  double slope = 0;
  double intercept = 0;
  int timePoints = 1;
  std::string extension;
};
Bytes nifti(const ImageGeometry& geometry, const Bytes& voxels, const NiftiOptions& options = {});

inline constexpr const char* kLps = "left-posterior-superior";

/// `space`: kLps, "right-anterior-superior" or "left-anterior-superior". `extra`: further header lines.
Bytes nrrd(const ImageGeometry& geometry, const Bytes& voxels, const std::string& type, const std::string& space, bool compressed,
           const std::string& extra = "", bool bigEndian = false);
Bytes metaImage(const ImageGeometry& geometry, const Bytes& voxels, const std::string& type, bool compressed);

/// One CT slice, explicit little endian, 16 bits unless `bits` is 8.
struct DicomOptions {
  std::string patientId = "P1";
  std::string seriesUid = "1.2.3.4";
  std::string frameOfReferenceUid = "1.2.3.5";
  std::string imageType = "ORIGINAL\\PRIMARY\\AXIAL";
  int instance = 1;
  int columns = 9;
  int rows = 8;
  Vec3 position = Vec3::Zero();
  Vec3 row = Vec3::UnitX();
  Vec3 column = Vec3::UnitY();
  double columnSpacing = 0.75;
  double rowSpacing = 0.5;
  int bits = 16;
  int bitsStored = 16;
  bool isSigned = true;
  double slope = 1;
  double intercept = 0;
  std::string modality = "CT";
  std::string positionText;  ///< these four stand in the header as they are, where they are not empty
  std::string orientationText;
  std::string pixelSpacingText;
  bool rescaleIntercept = true;  ///< else the element is left out
  std::string slopeText;
  std::string sopClass = "1.2.840.10008.5.1.4.1.1.2";
};
Bytes dicomSlice(const DicomOptions& options, const Bytes& pixels);

/// A folder of slices 2 mm apart whose voxel (i,j,k) holds 100 k + 10 j + i - 500 HU.
void writeCtSeries(const std::filesystem::path& folder, const std::vector<double>& heights, DicomOptions options = {});

}  // namespace glisson::fixtures
