#include "reconstruction/io/import/dicom_pixels.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/jpeg2000.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr std::size_t kMostMaskValues = 8;

[[noreturn]] void refuse(const DicomSlice& slice, const std::string& fact) {
  throw InputError(slice.path.string() + " " + fact + "; copy or export the series again.");
}

void requireReadable(const DicomSlice& slice) {
  if (slice.samples != 1 || slice.photometric != "MONOCHROME2") {
    refuse(slice, "holds colours or inverted grey (" + slice.photometric + ") instead of plain grey values");
  }
  if (slice.frames != 1) {
    throw InputError(slice.path.string() + " holds " + std::to_string(slice.frames) +
                     " frames in one file, which is not read; export the series as one file per slice.");
  }
  const bool width = slice.bitsAllocated == 8 || slice.bitsAllocated == 16 || slice.bitsAllocated == 32;
  if (!width || slice.bitsStored < 1 || slice.bitsStored > slice.bitsAllocated || slice.highBit < slice.bitsStored - 1 ||
      slice.highBit >= slice.bitsAllocated) {
    refuse(slice, "has an impossible number of bits per pixel in its header");
  }
}

/// Pixels in native byte order, slice.bitsAllocated / 8 bytes each; `held` owns them where DCMTK does not.
struct RawPixels {
  const std::uint8_t* data = nullptr;
  std::vector<std::uint8_t> held;
};

/// The frame of an encapsulated image, its fragments joined. An end-of-image marker must be there: decoders fill what is missing.
std::vector<std::uint8_t> joinedFrame(const DicomSlice& slice, DcmPixelData& pixels, const E_TransferSyntax syntax) {
  DcmPixelSequence* sequence = nullptr;
  if (pixels.getEncapsulatedRepresentation(syntax, nullptr, sequence).bad() || sequence == nullptr || sequence->card() < 2) {
    refuse(slice, "is cut off: it holds no compressed frame");
  }
  std::vector<std::uint8_t> frame;
  for (unsigned long n = 1; n < sequence->card(); ++n) {
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    if (sequence->getItem(item, n).bad() || item == nullptr || item->getUint8Array(bytes).bad() || bytes == nullptr) {
      refuse(slice, "is cut off within its compressed frame");
    }
    frame.insert(frame.end(), bytes, bytes + item->getLength());
  }
  return frame;
}

void requireEndOfImage(const DicomSlice& slice, const std::vector<std::uint8_t>& frame) {
  std::size_t end = frame.size();
  while (end > 0 && frame[end - 1] == 0) {
    --end;
  }
  if (end < 2 || frame[end - 2] != 0xFF || frame[end - 1] != 0xD9) {
    refuse(slice, "is cut off: its compressed frame has no end");
  }
}

RawPixels jpeg2000Pixels(const DicomSlice& slice, DcmPixelData& pixels, E_TransferSyntax syntax) {
  const std::vector<std::uint8_t> frame = joinedFrame(slice, pixels, syntax);
  requireEndOfImage(slice, frame);
  const std::vector<std::int32_t> values = decodeJpeg2000(slice.path.string(), frame, slice.columns, slice.rows);
  const auto width = static_cast<std::size_t>(slice.bitsAllocated) / 8;
  RawPixels raw;
  raw.held.resize(values.size() * width);
  for (std::size_t n = 0; n < values.size(); ++n) {
    std::memcpy(&raw.held[n * width], &values[n], width);  // the low bytes: little endian
  }
  raw.data = raw.held.data();
  return raw;
}

RawPixels plainPixels(const DicomSlice& slice, DcmDataset& data) {
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr) {
    refuse(slice, "is cut off: it holds no pixels");
  }
  const std::size_t width = static_cast<std::size_t>(slice.bitsAllocated) / 8;
  const std::size_t expected = slice.pixels() * width;
  const std::size_t length = element->getLength();
  if (length != expected + (expected & 1U)) {
    refuse(slice, "holds " + std::to_string(length) + " bytes of pixels instead of " + std::to_string(expected));
  }
  const bool bigEndian = data.getOriginalXfer() == EXS_BigEndianExplicit;
  if (bigEndian && (width == 4 || (width == 2 && element->getVR() != EVR_OW))) {
    refuse(slice, "stores big-endian pixels in a way that is not read");
  }
  Uint8* bytes = nullptr;  // little endian whatever the file's order and VR: DCMTK swaps 16-bit words
  if (element->getUint8Array(bytes).bad() || bytes == nullptr) {
    refuse(slice, "is cut off within its pixels");
  }
  return {bytes, {}};
}

RawPixels rawPixels(const DicomSlice& slice) {
  requireReadable(slice);
  DcmDataset& data = *slice.file->getDataset();
  const DcmXfer syntax(data.getOriginalXfer());
  if (!syntax.isEncapsulated()) {
    return plainPixels(slice, data);
  }
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr) {
    refuse(slice, "is cut off: it holds no pixels");
  }
  auto* pixels = dynamic_cast<DcmPixelData*>(element);
  if (pixels == nullptr) {
    refuse(slice, "holds pixels of an unknown kind");
  }
  if (syntax.getXfer() == EXS_JPEG2000LosslessOnly || syntax.getXfer() == EXS_JPEG2000) {
    return jpeg2000Pixels(slice, *pixels, syntax.getXfer());
  }
  if (syntax.getXfer() != EXS_RLELossless) {
    requireEndOfImage(slice, joinedFrame(slice, *pixels, syntax.getXfer()));
  }
  if (data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad() || !data.canWriteXfer(EXS_LittleEndianExplicit)) {
    refuse(slice, std::string("is damaged, or compressed in a way that is not read (") + syntax.getXferName() + ")");
  }
  return plainPixels(slice, data);
}

/// The stored value of a pixel: the bits below highBit, with its sign.
template <typename Pattern>
std::int64_t storedValue(Pattern pattern, const DicomSlice& slice) {
  std::uint64_t bits = static_cast<std::uint64_t>(pattern) >> (slice.highBit + 1 - slice.bitsStored);
  const std::uint64_t mask = (std::uint64_t{1} << slice.bitsStored) - 1;
  bits &= mask;
  if (slice.isSigned && (bits >> (slice.bitsStored - 1)) != 0) {
    return static_cast<std::int64_t>(bits | ~mask);
  }
  return static_cast<std::int64_t>(bits);
}

/// Values beyond 16 bits are cut to them where they are metal or a scanner's padding: few, or all the same one.
void requireHounsfield(const DicomSlice& slice, double farthest, std::size_t beyond, std::size_t pixels) {
  constexpr double kBeyondAnyScannerHu = 1e5;
  if (farthest > kBeyondAnyScannerHu || beyond * 100 > pixels) {
    refuse(slice, "holds no Hounsfield units: with its rescale slope of " + formatExact(slice.slope) + " and intercept of " +
                      formatExact(slice.intercept) + " its values leave -32768..32767");
  }
}

template <typename Pattern>
std::size_t toHounsfield(const DicomSlice& slice, const std::uint8_t* data, std::span<std::int16_t> out) {
  constexpr double kLow = std::numeric_limits<std::int16_t>::min();
  constexpr double kHigh = std::numeric_limits<std::int16_t>::max();
  std::size_t clamped = 0;
  std::size_t beyond = 0;  // without those that equal the first, which may be padding
  double padding = 0;
  double farthest = 0;
  for (std::size_t n = 0; n < out.size(); ++n) {
    Pattern pattern{};
    std::memcpy(&pattern, data + n * sizeof(Pattern), sizeof(Pattern));
    const double value = std::round(static_cast<double>(storedValue(pattern, slice)) * slice.slope + slice.intercept);
    if (!std::isfinite(value)) {
      refuse(slice, "has pixels that are not finite after rescaling");
    }
    if (value < kLow || value > kHigh) {
      padding = clamped == 0 ? value : padding;
      beyond += value != padding ? 1 : 0;
      farthest = std::max(farthest, std::abs(value));
      ++clamped;
    }
    out[n] = static_cast<std::int16_t>(std::clamp(value, kLow, kHigh));
  }
  requireHounsfield(slice, farthest, beyond, out.size());
  return clamped;
}

/// Whether all bits of a row that count are zero, eight bytes at a time.
bool allZero(const std::uint8_t* data, std::size_t size) {
  std::size_t n = 0;
  for (; n + 8 <= size; n += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, data + n, 8);
    if (word != 0) {
      return false;
    }
  }
  return std::all_of(data + n, data + size, [](std::uint8_t byte) { return byte == 0; });
}

template <typename Pattern>
MaskSlice toMask(const DicomSlice& slice, const std::uint8_t* data) {
  const auto columns = static_cast<std::size_t>(slice.columns);
  int low = slice.columns;
  int high = -1;
  int top = -1;
  int bottom = -1;
  std::vector<std::int64_t> seen;
  const auto isSet = [&](std::size_t pixel) {
    Pattern pattern{};
    std::memcpy(&pattern, data + pixel * sizeof(Pattern), sizeof(Pattern));
    const std::int64_t value = storedValue(pattern, slice);
    if (value != 0 && std::ranges::find(seen, value) == seen.end()) {
      seen.push_back(value);
      if (seen.size() > kMostMaskValues) {
        throw InputError(slice.path.string() + " holds an image with many grey values, not a mask; open its folder as a CT.");
      }
    }
    return value != 0;
  };
  for (int row = 0; row < slice.rows; ++row) {
    const std::size_t first = static_cast<std::size_t>(row) * columns;
    if (allZero(data + first * sizeof(Pattern), columns * sizeof(Pattern))) {
      continue;
    }
    for (int column = 0; column < slice.columns; ++column) {
      if (isSet(first + static_cast<std::size_t>(column))) {
        low = std::min(low, column);
        high = std::max(high, column);
        top = top < 0 ? row : top;
        bottom = row;
      }
    }
  }
  MaskSlice mask;
  if (high < 0) {
    return mask;
  }
  mask.firstColumn = low;
  mask.firstRow = top;
  mask.columns = high - low + 1;
  mask.rows = bottom - top + 1;
  mask.values.reserve(static_cast<std::size_t>(mask.columns) * static_cast<std::size_t>(mask.rows));
  for (int row = top; row <= bottom; ++row) {
    for (int column = low; column <= high; ++column) {
      mask.values.push_back(isSet(static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)) ? 1 : 0);
    }
  }
  return mask;
}
}  // namespace

DicomDecoders::DicomDecoders() {
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
}

DicomDecoders::~DicomDecoders() {
  DJLSDecoderRegistration::cleanup();
  DJDecoderRegistration::cleanup();
  DcmRLEDecoderRegistration::cleanup();
}

std::size_t decodeHounsfield(DicomSlice& slice, std::span<std::int16_t> out) {
  const RawPixels raw = rawPixels(slice);
  std::size_t clamped = 0;
  if (slice.bitsAllocated == 8) {
    clamped = toHounsfield<std::uint8_t>(slice, raw.data, out);
  } else if (slice.bitsAllocated == 16) {
    clamped = toHounsfield<std::uint16_t>(slice, raw.data, out);
  } else {
    clamped = toHounsfield<std::uint32_t>(slice, raw.data, out);
  }
  slice.file.reset();
  return clamped;
}

MaskSlice decodeMask(DicomSlice& slice) {
  const RawPixels raw = rawPixels(slice);
  MaskSlice mask = slice.bitsAllocated == 8    ? toMask<std::uint8_t>(slice, raw.data)
                   : slice.bitsAllocated == 16 ? toMask<std::uint16_t>(slice, raw.data)
                                               : toMask<std::uint32_t>(slice, raw.data);
  slice.file.reset();
  return mask;
}

}  // namespace glisson::import
