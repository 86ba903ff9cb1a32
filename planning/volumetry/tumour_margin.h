#pragma once
// Purpose: a tumour's state and margin (method.md 5), from its voxel boxes to the resection surface inside the liver.

#include "planning/volumetry/resected.h"

namespace glisson {

/// Finds the shortest way from boxes to a set of convex polygons, exactly. Const and thread-safe once built.
class CutDistance {
 public:
  explicit CutDistance(std::vector<CutPiece> pieces);

  struct Way {
    double mm = 0;             ///< infinity where there is no surface
    Vec3 from = Vec3::Zero();  ///< on the boxes
    Vec3 to = Vec3::Zero();    ///< on the surface
    std::size_t piece = 0;
  };
  /// The shortest way from any of the runs' boxes. Ties are broken by order, so results repeat.
  [[nodiscard]] Way shortest(const VoxelRows& rows, const Vec3& spacing) const;
  /// What no way to the surface itself is shorter than: the least of the pieces' distances, each less its flattening.
  [[nodiscard]] double atLeast(const VoxelRows& rows, const Vec3& spacing, const Way& way) const;
  [[nodiscard]] const std::vector<CutPiece>& pieces() const { return pieces_; }

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;    ///< pieces order_[begin, end) where it is a leaf
    std::uint32_t right = 0;  ///< 0: a leaf; the left child follows its parent
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  template <typename Look>
  void search(std::uint32_t node, const Box& box, const double& best, const Look& look) const;
  [[nodiscard]] double bound(std::uint32_t piece, const Box& box) const;
  void keepShortest(const Box& box, std::uint32_t piece, Way& best) const;

  std::vector<CutPiece> pieces_;
  std::vector<std::uint32_t> order_;
  std::vector<ImagePlane> planes_;  ///< of each piece
  std::vector<Vec3> low_;
  std::vector<Vec3> high_;
  std::vector<Node> nodes_;
};

/// The shortest way between a box and a convex polygon that do not cross; 0 where they touch.
CutDistance::Way shortestWay(const Box& box, const Polygon& polygon);

/// The margin of boxes that lie on the resected side altogether.
struct Margin {
  double mm = 0;             ///< infinity where there is no surface
  double atLeast = 0;        ///< mm - what a bent plane's pieces are flattened by - resolution along the shortest way
  Vec3 from = Vec3::Zero();  ///< of the shortest way: on the boxes
  Vec3 to = Vec3::Zero();    ///< on the surface
};
Margin marginOf(const VoxelRows& rows, const Vec3& spacing, const CutDistance& cut);

/// The greatest distance of the boxes' points to the resected region, mm; the direction it is measured along in `normal`. Exact for
/// one resection of flat planes (the distance to a convex body is greatest at a corner); several, or bent: over the corners. To a
/// bent surface by touching planes from the nearest of 169 of its points, within 0.01 mm where its radius is larger than the depth;
/// where the steps do not settle, the largest of their depths, and along a plane's normal where they find none: no corner outside
/// has depth 0.
double greatestDepth(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan, Vec3& normal);

/// Half the extent of a voxel along a unit direction: what a margin along it cannot resolve.
double resolutionMm(const Vec3& direction, const Vec3& spacing);

}  // namespace glisson
