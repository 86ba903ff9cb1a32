#pragma once
// Purpose: the shortest way from a tumour's voxel boxes to the resection surface, exactly, while the surface moves. Frame: image,
// mm.

#include <limits>
#include <optional>
#include <vector>

#include "planning/volumetry/box_tree.h"
#include "planning/volumetry/resected.h"

namespace glisson {

/// A tumour's runs of voxels as boxes, to be measured from again and again.
struct TumourBoxes {
  TumourBoxes(const VoxelRows& rows, const Vec3& spacing);
  explicit TumourBoxes(std::vector<Box> boxes);
  std::vector<Box> boxes;
  BoxTree tree;
};

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
  /// The shortest way from any of the boxes. Ties are broken by order, so results repeat.
  [[nodiscard]] Way shortest(const TumourBoxes& tumour) const;
  /// What no way to the surface itself is shorter than: the least of the pieces' distances, each less its flattening.
  [[nodiscard]] double atLeast(const TumourBoxes& tumour, const Way& way) const;
  [[nodiscard]] const std::vector<CutPiece>& pieces() const { return pieces_; }

 private:
  template <typename Look>
  void search(const TumourBoxes& tumour, std::uint32_t of, std::uint32_t to, const double& best, const Look& look) const;
  void findSharedPlanes();
  [[nodiscard]] double bound(const BoxTree::Node& of, std::uint32_t to) const;
  [[nodiscard]] double bound(std::uint32_t piece, const Box& box) const;
  void keepShortest(const Box& box, std::uint32_t piece, Way& best) const;

  std::vector<CutPiece> pieces_;
  std::vector<ImagePlane> planes_;  ///< of each piece
  std::vector<Vec3> low_;
  std::vector<Vec3> high_;
  BoxTree tree_;
  std::vector<std::optional<ImagePlane>> sharedPlanes_;  ///< of each node, where all its pieces lie on one
};

/// The shortest way between a box and a convex polygon that do not cross; 0 where they touch.
CutDistance::Way shortestWay(const Box& box, const Polygon& polygon);

}  // namespace glisson
