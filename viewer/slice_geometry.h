#pragma once
// Purpose: which index axis a slice view runs along, and pixel <-> index <-> world for it. Radiological convention: axial from the
// feet (left of the patient on the right, posterior down), coronal from the front (superior up), sagittal from the patient's left
// (anterior on the left, superior up). Oblique and flipped grids: each view takes the index axes nearest to its LPS axes.

#include <Eigen/Core>
#include <array>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

enum class SliceAxis;

/// A point of a slice: column (right), row (down), in voxels; whole numbers are voxel centres.
using SlicePoint = Eigen::Vector2d;

struct SliceGeometry {
  ImageGeometry grid;
  std::size_t columnAxis = 0;  ///< index axis that runs along the picture's width
  std::size_t rowAxis = 1;
  std::size_t sliceAxis = 2;
  bool columnFlipped = false;  ///< the picture's right is the falling index
  bool rowFlipped = false;
  bool sliceFlipped = false;  ///< the falling index goes to the patient's left, back or head

  SliceGeometry() = default;
  SliceGeometry(const ImageGeometry& grid, SliceAxis axis);

  [[nodiscard]] int columns() const { return grid.size[columnAxis]; }
  [[nodiscard]] int rows() const { return grid.size[rowAxis]; }
  [[nodiscard]] int slices() const { return grid.size[sliceAxis]; }
  [[nodiscard]] double columnSpacing() const { return grid.spacing[static_cast<Eigen::Index>(columnAxis)]; }
  [[nodiscard]] double rowSpacing() const { return grid.spacing[static_cast<Eigen::Index>(rowAxis)]; }

  [[nodiscard]] Vec3 toIndex(const SlicePoint& point, double slice) const;
  [[nodiscard]] Vec3 toWorld(const SlicePoint& point, double slice) const { return grid.toWorld(toIndex(point, slice)); }
  [[nodiscard]] SlicePoint toSlice(const Vec3& world) const;
  /// The slice that holds a world point, clamped to the grid.
  [[nodiscard]] int sliceOf(const Vec3& world) const;
  /// "R", "L", "A", "P", "S" or "I" for the picture's left, right, top and bottom.
  [[nodiscard]] std::array<char, 4> letters() const;
};

/// The letter of the LPS axis a world direction is nearest to.
char letterOf(const Vec3& direction);

}  // namespace glisson
