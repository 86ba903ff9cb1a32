#include "reconstruction/io/import/dicom_series.h"

#include <algorithm>
#include <atomic>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/dicom_pixels.h"
#include "reconstruction/io/import/slice_stack.h"
#include "reconstruction/io/import/values.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
namespace fs = std::filesystem;

void collectFiles(const fs::path& folder, int depth, std::vector<fs::path>& files) {
  const std::vector<fs::path> own = filesIn(folder);
  files.insert(files.end(), own.begin(), own.end());
  if (depth > 0) {
    for (const fs::path& inner : foldersIn(folder)) {
      collectFiles(inner, depth - 1, files);
    }
  }
}

/// The slices of a CT: the folder's own files, else those of the folders in it (a whole study).
std::vector<DicomSlice> findSlices(const fs::path& path, std::vector<std::string>& notes, const ExecutionContext& context) {
  const fs::path folder = fs::is_directory(path) ? path : (path.has_parent_path() ? path.parent_path() : fs::path("."));
  std::vector<DicomSlice> slices = readDicomSlices(filesIn(folder), notes, context);
  if (slices.empty() && fs::is_directory(path)) {
    for (const fs::path& inner : foldersIn(folder)) {
      if (recogniseKind(inner.filename().string())) {
        throw InputError(path.string() + " holds mask series such as " + inner.filename().string() +
                         " and no CT; open it as a segmentation.");
      }
    }
    std::vector<fs::path> files;
    collectFiles(folder, kFolderDepth, files);
    slices = readDicomSlices(files, notes, context);
  }
  return slices;
}

void requireOnePatient(const std::string& name, const std::vector<DicomSlice>& slices) {
  const PatientIdentity& first = slices.front().identity;
  for (const DicomSlice& slice : slices) {
    const bool otherId = slice.identity.patientId != first.patientId;
    if (otherId || slice.identity.frameOfReferenceUid != first.frameOfReferenceUid) {
      throw InputError(name + " mixes slices of different " + (otherId ? "patients" : "frames of reference") + " (the " +
                       (otherId ? "PatientID" : "FrameOfReferenceUID") + " of " + slices.front().path.filename().string() +
                       " and " + slice.path.filename().string() + " differ); give the folder of one series.");
    }
  }
}

/// The slices of one patient, in order, on a grid within the budget.
SliceStack checkedStack(const std::string& name, std::vector<DicomSlice>&& slices, const ReadOptions& options) {
  requireOnePatient(name, slices);
  SliceStack stack = stackSlices(name, std::move(slices), options.consents);
  const Index3& size = stack.geometry.size;
  requireBudget(name, {1.0 * size[0], 1.0 * size[1], 1.0 * size[2]}, 1, stack.resample ? 4 : 2, options);
  stack.geometry.validate(name);
  return stack;
}

/// A slope of its own in each slice is obeyed, as reliability asks; but no CT scanner writes one slice at twice the scale of the
/// others or upside down: that header is broken and its Hounsfield units are not what they say.
void requireOneScale(const std::vector<DicomSlice>& slices, std::vector<std::string>& notes) {
  constexpr double kMostFactor = 2;
  std::vector<double> slopes(slices.size());
  std::ranges::transform(slices, slopes.begin(), &DicomSlice::slope);
  std::ranges::sort(slopes);
  const double usual = slopes[slopes.size() / 2];
  const int complete = std::ranges::max(slices, {}, &DicomSlice::rescaleValues).rescaleValues;
  for (const DicomSlice& slice : slices) {
    if (slice.rescaleValues < complete) {
      throw InputError(slice.path.string() + " lacks a rescale slope or intercept that its series has, so its Hounsfield units " +
                       "would be wrong; copy or export the series again.");
    }
    const double factor = slice.slope / usual;
    if (!(factor >= 1 / kMostFactor && factor <= kMostFactor)) {
      throw InputError(slice.path.string() + " has a rescale slope of " + formatExact(slice.slope) + " where its series has " +
                       formatExact(usual) + ", so its Hounsfield units would be wrong; copy or export the series again.");
    }
  }
  if (slopes.front() != slopes.back()) {
    notes.push_back("The slices have rescale slopes of their own, from " + formatExact(slopes.front()) + " to " +
                    formatExact(slopes.back()) + ".");
  }
}

/// Each slice's Hounsfield values, decoded on several threads to where `target` says.
std::size_t decodeAll(SliceStack& stack, const std::function<std::span<std::int16_t>(std::size_t)>& target,
                      const ExecutionContext& context) {
  std::atomic<std::size_t> clamped{0};
  std::atomic<std::size_t> done{0};
  parallelFor(stack.slices.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      clamped += decodeHounsfield(stack.slices[n], target(n));
    }
    context.report(static_cast<double>(done += end - begin) / static_cast<double>(stack.slices.size()), "slices");
  });
  return clamped;
}
}  // namespace

CtVolume readDicomCt(const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  const std::string name = path.string();
  CtVolume ct;
  ct.source = name;
  std::vector<DicomSlice> found = findSlices(path, ct.notes, context.range(0, 0.4));
  std::vector<DicomSlice> chosen = chooseSeries(name, std::move(found), fs::is_directory(path) ? fs::path() : path, ct.notes);
  if (const std::string& modality = chosen.front().modality; !modality.empty() && modality != "CT") {
    throw InputError(name + " is a series of modality " + modality + ", not CT; choose the CT series.");
  }
  requireOneScale(chosen, ct.notes);
  SliceStack stack = checkedStack(name, std::move(chosen), options);
  ct.geometry = stack.geometry;
  ct.identity = stack.slices.front().identity;
  ct.notes.insert(ct.notes.end(), stack.notes.begin(), stack.notes.end());
  const std::size_t pixels = stack.slices.front().pixels();
  std::size_t clamped = 0;
  if (!stack.resample) {
    ct.hounsfield.resize(ct.geometry.voxelCount());
    clamped = decodeAll(
        stack, [&](std::size_t n) { return std::span(ct.hounsfield).subspan(n * pixels, pixels); }, context.range(0.4, 1));
  } else {
    std::vector<std::vector<std::int16_t>> slices(stack.slices.size(), std::vector<std::int16_t>(pixels));
    clamped = decodeAll(
        stack, [&](std::size_t n) { return std::span(slices[n]); }, context.range(0.4, 1));
    constexpr std::int16_t kAir = -1000;
    ct.hounsfield = resampleSlices(stack, slices, false, kAir);
  }
  checkHounsfield(name, ct, clamped);
  return ct;
}

namespace {
/// Puts the slices' boxes together.
Mask assemble(const std::vector<MaskSlice>& slices) {
  Index3 low{1 << 30, 1 << 30, 1 << 30};
  Index3 high{-1, -1, -1};
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const MaskSlice& slice = slices[k];
    if (slice.columns > 0) {
      low = {std::min(low[0], slice.firstColumn), std::min(low[1], slice.firstRow), std::min(low[2], static_cast<int>(k))};
      high = {std::max(high[0], slice.firstColumn + slice.columns - 1), std::max(high[1], slice.firstRow + slice.rows - 1),
              static_cast<int>(k)};
    }
  }
  if (high[0] < 0) {
    return {};
  }
  const IndexBox box{low, {high[0] - low[0] + 1, high[1] - low[1] + 1, high[2] - low[2] + 1}};
  std::vector<std::uint8_t> values(box.voxelCount(), 0);
  for (std::size_t k = static_cast<std::size_t>(low[2]); k <= static_cast<std::size_t>(high[2]); ++k) {
    const MaskSlice& slice = slices[k];
    for (int row = 0; row < slice.rows; ++row) {
      const auto from = slice.values.begin() + static_cast<std::ptrdiff_t>(row) * slice.columns;
      const auto line = static_cast<std::size_t>(slice.firstRow + row - low[1]) +
                        static_cast<std::size_t>(box.size[1]) * (k - static_cast<std::size_t>(low[2]));
      std::copy_n(from, slice.columns,
                  values.begin() + static_cast<std::ptrdiff_t>(line * static_cast<std::size_t>(box.size[0])) +
                      (slice.firstColumn - low[0]));
    }
  }
  return {box, values};
}

Mask resampledMask(const SliceStack& stack, const std::vector<MaskSlice>& masks) {
  std::vector<std::vector<std::int16_t>> pixels;
  const DicomSlice& first = stack.slices.front();
  for (const MaskSlice& mask : masks) {
    std::vector<std::int16_t> slice(first.pixels(), 0);
    for (int row = 0; row < mask.rows; ++row) {
      std::copy_n(mask.values.begin() + static_cast<std::ptrdiff_t>(row) * mask.columns, mask.columns,
                  slice.begin() + static_cast<std::ptrdiff_t>(mask.firstRow + row) * first.columns + mask.firstColumn);
    }
    pixels.push_back(std::move(slice));
  }
  const std::vector<std::int16_t> values = resampleSlices(stack, pixels, true, 0);
  const std::vector<std::uint8_t> bytes(values.begin(), values.end());
  return Mask::fromGrid(stack.geometry.size, bytes);
}

struct MaskSeries {
  Mask mask;
  ImageGeometry geometry;
  PatientIdentity identity;
  std::vector<std::string> notes;
};

MaskSeries readMaskSeries(const fs::path& folder, const ReadOptions& options, const ExecutionContext& context) {
  const std::string name = folder.string();
  MaskSeries result;
  std::vector<DicomSlice> chosen =
      chooseSeries(name, readDicomSlices(filesIn(folder), result.notes, context.range(0, 0.5)), {}, result.notes);
  SliceStack stack = checkedStack(name, std::move(chosen), options);
  result.geometry = stack.geometry;
  result.identity = stack.slices.front().identity;
  result.notes.insert(result.notes.end(), stack.notes.begin(), stack.notes.end());
  std::vector<MaskSlice> masks(stack.slices.size());
  parallelFor(masks.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      masks[n] = decodeMask(stack.slices[n]);
    }
  });
  context.report(1, folder.filename().string());
  result.mask = stack.resample ? resampledMask(stack, masks) : assemble(masks);
  return result;
}

/// All masks lie on one grid and belong to one patient.
void join(const std::string& name, const fs::path& folder, MaskSeries& series, const ReadOptions& options, Segmentation& result,
          bool& first) {
  for (const std::string& note : series.notes) {
    result.notes.push_back(folder.filename().string() + ": " + note);
  }
  if (first) {
    first = false;
    result.geometry = series.geometry;
    result.patientId = series.identity.patientId;
    result.frameOfReferenceUid = series.identity.frameOfReferenceUid;
    return;
  }
  if (!(result.geometry.cornerDistance(series.geometry) <= kSameGridMm)) {
    throw InputError(name + " holds masks on different grids: " + folder.filename().string() + " has " +
                     series.geometry.describe() + " and the others have " + result.geometry.describe() + "; give masks of one CT.");
  }
  const auto differ = [](const std::string& a, const std::string& b) { return !a.empty() && !b.empty() && a != b; };
  const bool otherId = differ(result.patientId, series.identity.patientId);
  if ((otherId || differ(result.frameOfReferenceUid, series.identity.frameOfReferenceUid)) &&
      !options.consents.contains(Consent::OtherPatient)) {
    throw InputError(name + " holds masks of different " + (otherId ? "patients" : "frames of reference") + " (the " +
                     (otherId ? "PatientID" : "FrameOfReferenceUID") + " of " + folder.filename().string() +
                     " differs); check the folder, or accept it with --accept other-patient.");
  }
}
}  // namespace

Segmentation readDicomMasks(const fs::path& path, const std::vector<fs::path>& folders, const ReadOptions& options,
                            const ExecutionContext& context) {
  Segmentation result;
  result.source = path.string();
  bool first = true;
  std::vector<std::size_t> wanted;
  for (const fs::path& folder : folders) {
    LabelledMask structure;
    structure.name = folder.filename().string();
    structure.label = 1;
    structure.kind = kindOfName(structure.name, options);
    result.structures.push_back(std::move(structure));
  }
  requireChosen(path.string(), namesOf(result), {}, options);
  // Everything else may be left unread, but one series has to tell the grid.
  for (std::size_t n = 0; n < folders.size(); ++n) {
    if (result.structures[n].kind != StructureKind::Other) {
      wanted.push_back(n);
    }
  }
  if (wanted.empty() && !folders.empty()) {
    wanted.push_back(0);
  }
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    const fs::path& folder = folders[wanted[n]];
    const double from = static_cast<double>(n) / static_cast<double>(wanted.size());
    const double to = static_cast<double>(n + 1) / static_cast<double>(wanted.size());
    MaskSeries series = readMaskSeries(folder, options, context.range(from, to));
    join(path.string(), folder, series, options, result, first);
    result.structures[wanted[n]].mask = std::make_shared<const Mask>(std::move(series.mask));
  }
  checkLabels(path.string(), result);
  return result;
}

}  // namespace glisson::import
