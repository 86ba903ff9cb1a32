#include "planning/volumetry/near_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/infinity.h"
#include "planning/volumetry/cut_maker.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

struct Extent {
  explicit Extent(const Box& box) : low(box.centre - box.half), high(box.centre + box.half) {}
  Vec3 low;
  Vec3 high;
};

double gapTo(const BoxTree::Node& node, const Extent& box) { return gap(node.low, node.high, box.low, box.high); }

/// Whether some of the tumour's boxes is within `mm` of the box.
bool isWithin(const TumourBoxes& tumour, const Extent& box, double mm, std::uint32_t of = 0) {
  const BoxTree::Node& node = tumour.tree.nodes()[of];
  if (!node.isLeaf()) {
    const double left = gapTo(tumour.tree.nodes()[of + 1], box);
    const double right = gapTo(tumour.tree.nodes()[node.right], box);
    const std::uint32_t nearer = left <= right ? of + 1 : node.right;
    return (std::min(left, right) <= mm && isWithin(tumour, box, mm, nearer)) ||
           (std::max(left, right) <= mm && isWithin(tumour, box, mm, nearer == node.right ? of + 1 : node.right));
  }
  return std::any_of(tumour.tree.order().begin() + node.begin, tumour.tree.order().begin() + node.end, [&](std::uint32_t n) {
    const Extent part(tumour.boxes[n]);
    return gap(part.low, part.high, box.low, box.high) <= mm;
  });
}

struct NearestPoint {
  double mm = kInfinity;
  Vec3 at = Vec3::Zero();
};

/// Makes `best` the tumour's point that is nearest to `point`, where that is nearer.
void keepNearer(const TumourBoxes& tumour, const Vec3& point, NearestPoint& best, std::uint32_t of = 0) {
  const BoxTree::Node& node = tumour.tree.nodes()[of];
  if (node.isLeaf()) {
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      const Box& box = tumour.boxes[tumour.tree.order()[n]];
      const Vec3 at = point.cwiseMax(box.centre - box.half).cwiseMin(box.centre + box.half);
      if (const double mm = (point - at).norm(); mm < best.mm) {
        best = {mm, at};
      }
    }
    return;
  }
  const Extent at({point, Vec3::Zero()});
  const double left = gapTo(tumour.tree.nodes()[of + 1], at);
  const double right = gapTo(tumour.tree.nodes()[node.right], at);
  const std::uint32_t nearer = left <= right ? of + 1 : node.right;
  if (std::min(left, right) < best.mm) {
    keepNearer(tumour, point, best, nearer);
  }
  if (std::max(left, right) < best.mm) {
    keepNearer(tumour, point, best, nearer == node.right ? of + 1 : node.right);
  }
}

/// Makes `end` the largest way . p of the tumour's points p, where that is more.
void keepFarther(const TumourBoxes& tumour, const Vec3& way, double& end, std::uint32_t of = 0) {
  const BoxTree::Node& node = tumour.tree.nodes()[of];
  if (0.5 * (way.dot(node.low + node.high) + way.cwiseAbs().dot(node.high - node.low)) <= end) {
    return;
  }
  if (!node.isLeaf()) {
    keepFarther(tumour, way, end, of + 1);
    keepFarther(tumour, way, end, node.right);
    return;
  }
  for (std::uint32_t n = node.begin; n < node.end; ++n) {
    const Box& box = tumour.boxes[tumour.tree.order()[n]];
    end = std::max(end, way.dot(box.centre) + way.cwiseAbs().dot(box.half));
  }
}

/// What way . p is at least for points p of a box, seen from its centre, that are in the slab, too. Of this linear programme's dual
/// the best multiplier is one that takes an axis out.
double leastAlong(const Vec3& way, const Vec3& half, const Slab& slab) {
  constexpr double kMostMultiplier = 1e3;  // larger ones would lose digits
  double least = -way.cwiseAbs().dot(half);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::abs(way[axis]) < kMostMultiplier * std::abs(slab.slope[axis])) {
      const double times = way[axis] / slab.slope[axis];
      const double rest = (way - times * slab.slope).cwiseAbs().dot(half);
      least = std::max(least, -times * slab.above - std::abs(times) * slab.off - rest);
    }
  }
  return least;
}

struct NearPiece {
  CutPiece piece;
  double leastMm = 0;  ///< how near it is at least
};

/// What was made before nearer pieces were known may be far away.
std::vector<CutPiece> within(double mm, std::vector<NearPiece>& found) {
  std::vector<CutPiece> pieces;
  for (NearPiece& one : found) {
    if (one.leastMm <= mm) {
      pieces.push_back(std::move(one.piece));
    }
  }
  return pieces;
}

/// All of them, in cutSurface()'s order.
std::vector<CutPiece> byRun(std::vector<NearPiece>& found) {
  std::vector<CutPiece> pieces = within(kInfinity, found);
  std::stable_sort(pieces.begin(), pieces.end(), [](const CutPiece& a, const CutPiece& b) { return a.run < b.run; });
  return pieces;
}

bool mayMeet(const Vec3& half, const Slab& slab) { return std::abs(slab.above) <= slab.slope.cwiseAbs().dot(half) + slab.off; }
}  // namespace

NearSurface::NearSurface(const VoxelRows& tumour, const VoxelRows& liver, const RowBlocks& blocks, const Vec3& spacing)
    : liver_(liver), blocks_(blocks), spacing_(spacing), tumour_(tumour, spacing), facings_(blocks.blocks.size()) {
  if (tumour_.boxes.empty()) {
    return;
  }
  constexpr std::size_t kBlocks = 256;
  parallelFor(facings_.size(), kBlocks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      facings_[n] = facingOf(blocks.blocks[n].box);
    }
  });
}

double NearSurface::Facing::leastTo(const Polygon& polygon) const {
  double least = kInfinity;
  for (const Vec3& corner : polygon) {
    least = std::min(least, way.dot(corner) - end);
  }
  return least;
}

NearSurface::Facing NearSurface::facingOf(const Box& block) const {
  NearestPoint nearest;
  keepNearer(tumour_, block.centre, nearest);
  if (!(nearest.mm > kOnPlaneMm)) {
    return {};
  }
  Facing facing{(block.centre - nearest.at) / nearest.mm, -kInfinity};
  keepFarther(tumour_, facing.way, facing.end);
  return facing;
}

/// No way from the tumour to the surface in the block is shorter.
double NearSurface::leastTo(std::size_t block, const std::vector<ImageResection>& plan, double flatteningMm) const {
  const Box& box = blocks_.blocks[block].box;
  const Facing& facing = facings_[block];
  double least = kInfinity;
  const auto look = [&](const Slab& slab) {
    if (mayMeet(box.half, slab)) {
      least = std::min(least, facing.way.dot(box.centre) + leastAlong(facing.way, box.half, slab) - facing.end);
    }
  };
  for (const ImageResection& resection : plan) {
    for (const ImagePlane& plane : resection.planes) {
      look({plane.normal, plane.distance(box.centre), flatteningMm});
    }
    for (const BentSurface& surface : resection.bends) {
      Slab slab = slabOf(box, surface);
      slab.off += flatteningMm;
      look(slab);
    }
  }
  return least;
}

std::vector<NearSurface::Near> NearSurface::nearestFirst(const std::vector<std::size_t>& cut,
                                                         const std::vector<ImageResection>& plan, double flatteningMm) const {
  std::vector<Near> blocks;
  blocks.reserve(cut.size());
  for (const std::size_t n : cut) {
    blocks.emplace_back(leastTo(n, plan, flatteningMm), n);
  }
  std::sort(blocks.begin(), blocks.end());
  return blocks;
}

std::vector<CutPiece> NearSurface::pieces(const std::vector<std::size_t>& cut, const std::vector<ImageResection>& plan) const {
  if (tumour_.boxes.empty()) {
    return {};
  }
  constexpr double kSlackMm = 10 * kOnPlaneMm;
  const double flattening = mostFlatteningMm(plan, spacing_) + kSlackMm;
  const bool flat = !hasBends(plan);
  CutMaker maker(plan, spacing_);
  NearestPoint nearest;  // no farther than the nearest piece so far
  std::vector<NearPiece> found;
  std::vector<CutPiece> some;
  std::vector<bool> done(flat ? liver_.runs.size() : 0);
  for (const auto& [least, n] : nearestFirst(cut, plan, flattening)) {
    const RowBlock& block = blocks_.blocks[n];
    const Facing& facing = facings_[n];
    const auto isNear = [&](const Box& box) {
      return facing.leastTo(box) <= nearest.mm + flattening && isWithin(tumour_, Extent(box), nearest.mm + flattening);
    };
    if (least > nearest.mm + flattening) {
      break;
    }
    if (!isNear(block.box)) {
      continue;
    }
    maker.stayWithin(block.box);
    for (std::size_t run = block.begin; run < block.end; ++run) {
      const RowRun& part = blocks_.rows.runs[run];
      const std::size_t whole = blocks_.origin[run];
      some.clear();
      if (!flat) {
        maker.append(part, whole, some, isNear);
      } else if (!done[whole] && isNear(boxOf(part, spacing_))) {
        done[whole] = true;
        maker.append(liver_.runs[whole], whole, some);
      }
      for (CutPiece& piece : some) {
        const double bound = facing.leastTo(piece.polygon);
        if (bound < nearest.mm) {
          keepNearer(tumour_, piece.polygon[0], nearest);  // the other corners are hardly nearer
        }
        found.push_back({std::move(piece), bound});
      }
    }
  }
  return flat ? byRun(found) : within(nearest.mm + flattening, found);
}

}  // namespace glisson
