#include "planning/volumetry/island_depth.h"

#include <algorithm>
#include <cmath>

namespace glisson {

namespace {
/// A point on the surface has depth 0 on either side.
bool stays(const Box& point, const RowRun& voxel, const std::vector<ImageResection>& plan, const SidePieces& sides) {
  const bool resected = isResected(point, plan);
  const auto piece = sides.pieceAt(resected ? PlanSide::Resected : PlanSide::Remnant, voxel.i, voxel.j, voxel.k);
  return piece && sides.pieces()[*piece].switched ? resected : !resected;
}
}  // namespace

CutDistance::Way greatestDepth(const VoxelRows& tumour, const Vec3& spacing, const std::vector<ImageResection>& plan,
                               const SidePieces& sides, const CutDistance& cut) {
  CutDistance::Way deepest;
  std::size_t near = cut.pieces().size();  // the piece the last corner was nearest to: hardly farther from its neighbours
  for (const RowRun& run : tumour.runs) {
    for (int i = run.i; i < run.i + run.n; ++i) {
      const RowRun voxel{i, run.j, run.k, 1};
      const Box box = boxOf(voxel, spacing);
      for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 p = cornerOf(box, corner);
        const Box point{p, Vec3::Zero()};
        const bool shallow = near < cut.pieces().size() && (p - cut.pieces()[near].polygon[0]).norm() <= deepest.mm;
        if (shallow || !stays(point, voxel, plan, sides)) {
          continue;
        }
        const CutDistance::Way way = cut.shortest(TumourBoxes({point}));
        near = way.piece;
        if (std::isfinite(way.mm) && way.mm > deepest.mm) {
          deepest = way;
        }
      }
    }
  }
  return deepest;
}

}  // namespace glisson
