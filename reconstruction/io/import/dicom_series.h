#pragma once
// Purpose: a CT, or a folder of mask series, from DICOM files. Frame LPS mm. Throws InputError.

#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/segmentation.h"
#include "reconstruction/io/read.h"

namespace glisson::import {

/// `path`: a folder (searched deeper where it holds no image itself), or one file of a series.
CtVolume readDicomCt(const std::filesystem::path& path, const ReadOptions& options, const ExecutionContext& context);

/// Each of `folders` is one mask series named after its folder. Series recognised as other organs are listed without being read.
Segmentation readDicomMasks(const std::filesystem::path& path, const std::vector<std::filesystem::path>& folders,
                            const ReadOptions& options, const ExecutionContext& context);

}  // namespace glisson::import
