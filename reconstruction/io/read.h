#pragma once
// Purpose: reading CT and segmentations from files of others. Parsing happens in the child process glisson-import (limits on time
// and memory); a decoder that aborts costs one InputError, never the program. Nothing is ever written beside the input.
// Frame: everything returned is LPS mm with non-zero extents folded into the origin.

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/segmentation.h"

namespace glisson {

/// Choices a person would make in the window; without them a doubtful input is refused with a sentence that names the flag.
enum class Consent : std::uint8_t {
  ResampleLabels,  ///< resample-labels: labels off the CT's grid are resampled (nearest)
  Tilt,            ///< tilt: gantry tilt is straightened by resampling
  UnevenSlices,    ///< uneven-slices: missing or uneven slices are resampled
  OtherPatient,    ///< other-patient: differing patient ids or frames of reference
};

enum class NiftiFrame : std::uint8_t { Agreeing, SForm, QForm };  ///< Agreeing: refuse where sform and qform differ

struct ReadOptions {
  std::set<Consent> consents;
  NiftiFrame niftiFrame = NiftiFrame::Agreeing;
  /// Kinds by label value (--labels 5=liver,64=portal_vein) or by name; they win over recognised names.
  std::map<int, StructureKind> kindByLabel;
  std::map<std::string, StructureKind> kindByName;
  /// A named table of label numbers: "totalsegmentator" (v2), "totalsegmentator-v1", "totalsegmentator-mr"; empty for none.
  std::string labelTable;
  std::uint64_t budgetBytes = 4ULL << 30;  ///< header voxels x bytes above this is refused before allocation
  int timeLimitSeconds = 300;
};

/// Parses "totalsegmentator" or "N=KIND,NAME=KIND,..." into the options. Throws UsageError.
void parseLabels(const std::string& text, ReadOptions& options);
/// Parses "resample-labels,tilt,..." Throws UsageError.
void parseConsents(const std::string& text, ReadOptions& options);

/// A DICOM folder (or one file of it), NIfTI, NRRD or MetaImage. Throws InputError, Cancelled (polled every 50 ms; the child is
/// killed).
CtVolume readCt(const std::filesystem::path& path, const ReadOptions& options = {}, const ExecutionContext& context = {});

/// A label map (NIfTI, NRRD, .seg.nrrd, MetaImage), a folder of DICOM mask series, or a folder of one-organ files.
/// Kinds are recognised by name; where none is known `kind` stays empty. An empty label is a note; a file without any label throws.
Segmentation readSegmentation(const std::filesystem::path& path, const ReadOptions& options = {},
                              const ExecutionContext& context = {});

/// Checks that the labels belong to the CT (reliability.md: other patient, 8 corners to 0.01 mm) and returns them on the CT's grid:
/// the same object where the grids agree, else resampled (nearest) with Consent::ResampleLabels, else InputError naming both
/// geometries.
Segmentation matchToCt(Segmentation segmentation, const CtVolume& ct, const ReadOptions& options = {});

/// What a path seems to hold, found without decoding pixels: for the window's open dialog, drag and drop, and `info`.
enum class InputKind : std::uint8_t { Ct, Segmentation, Case, Unknown };
/// Throws Cancelled.
InputKind guessInput(const std::filesystem::path& path, const ExecutionContext& context = {});

}  // namespace glisson
