#pragma once
// Purpose: a DICOM series put in order: slices sorted by position along the normal (never by name or number), the grid they form,
// and what is wrong with it: tilt, missing, duplicate or uneven slices. Lengths mm, LPS.

#include <set>
#include <string>
#include <vector>

#include "reconstruction/io/import/dicom_slice.h"
#include "reconstruction/io/read.h"

namespace glisson::import {

struct SliceStack {
  std::vector<DicomSlice> slices;  ///< ascending along the normal
  ImageGeometry geometry;          ///< the regular grid, upright; after resampling where `resample`
  bool resample = false;           ///< the slices do not lie on the grid: straighten with resampleSlices
  std::vector<double> distance;    ///< of each slice along the normal from the first
  std::vector<Vec3> shift;         ///< index of each slice's first pixel in the grid's plane (x, y); z unused
  std::vector<std::string> notes;  ///< corrections made with consent
};

/// The largest image series of a folder; smaller ones and localizers are named in `notes`. Throws InputError where there is none;
/// where a slice of the series has no place, another size or another direction (by its file's name); where a second series could be
/// the one as well or is of another patient.
/// `preferred`: the series of this file instead of the largest, where it is not empty.
std::vector<DicomSlice> chooseSeries(const std::string& name, std::vector<DicomSlice>&& slices,
                                     const std::filesystem::path& preferred, std::vector<std::string>& notes);

/// Throws InputError naming the slices and the flag where the series is tilted or uneven and consent is not given; where it is not
/// a volume or a time series.
SliceStack stackSlices(const std::string& name, std::vector<DicomSlice>&& slices, const std::set<Consent>& consents);

/// For each slice of the stack its pixels -> values on stack.geometry. `nearest` for masks, else linear; outside: `fill`.
std::vector<std::int16_t> resampleSlices(const SliceStack& stack, const std::vector<std::vector<std::int16_t>>& pixels,
                                         bool nearest, std::int16_t fill);

}  // namespace glisson::import
