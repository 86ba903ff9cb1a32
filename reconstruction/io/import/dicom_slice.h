#pragma once
// Purpose: one DICOM image file: what its header says about grid, place, patient and coding. Lengths mm, frame LPS (DICOM's own).

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/ct_volume.h"

class DcmFileFormat;

namespace glisson::import {

struct DicomSlice {
  std::filesystem::path path;
  std::shared_ptr<DcmFileFormat> file;  ///< its pixels are still on disk

  PatientIdentity identity;
  std::string seriesUid;
  std::string modality;
  bool localizer = false;
  long instanceNumber = 0;

  int rows = 0;
  int columns = 0;
  Vec3 position = Vec3::Zero();  ///< centre of the first pixel
  Vec3 rowDirection = Vec3::UnitX();
  Vec3 columnDirection = Vec3::UnitY();
  double columnSpacing = 1;  ///< mm between columns, along rowDirection
  double rowSpacing = 1;     ///< mm between rows, along columnDirection
  bool placed = true;        ///< position, orientation and pixel spacing are all there and finite
  std::string flaw;          ///< where they are not: what is missing or broken, to follow the file's name

  int bitsAllocated = 16;
  int bitsStored = 16;
  int highBit = 15;
  bool isSigned = false;
  double slope = 1;
  double intercept = 0;
  int rescaleValues = 0;  ///< how many of slope and intercept the header has
  int frames = 1;
  int samples = 1;
  std::string photometric;

  [[nodiscard]] Vec3 normal() const { return rowDirection.cross(columnDirection).normalized(); }
  [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
};

/// Nothing where the file is no DICOM, or a DICOM object without an image (a directory, a report); `why` says which.
/// Throws InputError where it is a DICOM image but damaged.
std::optional<DicomSlice> readDicomSlice(const std::filesystem::path& path, std::string& why);

/// All DICOM images among the files, in the files' order; the others are named in the notes. Several threads.
std::vector<DicomSlice> readDicomSlices(const std::vector<std::filesystem::path>& files, std::vector<std::string>& notes,
                                        const ExecutionContext& context);

/// Begins with DICOM's preamble and "DICM".
bool hasDicomMagic(const std::filesystem::path& path);
/// The regular files of a folder, sorted by name; hidden ones left out.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);
/// How far down a folder is searched.
inline constexpr int kFolderDepth = 6;
std::vector<std::filesystem::path> foldersIn(const std::filesystem::path& folder);

}  // namespace glisson::import
