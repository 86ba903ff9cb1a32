#pragma once
// Purpose: the sample patient's image files. The same input gives the same bytes: no dates, no names of machines.
// Frame: geometry is LPS mm; NIfTI's RAS exists only inside the file. Throws Error where a file cannot be written.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/segmentation.h"

namespace glisson::sample {

/// NIfTI-1 with equal sform and qform (code 1, scanner). `direction` must be the identity.
void writeNifti(const std::filesystem::path& file, const ImageGeometry& geometry, std::span<const std::int16_t> values);
void writeNifti(const std::filesystem::path& file, const ImageGeometry& geometry, std::span<const std::uint8_t> values);

/// A 3D Slicer segmentation: as few layers as keep overlapping structures apart, names, colours, label values.
void writeSegNrrd(const std::filesystem::path& file, const Segmentation& segmentation);

/// One label per voxel; where structures overlap, the later in the list wins. Labels as in the structures.
std::vector<std::uint8_t> exclusiveLabels(const Segmentation& segmentation);

/// One CT Image Storage file a slice, Explicit VR Little Endian, IM0001.dcm ... with fixed UIDs made from `seriesNumber`.
/// Cancel is polled between slices.
void writeDicomSeries(const std::filesystem::path& folder, const CtVolume& ct, int seriesNumber, const ExecutionContext& context);

}  // namespace glisson::sample
