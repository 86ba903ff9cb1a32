#include "viewer/slice_geometry.h"

#include <algorithm>
#include <cmath>

#include "viewer/slice_view.h"

namespace glisson {

namespace {

struct ViewAxes {
  std::size_t right;  ///< world axis along the picture's width, rising to the right
  std::size_t down;   ///< world axis along the height
  bool downFalls;     ///< superior is up: z falls downwards
  std::size_t through;
};

ViewAxes viewAxes(SliceAxis axis) {
  switch (axis) {
    case SliceAxis::Axial:
      return {0, 1, false, 2};
    case SliceAxis::Coronal:
      return {0, 2, true, 1};
    case SliceAxis::Sagittal:
      break;
  }
  return {1, 2, true, 0};
}

}  // namespace

SliceGeometry::SliceGeometry(const ImageGeometry& volume, SliceAxis axis) : grid(volume) {
  const std::array<std::size_t, 3> indexAxis = nearestIndexAxes(grid.direction);
  const ViewAxes view = viewAxes(axis);
  const auto falls = [&](std::size_t world) {
    return grid.direction(static_cast<Eigen::Index>(world), static_cast<Eigen::Index>(indexAxis[world])) < 0;
  };
  columnAxis = indexAxis[view.right];
  rowAxis = indexAxis[view.down];
  sliceAxis = indexAxis[view.through];
  columnFlipped = falls(view.right);
  rowFlipped = falls(view.down) != view.downFalls;
  sliceFlipped = falls(view.through);
}

Vec3 SliceGeometry::toIndex(const SlicePoint& point, double slice) const {
  Vec3 index;
  index[static_cast<Eigen::Index>(columnAxis)] = columnFlipped ? columns() - 1 - point.x() : point.x();
  index[static_cast<Eigen::Index>(rowAxis)] = rowFlipped ? rows() - 1 - point.y() : point.y();
  index[static_cast<Eigen::Index>(sliceAxis)] = slice;
  return index;
}

SlicePoint SliceGeometry::toSlice(const Vec3& world) const {
  const Vec3 index = grid.toIndex(world);
  const double column = index[static_cast<Eigen::Index>(columnAxis)];
  const double row = index[static_cast<Eigen::Index>(rowAxis)];
  return {columnFlipped ? columns() - 1 - column : column, rowFlipped ? rows() - 1 - row : row};
}

int SliceGeometry::sliceOf(const Vec3& world) const {
  const double slice = std::round(grid.toIndex(world)[static_cast<Eigen::Index>(sliceAxis)]);
  return static_cast<int>(std::clamp(slice, 0.0, static_cast<double>(std::max(0, slices() - 1))));
}

std::array<char, 4> SliceGeometry::letters() const {
  const Vec3 right = grid.direction.col(static_cast<Eigen::Index>(columnAxis)) * (columnFlipped ? -1.0 : 1.0);
  const Vec3 down = grid.direction.col(static_cast<Eigen::Index>(rowAxis)) * (rowFlipped ? -1.0 : 1.0);
  return {letterOf(-right), letterOf(right), letterOf(-down), letterOf(down)};
}

char letterOf(const Vec3& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  constexpr std::array<std::array<char, 2>, 3> kLetters{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  return kLetters[static_cast<std::size_t>(axis)][direction[axis] > 0 ? 1 : 0];
}

}  // namespace glisson
