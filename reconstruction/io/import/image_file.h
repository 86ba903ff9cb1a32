#pragma once
// Purpose: one image of a file format of its own (NIfTI, NRRD, MetaImage). Its header, byte count and checksum are verified here;
// then ITK decodes the voxels. World frame LPS mm: the readers turn RAS and LAS round here, once.
// Two tolerances: a file that contradicts itself or ITK about its place by more than 0.1 mm at a corner is refused; labels lie on
// the CT's grid to 0.01 mm (kSameGridMm).

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"
#include "reconstruction/image/structure_kind.h"
#include "reconstruction/io/import/byte_source.h"
#include "reconstruction/io/import/itk_values.h"
#include "reconstruction/io/import/scalar.h"
#include "reconstruction/io/read.h"

namespace glisson::import {

/// Two statements about a file's place that are this close at the corners are one.
inline constexpr double kSamePlaceMm = 0.1;

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
  int layers = 1;  ///< of a .seg.nrrd's list axis; the layers of one voxel lie side by side
  double slope = 1;
  double intercept = 0;
  double ambiguityMm = 0;                 ///< the header leaves open where a corner lies: skewed axes, two forms
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
void setSteps(const std::string& name, const Mat3& steps, ImageFile& file);
/// What is known about ITK's reading of a file.
struct ItkInput {
  ItkFile file;
  bool judgesPlace = true;  ///< false where ITK is known to misread the place
  bool reorders = false;    ///< the layers follow one another in the file; ITK puts them side by side
};
/// Fills file.bytes. Whole: the source, named `name`, is read to its end first and must hold exactly valueCount() finite values;
/// then ITK decodes them, and its header and values must be the same as ours. Peek: the source's first values, by ourselves.
void readValues(const std::string& name, ByteSource& source, const ItkInput& itk, ImageFile& file, Extent extent);
/// A file beside `header` named by it. Throws where the name leaves the folder.
std::filesystem::path besideHeader(const std::filesystem::path& header, const std::string& dataFile);

}  // namespace glisson::import
