#pragma once
// Purpose: the few pieces of the resection surface that decide about a tumour's margin, without the others. Frame: image, mm.
// What does not change while the surface moves is kept: for each block of the liver, the way from the tumour to it. Along this way
// the surface in the block is bounded by the block and by the plane that touches it there, so only the nearest blocks are gone
// through.

#include <utility>
#include <vector>

#include "planning/volumetry/cut_distance.h"
#include "planning/volumetry/row_blocks.h"

namespace glisson {

/// Const and thread-safe once built.
class NearSurface {
 public:
  /// `liver` and its `blocks` outlive this.
  NearSurface(const VoxelRows& tumour, const VoxelRows& liver, const RowBlocks& blocks, const Vec3& spacing);

  [[nodiscard]] const TumourBoxes& tumour() const { return tumour_; }

  /// Pieces of the surface inside the liver among which are all that marginOf() needs: those that may be nearest, and those that
  /// may come as near by what a bent plane's pieces are flattened. Of flat planes they are cutSurface()'s of the liver's rows, of
  /// others those of its blocks. `cut`: cutBlocks() of the plan. None where there is no surface.
  [[nodiscard]] std::vector<CutPiece> pieces(const std::vector<std::size_t>& cut, const std::vector<ImageResection>& plan) const;

 private:
  struct Facing {
    Vec3 way = Vec3::Zero();  ///< unit, from the tumour to the block's centre; zero where that is inside
    double end = 0;           ///< way . p is at most this for all points p of the tumour

    /// No way from the tumour to the box is shorter.
    [[nodiscard]] double leastTo(const Box& box) const { return way.dot(box.centre) - way.cwiseAbs().dot(box.half) - end; }
    [[nodiscard]] double leastTo(const Polygon& polygon) const;
  };
  using Near = std::pair<double, std::size_t>;  ///< how near the surface in a block is at least, mm; the block

  [[nodiscard]] Facing facingOf(const Box& block) const;
  [[nodiscard]] double leastTo(std::size_t block, const std::vector<ImageResection>& plan, double flatteningMm) const;
  [[nodiscard]] std::vector<Near> nearestFirst(const std::vector<std::size_t>& cut, const std::vector<ImageResection>& plan,
                                               double flatteningMm) const;

  const VoxelRows& liver_;
  const RowBlocks& blocks_;
  Vec3 spacing_;
  TumourBoxes tumour_;
  std::vector<Facing> facings_;  ///< of each block
};

}  // namespace glisson
