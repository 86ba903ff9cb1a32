#pragma once
// Purpose: the points nearest to a place, by a k-d tree (Bentley, Multidimensional binary search trees used for associative
// searching, Communications of the ACM, 1975).

#include <cstdint>
#include <span>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

/// Const and thread-safe once built. Points are named by their places in the span.
class PointTree {
 public:
  /// Copies the points. Throws std::invalid_argument where there are none.
  explicit PointTree(std::span<const Vec3> points);

  /// The `count` nearest points, or all where there are fewer, from near to far; of two as far away the one of the lower place
  /// first, so that points on a grid have one answer.
  void nearest(const Vec3& at, std::size_t count, std::vector<std::uint32_t>& found) const;
  /// The points nearer than `radius`, in an order of the tree's.
  void within(const Vec3& centre, double radius, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    std::uint32_t begin = 0;  ///< points [begin, end) of order_
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< the second child (the first follows its parent); 0: a leaf
    [[nodiscard]] double squaredDistance(const Vec3& at) const;
  };
  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<Vec3> points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace glisson
