#pragma once
// Purpose: verified voxel bytes as numbers, and from numbers to a CT or to masks.

#include <cstring>
#include <set>
#include <span>

#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/segmentation.h"
#include "reconstruction/io/import/image_file.h"

namespace glisson::import {

/// Calls body(T{}) with the C++ type of the scalar.
template <typename Body>
auto withType(Scalar scalar, Body&& body) {
  switch (scalar) {
    case Scalar::U8:
      return body(std::uint8_t{});
    case Scalar::I8:
      return body(std::int8_t{});
    case Scalar::U16:
      return body(std::uint16_t{});
    case Scalar::I16:
      return body(std::int16_t{});
    case Scalar::U32:
      return body(std::uint32_t{});
    case Scalar::I32:
      return body(std::int32_t{});
    case Scalar::U64:
      return body(std::uint64_t{});
    case Scalar::I64:
      return body(std::int64_t{});
    case Scalar::F32:
      return body(float{});
    case Scalar::F64:
      break;
  }
  return body(double{});
}

/// Value n of raw bytes (unaligned).
template <typename T>
T valueAt(std::span<const std::uint8_t> bytes, std::size_t n) {
  T value{};
  std::memcpy(&value, bytes.data() + n * sizeof(T), sizeof(T));
  return value;
}

/// Hounsfield units in 16 bits. Throws InputError where a value is not finite or all are the same; adds notes where values were cut
/// to the range of 16 bits or look like no Hounsfield units. Consumes file.bytes.
CtVolume toCt(const std::filesystem::path& path, ImageFile&& file);
/// The notes and refusals about the range of values that all CT readers share.
void checkHounsfield(const std::string& name, CtVolume& ct, std::size_t clamped);

/// One mask per label, or per segment where the file names them. Kinds are recognised; the user's choices win.
/// Throws InputError where the values are no labels (negative, not whole, too many) or none is set.
Segmentation toSegmentation(const std::filesystem::path& path, ImageFile&& file, const ReadOptions& options);
/// Every non-zero value of a file of one organ; nothing set is an empty mask. Throws InputError where it holds several labels.
Mask toOneMask(const std::filesystem::path& path, ImageFile&& file);

/// The user's choice for a name, else what the name means.
std::optional<StructureKind> kindOfName(const std::string& name, const ReadOptions& options);
std::vector<std::string> namesOf(const Segmentation& segmentation);
/// Throws InputError where the user gave a kind to a name or number that is not among these: a choice that has no effect would
/// leave a structure unread without a word. `numbers` is empty where structures have names only.
void requireChosen(const std::string& name, const std::vector<std::string>& names, const std::set<int>& numbers,
                   const ReadOptions& options);
/// Adds the notes about empty structures; throws InputError where nothing at all is set.
void checkLabels(const std::string& name, Segmentation& segmentation);

}  // namespace glisson::import
