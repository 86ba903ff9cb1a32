#pragma once
// Purpose: image files as ITK writes them. Apart from everything else: ITK brings an Eigen of its own that cannot be mixed with
// ours.

#include <array>
#include <filesystem>
#include <vector>

namespace glisson::fixtures {

/// Signed 16-bit voxels, i fastest; lengths mm, LPS; `direction` row by row. The image's index starts at (3, -2, 5), which ITK
/// folds into the origin it writes: `origin` is that of the first voxel.
struct ItkImage {
  std::array<int, 3> size{};
  std::array<double, 3> spacing{};
  std::array<double, 3> origin{};
  std::array<double, 9> direction{};
  std::vector<short> voxels;
};
void writeWithItk(const std::filesystem::path& path, const ItkImage& image, bool compressed);

}  // namespace glisson::fixtures
