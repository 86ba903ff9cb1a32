#pragma once
// Purpose: where a voxel grid lies in the world. The only place that maps index <-> world.
// Frame: LPS millimetres (x to the patient's left, y to posterior, z to superior). Voxel (0,0,0)'s CENTRE is at `origin`.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>

namespace glisson {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Index3 = std::array<int, 3>;

struct ImageGeometry {
  Index3 size{0, 0, 0};               ///< voxels along i, j, k; i is fastest in memory
  Vec3 spacing = Vec3::Ones();        ///< mm
  Vec3 origin = Vec3::Zero();         ///< mm LPS, centre of voxel (0,0,0); readers fold a non-zero extent into it
  Mat3 direction = Mat3::Identity();  ///< orthonormal; column a is the world direction of index axis a; det may be -1

  [[nodiscard]] std::size_t voxelCount() const;
  [[nodiscard]] double voxelVolumeMm3() const;
  /// Continuous index -> world. Index (i,j,k) is the voxel's centre; its box is +-0.5.
  [[nodiscard]] Vec3 toWorld(const Vec3& index) const {
    const Vec3 mm = spacing.cwiseProduct(index);
    return origin + (mm[0] * direction.col(0) + mm[1] * direction.col(1) + mm[2] * direction.col(2));
  }
  [[nodiscard]] Vec3 toIndex(const Vec3& world) const;
  /// direction * diag(spacing): columns are the steps of one voxel in mm.
  [[nodiscard]] Mat3 indexToWorldMatrix() const;
  [[nodiscard]] bool leftHanded() const;
  /// The greatest distance in mm of the 8 outer corners (voxel centres) of two grids; infinity where the sizes differ.
  [[nodiscard]] double cornerDistance(const ImageGeometry& other) const;
  /// "512x512x129 voxels of 0.570x0.570x1.600 mm at (x, y, z)": for messages.
  [[nodiscard]] std::string describe() const;
  /// Throws InputError naming `what` where sizes are below 1, numbers are not finite, spacing <= 0 or direction is not orthonormal
  /// (1e-3).
  void validate(const std::string& what) const;
};

/// For each world axis the index axis nearest to it: the assignment with the greatest sum of cosines.
std::array<std::size_t, 3> nearestIndexAxes(const Mat3& direction);

/// A grid this close at its 8 corners is the same grid (reliability.md).
inline constexpr double kSameGridMm = 0.01;

}  // namespace glisson
