#include "viewer/slice_outlines.h"

#include <algorithm>
#include <cmath>

namespace glisson {

namespace {

/// The part of a slice a mask covers, as 0 or 1, with a border of zeros.
struct Patch {
  int firstColumn = 0;
  int firstRow = 0;
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> values;

  [[nodiscard]] unsigned at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

std::size_t greyIndex(int hu) {
  const int offset = hu + 32768;
  return static_cast<std::size_t>(offset);
}

Index3 voxelOf(const SliceGeometry& g, int column, int row, int slice) {
  Index3 voxel{};
  voxel[g.columnAxis] = g.columnFlipped ? g.columns() - 1 - column : column;
  voxel[g.rowAxis] = g.rowFlipped ? g.rows() - 1 - row : row;
  voxel[g.sliceAxis] = slice;
  return voxel;
}

/// First picture column (or row) and count of a box's extent along one axis.
std::pair<int, int> extentOf(const IndexBox& box, std::size_t axis, int size, bool flipped) {
  const int first = flipped ? size - box.first[axis] - box.size[axis] : box.first[axis];
  return {first, box.size[axis]};
}

Patch patchOnGrid(const Mask& mask, const SliceGeometry& g, int slice) {
  const IndexBox& box = mask.box();
  Patch patch;
  if (mask.empty() || slice < box.first[g.sliceAxis] || slice >= box.first[g.sliceAxis] + box.size[g.sliceAxis]) {
    return patch;
  }
  const auto [column, columns] = extentOf(box, g.columnAxis, g.columns(), g.columnFlipped);
  const auto [row, rows] = extentOf(box, g.rowAxis, g.rows(), g.rowFlipped);
  patch = {column - 1, row - 1, columns + 2, rows + 2, {}};
  patch.values.assign(static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows), 0);
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(box.size[0]),
                                          static_cast<std::size_t>(box.size[0]) * static_cast<std::size_t>(box.size[1])};
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Index3 voxel = voxelOf(g, column + c, row + r, slice);
      std::size_t offset = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        offset += stride[a] * static_cast<std::size_t>(voxel[a] - box.first[a]);
      }
      patch.values[static_cast<std::size_t>(r + 1) * static_cast<std::size_t>(patch.columns) + static_cast<std::size_t>(c + 1)] =
          mask.values()[offset];
    }
  }
  return patch;
}

Patch patchResampled(const Mask& mask, const ImageGeometry& maskGrid, const SliceGeometry& g, int slice) {
  Patch patch{-1, -1, g.columns() + 2, g.rows() + 2, {}};
  patch.values.assign(static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows), 0);
  for (int r = 0; r < g.rows(); ++r) {
    for (int c = 0; c < g.columns(); ++c) {
      const Vec3 index = maskGrid.toIndex(g.toWorld({c, r}, slice)).array().round();
      const bool inside = (index.array() >= 0).all() && (index.array() < 65536).all() &&
                          mask.at(static_cast<int>(index.x()), static_cast<int>(index.y()), static_cast<int>(index.z()));
      patch.values[static_cast<std::size_t>(r + 1) * static_cast<std::size_t>(patch.columns) + static_cast<std::size_t>(c + 1)] =
          inside ? 1 : 0;
    }
  }
  return patch;
}

}  // namespace

QImage sliceImage(const CtVolume& ct, const SliceGeometry& g, int slice, double width, double level) {
  QImage image(g.columns(), g.rows(), QImage::Format_Grayscale8);
  const double low = level - 0.5 * width;
  const double scale = 255.0 / std::max(width, 1e-6);
  std::vector<std::uint8_t> grey(65536);
  for (int hu = -32768; hu <= 32767; ++hu) {
    grey[greyIndex(hu)] = static_cast<std::uint8_t>(std::lround(std::clamp((hu - low) * scale, 0.0, 255.0)));
  }
  const std::array<std::ptrdiff_t, 3> stride{1, ct.geometry.size[0],
                                             static_cast<std::ptrdiff_t>(ct.geometry.size[0]) * ct.geometry.size[1]};
  const std::ptrdiff_t columnStep = (g.columnFlipped ? -1 : 1) * stride[g.columnAxis];
  for (int row = 0; row < g.rows(); ++row) {
    const Index3 first = voxelOf(g, 0, row, slice);
    const std::int16_t* value = ct.hounsfield.data() + first[0] * stride[0] + first[1] * stride[1] + first[2] * stride[2];
    std::uint8_t* out = image.scanLine(row);
    for (int column = 0; column < g.columns(); ++column) {
      out[column] = grey[greyIndex(value[column * columnStep])];
    }
  }
  return image;
}

std::vector<std::pair<SlicePoint, SlicePoint>> outlineOf(const Mask& mask, const ImageGeometry& maskGrid,
                                                         const SliceGeometry& geometry, int slice) {
  const bool sameGrid = maskGrid.cornerDistance(geometry.grid) <= kSameGridMm;
  const Patch patch = sameGrid ? patchOnGrid(mask, geometry, slice) : patchResampled(mask, maskGrid, geometry, slice);
  std::vector<std::pair<SlicePoint, SlicePoint>> lines;
  for (int r = 0; r + 1 < patch.rows; ++r) {
    for (int c = 0; c + 1 < patch.columns; ++c) {
      const unsigned corners =
          patch.at(c, r) | (patch.at(c + 1, r) << 1U) | (patch.at(c + 1, r + 1) << 2U) | (patch.at(c, r + 1) << 3U);
      if (corners == 0 || corners == 15) {
        continue;
      }
      const SlicePoint at(patch.firstColumn + c, patch.firstRow + r);
      const std::array<SlicePoint, 4> middle{at + SlicePoint(0.5, 0), at + SlicePoint(1, 0.5), at + SlicePoint(0.5, 1),
                                             at + SlicePoint(0, 0.5)};
      // An edge of the cell is crossed where its two corners differ; corners are counted clockwise as the edges are.
      std::array<std::size_t, 4> crossed{};
      std::size_t count = 0;
      for (std::size_t e = 0; e < 4; ++e) {
        if (((corners >> e) & 1U) != ((corners >> ((e + 1) % 4)) & 1U)) {
          crossed[count++] = e;
        }
      }
      if (count == 2) {
        lines.emplace_back(middle[crossed[0]], middle[crossed[1]]);
      } else if (corners == 5) {  // two set corners on a diagonal stay apart
        lines.emplace_back(middle[3], middle[0]);
        lines.emplace_back(middle[1], middle[2]);
      } else {
        lines.emplace_back(middle[0], middle[1]);
        lines.emplace_back(middle[2], middle[3]);
      }
    }
  }
  return lines;
}

bool looksTheSame(const LiverModel* a, const LiverModel* b) {
  if (a == nullptr || b == nullptr) {
    return a == b;
  }
  return std::ranges::equal(a->structures, b->structures, [](const Structure& one, const Structure& other) {
    return one.kind == other.kind && one.sourceIndex == other.sourceIndex && one.colour == other.colour &&
           one.visible == other.visible && one.reconstruction == other.reconstruction;
  });
}

}  // namespace glisson
