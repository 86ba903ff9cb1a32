#pragma once
// Purpose: the distance from points of a resection surface to the nearest tumour's voxel boxes, exactly, fast enough to colour the
// surface while it moves. Frame: mm LPS.

#include <cstdint>
#include <limits>
#include <vector>

#include "planning/case/case.h"
#include "planning/volumetry/voxel_rows.h"

namespace glisson {

class TumourDistance {
 public:
  /// Of all tumours of the case; cysts are none. Const and thread-safe once built.
  explicit TumourDistance(const Case& source);
  [[nodiscard]] bool empty() const { return boxes_.empty(); }

  struct Way {
    double mm = std::numeric_limits<double>::infinity();         ///< 0 inside a tumour
    double atLeastMm = std::numeric_limits<double>::infinity();  ///< mm less half a voxel's extent along the way (method.md 5)
  };
  /// Of equally near boxes one is taken, always the same. `within`: nothing farther is looked for; infinity is the answer then.
  [[nodiscard]] Way from(const Vec3& point, double within = std::numeric_limits<double>::infinity()) const;

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;    ///< boxes_[begin, end) where it is a leaf
    std::uint32_t right = 0;  ///< 0: a leaf; the left child follows its parent
  };
  struct Best {
    double squared = 0;
    Vec3 step = Vec3::Zero();
    bool found = false;
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  void search(std::uint32_t node, const Vec3& point, Best& best) const;

  ImageGeometry geometry_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

/// A rectangle of points origin + stepMm (column u + row v) on a plane; u and v are unit and perpendicular. Over a bent plane its
/// points stand for those of the surface over or under them.
struct PlaneGrid {
  Vec3 origin = Vec3::Zero();
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitY();
  double stepMm = 1;
  int columns = 0;
  int rows = 0;
};

struct MarginMap {
  PlaneGrid grid;
  std::vector<TumourDistance::Way> ways;  ///< by row, then column
};

/// The grid's points, rows in parallel; the same for any number of threads. A point farther than `within` is not looked up exactly:
/// infinity. `bent`: from the surface's points over or under the grid's; null: from the grid's.
MarginMap marginMap(const TumourDistance& tumours, const PlaneGrid& grid, double within, const BentSurface* bent = nullptr);

}  // namespace glisson
