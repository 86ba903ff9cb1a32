#pragma once
// A volume on disk: small enough for a test of opening, large enough for a surface.

#include <algorithm>
#include <array>

#include "tests/reconstruction/io/fixtures.h"

namespace glisson::test {

/// A cube of 16^3 voxels in a box of 32^3, as NRRD: a CT where T is std::int16_t, labels where it is std::uint8_t. `extra`: further
/// header lines.
template <typename T>
void writeCube(const std::filesystem::path& path, T inside, T outside, const std::string& extra = {}) {
  ImageGeometry box;
  box.size = {32, 32, 32};
  box.spacing = Vec3(2, 2, 2);
  const bool isCt = sizeof(T) > 1;
  std::vector<T> values;
  for (int voxel = 0; voxel < 32 * 32 * 32; ++voxel) {
    const std::array at{voxel % 32, voxel / 32 % 32, voxel / 1024};
    const bool in = std::ranges::all_of(at, [](int i) { return i >= 8 && i < 24; });
    const int noise = isCt ? voxel % 7 : 0;  // two values alone would be no CT
    values.push_back(static_cast<T>((in ? inside : outside) + noise));
  }
  fixtures::writeFile(path, fixtures::nrrd(box, fixtures::bytesOf(values), isCt ? "short" : "unsigned char",
                                           "left-posterior-superior", false, extra));
}

}  // namespace glisson::test
