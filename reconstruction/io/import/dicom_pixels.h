#pragma once
// Purpose: the pixels of one DICOM slice: byte counts verified, decoded (uncompressed, RLE, JPEG, JPEG-LS by DCMTK; JPEG 2000 by
// OpenJPEG), rescaled per slice. Rows x columns, columns fastest.

#include <cstdint>
#include <span>

#include "reconstruction/io/import/dicom_slice.h"

namespace glisson::import {

/// Registers DCMTK's decoders while it lives. One in main().
class DicomDecoders {
 public:
  DicomDecoders();
  ~DicomDecoders();
  DicomDecoders(const DicomDecoders&) = delete;
  DicomDecoders& operator=(const DicomDecoders&) = delete;
};

/// Writes slice.pixels() Hounsfield values and frees the file's memory. Returns how many were cut to 16 bits. Throws InputError
/// where the pixels are damaged, cut off or of a kind that is not read.
std::size_t decodeHounsfield(DicomSlice& slice, std::span<std::int16_t> out);

/// The part of a mask slice that holds its non-zero pixels.
struct MaskSlice {
  int firstColumn = 0;
  int firstRow = 0;
  int columns = 0;  ///< 0: nothing set
  int rows = 0;
  std::vector<std::uint8_t> values;
};
MaskSlice decodeMask(DicomSlice& slice);

}  // namespace glisson::import
