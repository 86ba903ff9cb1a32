#pragma once
// Purpose: the voxels of NIfTI, NRRD and MetaImage files as ITK decodes them, and its own reading of their headers as a second
// opinion. Frame: LPS mm. ITK believes byte counts and header fields, so what is given to it has been verified before.
// ITK stays in this one source file: it brings an Eigen of its own, which cannot be mixed with ours, and is slow to compile.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/io/import/scalar.h"

namespace glisson::import {

enum class ItkFormat : std::uint8_t { Nifti, Nrrd, MetaImage };

/// A file as it is handed to ITK.
struct ItkFile {
  ItkFormat format = ItkFormat::Nifti;
  std::string name;                 ///< the user's file, for messages
  std::filesystem::path path;       ///< what ITK opens
  std::filesystem::path placeless;  ///< opened instead where ITK makes nothing of the header of `path`: the same without its place
};

struct ItkHeader {
  std::vector<std::size_t> sizes;  ///< one per dimension
  std::size_t valuesPerVoxel = 1;
  std::optional<Scalar> scalar;  ///< nothing: another type
  // Filled where there are three dimensions.
  std::array<double, 3> spacing{};
  bool placed = false;  ///< the rest is the place; false where ITK read `placeless`
  std::array<double, 3> origin{};
  std::array<std::array<double, 3>, 3> axes{};  ///< the direction of each axis
};

/// All values in native byte order, those of one voxel side by side (a list axis comes first), neither scaled nor checked.
/// `accept` sees the header before any voxel is read and may throw. Throws InputError where ITK cannot read the file,
/// std::bad_alloc.
std::vector<std::uint8_t> decodeWithItk(const ItkFile& file, const std::function<void(const ItkHeader&)>& accept);

}  // namespace glisson::import
