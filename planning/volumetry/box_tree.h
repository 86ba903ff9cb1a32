#pragma once
// Purpose: axis-parallel boxes in a tree of bounds, for finding what is near (Ericson, Real-Time Collision Detection, 2005, 6.2:
// built from the top, halved at the median of the longest axis).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

class BoxTree {
 public:
  BoxTree() = default;
  /// Item n lies within low[n] and high[n].
  BoxTree(const std::vector<Vec3>& low, const std::vector<Vec3>& high);

  struct Node {
    Vec3 low;
    Vec3 high;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;    ///< items order()[begin, end)
    std::uint32_t right = 0;  ///< 0: a leaf; the left child follows its parent
    [[nodiscard]] bool isLeaf() const { return right == 0; }
  };
  /// The root first; none without items.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  std::uint32_t build(const std::vector<Vec3>& low, const std::vector<Vec3>& high, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

/// How far two boxes are apart; 0 where they meet.
inline double gap(const Vec3& lowA, const Vec3& highA, const Vec3& lowB, const Vec3& highB) {
  double squared = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double apart = std::max(std::max(lowB[axis] - highA[axis], lowA[axis] - highB[axis]), 0.0);
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

}  // namespace glisson
