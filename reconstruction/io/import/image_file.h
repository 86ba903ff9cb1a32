#pragma once
// Purpose: one image of a file format of its own (NIfTI, NRRD, MetaImage) after its header, byte count and checksum have been
// verified. World frame LPS mm: the readers turn RAS and LAS round here, once.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"
#include "reconstruction/image/structure_kind.h"
#include "reconstruction/io/import/byte_source.h"
#include "reconstruction/io/read.h"

namespace glisson::import {

enum class Scalar : std::uint8_t { U8, I8, U16, I16, U32, I32, U64, I64, F32, F64 };
std::size_t bytesOf(Scalar scalar);

/// A segment of a .seg.nrrd.
struct Segment {
  std::string name;
  std::optional<Rgb> colour;
  std::optional<int> label;  ///< nothing: every non-zero value of the layer
  int layer = 0;
};

struct ImageFile {
  ImageGeometry geometry;
  Scalar scalar = Scalar::U8;
  bool bigEndian = false;
  int layers = 1;             ///< of a .seg.nrrd's list axis
  bool layersFastest = true;  ///< else they are the slowest axis
  double slope = 1;
  double intercept = 0;
  std::vector<std::uint8_t> bytes;        ///< voxels x layers, native byte order
  std::map<int, std::string> labelNames;  ///< embedded in the file
  std::vector<Segment> segments;
  std::vector<std::string> notes;

  [[nodiscard]] std::size_t valueCount() const { return geometry.voxelCount() * static_cast<std::size_t>(layers); }
};

/// Whole: all bytes, verified. Peek: the first MiB of them at most, unverified, for guessing what the file is.
enum class Extent : std::uint8_t { Whole, Peek };

/// True where the name ends as one of the formats read here (.nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd).
bool isImageFileName(const std::filesystem::path& path);
/// The name without folder and without such an ending: "portal_vein.nii.gz" is "portal_vein".
std::string stemOf(const std::filesystem::path& path);
ImageFile readImageFile(const std::filesystem::path& path, const ReadOptions& options, Extent extent = Extent::Whole);

ImageFile readNifti(const std::filesystem::path& path, const ReadOptions& options, Extent extent);
ImageFile readNrrd(const std::filesystem::path& path, const ReadOptions& options, Extent extent);
ImageFile readMetaImage(const std::filesystem::path& path, const ReadOptions& options, Extent extent);

// What the three readers share -------------------------------------------------------------------------------------------------

/// Throws InputError where sizes are below 1 or voxels x layers x bytes pass the budget.
void requireBudget(const std::string& name, const std::array<double, 3>& sizes, double layers, double bytesPerVoxel,
                   const ReadOptions& options);
/// Splits one-voxel steps (columns, mm) into spacing and an orthonormal direction. A skew of at most 0.1 mm at the far corner is
/// snapped (with a note above 0.01 mm), more is refused.
void setSteps(const std::string& name, const Mat3& steps, ImageGeometry& geometry, std::vector<std::string>& notes);
/// Fills file.bytes from the source: exactly valueCount() values and nothing behind them, in native byte order.
void readValues(const std::string& name, ByteSource& source, ImageFile& file, Extent extent);
/// A file beside `header` named by it. Throws where the name leaves the folder.
std::filesystem::path besideHeader(const std::filesystem::path& header, const std::string& dataFile);

}  // namespace glisson::import
