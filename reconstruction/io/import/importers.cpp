#include "reconstruction/io/import/importers.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/dicom_series.h"
#include "reconstruction/io/import/dicom_slice.h"
#include "reconstruction/io/import/values.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
namespace fs = std::filesystem;

std::vector<fs::path> imageFilesIn(const fs::path& folder) {
  std::vector<fs::path> files = filesIn(folder);
  std::erase_if(files, [](const fs::path& file) { return !isImageFileName(file); });
  return files;
}

/// A header with its data file beside it is one image: .raw, .zraw and the like are no image names, so nothing is listed twice.
Segmentation readFolderOfOrgans(const fs::path& folder, std::vector<fs::path> files, const ReadOptions& options,
                                const ExecutionContext& context) {
  Segmentation result;
  result.source = folder.string();
  std::erase_if(files, [&](const fs::path& file) {
    const bool isCt = !kindOfName(stemOf(file), options) && guessKind(file, options) == InputKind::Ct;
    if (isCt) {
      result.notes.push_back("Not read as a mask: " + stemOf(file) + ", a CT beside the masks.");
    }
    return isCt;
  });
  bool first = true;
  std::vector<std::string> names;
  std::ranges::transform(files, std::back_inserter(names), stemOf);
  requireChosen(folder.string(), names, {}, options);
  const bool allOthers =
      std::ranges::all_of(files, [&](const fs::path& file) { return kindOfName(stemOf(file), options) == StructureKind::Other; });
  for (std::size_t n = 0; n < files.size(); ++n) {
    context.report(static_cast<double>(n) / static_cast<double>(files.size()), stemOf(files[n]));
    LabelledMask structure;
    structure.name = stemOf(files[n]);
    structure.label = 1;
    structure.kind = kindOfName(structure.name, options);
    if (structure.kind != StructureKind::Other || (allOthers && n == 0)) {
      ImageFile file = readImageFile(files[n], options);
      for (const std::string& note : file.notes) {
        result.notes.push_back(structure.name + ": " + note);
      }
      if (first) {
        first = false;
        result.geometry = file.geometry;
      } else if (!(result.geometry.cornerDistance(file.geometry) <= kSameGridMm)) {
        throw InputError(folder.string() + " holds masks on different grids: " + files[n].filename().string() + " has " +
                         file.geometry.describe() + " and the others have " + result.geometry.describe() +
                         "; give masks of one CT.");
      }
      structure.mask = std::make_shared<const Mask>(toOneMask(files[n], std::move(file)));
    }
    result.structures.push_back(std::move(structure));
  }
  checkLabels(folder.string(), result);
  return result;
}

bool holdsDicom(const fs::path& folder) {
  const std::vector<fs::path> files = filesIn(folder);
  return std::ranges::any_of(files, hasDicomMagic);
}

std::vector<fs::path> dicomFoldersIn(const fs::path& folder) {
  std::vector<fs::path> folders = foldersIn(folder);
  std::erase_if(folders, [](const fs::path& inner) { return !holdsDicom(inner); });
  return folders;
}
}  // namespace

CtVolume importCt(const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  if (fs::is_directory(path) || !isImageFileName(path)) {
    if (!fs::is_directory(path) && !hasDicomMagic(path)) {
      throw InputError(path.string() +
                       " is of no known format; give a DICOM folder, .nii, .nii.gz, .nrrd, .seg.nrrd, .mha or .mhd file.");
    }
    return readDicomCt(path, options, context);
  }
  ImageFile file = readImageFile(path, options);
  context.report(0.5, "voxels");
  return toCt(path, std::move(file));
}

Segmentation importSegmentation(const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  if (fs::is_directory(path)) {
    if (const auto files = imageFilesIn(path); !files.empty()) {
      return readFolderOfOrgans(path, files, options, context);
    }
    if (const auto folders = dicomFoldersIn(path); !folders.empty()) {
      return readDicomMasks(path, folders, options, context);
    }
    if (holdsDicom(path)) {
      return readDicomMasks(path, {path}, options, context);
    }
    throw InputError(path.string() + " holds neither mask series nor organ files; choose the folder that holds the masks.");
  }
  if (!isImageFileName(path) && hasDicomMagic(path)) {
    throw InputError(path.string() +
                     " is a single DICOM file, which is not read as a segmentation; give a folder of mask series, or " +
                     "save the segmentation as .seg.nrrd or .nii.gz.");
  }
  ImageFile file = readImageFile(path, options);
  context.report(0.5, "voxels");
  return toSegmentation(path, std::move(file), options);
}

namespace {
/// From the type and the values: labels are small and never negative. Nothing where all that was read is zero: it may be padding.
std::optional<InputKind> guessFromValues(const ImageFile& file) {
  if (file.layers > 1 || !file.segments.empty() || !file.labelNames.empty() || bytesOf(file.scalar) == 1) {
    return InputKind::Segmentation;
  }
  return withType(file.scalar, [&](auto type) -> std::optional<InputKind> {
    using T = decltype(type);
    double low = 0;
    double high = 0;
    for (std::size_t n = 0; n < file.bytes.size() / sizeof(T); ++n) {
      const double value = static_cast<double>(valueAt<T>(file.bytes, n)) * file.slope + file.intercept;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (low == 0 && high == 0) {
      return std::nullopt;
    }
    return low < 0 || high > 255 ? InputKind::Ct : InputKind::Segmentation;
  });
}

InputKind guessFolder(const fs::path& folder, int depth) {
  const auto isOrgan = [](const fs::path& file) { return recogniseKind(stemOf(file)).has_value(); };
  if (std::ranges::any_of(imageFilesIn(folder), isOrgan)) {
    return InputKind::Segmentation;
  }
  if (holdsDicom(folder)) {
    return recogniseKind(folder.filename().string()) ? InputKind::Segmentation : InputKind::Ct;
  }
  const std::vector<fs::path> inner = foldersIn(folder);
  if (std::ranges::any_of(inner, [&](const fs::path& sub) { return isOrgan(sub) && holdsDicom(sub); })) {
    return InputKind::Segmentation;
  }
  const bool holdsCt =
      depth > 0 && std::ranges::any_of(inner, [&](const fs::path& sub) { return guessFolder(sub, depth - 1) == InputKind::Ct; });
  return holdsCt ? InputKind::Ct : InputKind::Unknown;
}
}  // namespace

InputKind guessKind(const fs::path& path, const ReadOptions& options) {
  if (fs::is_directory(path)) {
    return guessFolder(path, kFolderDepth);
  }
  if (isImageFileName(path)) {
    if (toLower(path.filename().string()).ends_with(".seg.nrrd") || recogniseKind(stemOf(path))) {
      return InputKind::Segmentation;
    }
    ReadOptions peek = options;
    peek.niftiFrame = NiftiFrame::SForm;  // where it lies says nothing about what it is: the reader asks
    if (const std::optional<InputKind> kind = guessFromValues(readImageFile(path, peek, Extent::Peek))) {
      return *kind;
    }
    return guessFromValues(readImageFile(path, peek)).value_or(InputKind::Segmentation);
  }
  std::string why;
  if (hasDicomMagic(path)) {
    const auto slice = readDicomSlice(path, why);
    return slice && slice->modality == "CT" ? InputKind::Ct : InputKind::Unknown;
  }
  return InputKind::Unknown;
}

}  // namespace glisson::import
