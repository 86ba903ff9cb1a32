#include "planning/volumetry/near_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planning/volumetry/cut_maker.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double gapTo(const BoxTree::Node& node, const Box& box) {
  return gap(node.low, node.high, box.centre - box.half, box.centre + box.half);
}

/// Whether some of the tumour's boxes is within `mm` of the box.
bool isWithin(const TumourBoxes& tumour, const Box& box, double mm, std::uint32_t of = 0) {
  const BoxTree::Node& node = tumour.tree.nodes()[of];
  if (!node.isLeaf()) {
    const double left = gapTo(tumour.tree.nodes()[of + 1], box);
    const double right = gapTo(tumour.tree.nodes()[node.right], box);
    const std::uint32_t nearer = left <= right ? of + 1 : node.right;
    return (std::min(left, right) <= mm && isWithin(tumour, box, mm, nearer)) ||
           (std::max(left, right) <= mm && isWithin(tumour, box, mm, nearer == node.right ? of + 1 : node.right));
  }
  return std::any_of(tumour.tree.order().begin() + node.begin, tumour.tree.order().begin() + node.end, [&](std::uint32_t n) {
    const Box& part = tumour.boxes[n];
    return gap(part.centre - part.half, part.centre + part.half, box.centre - box.half, box.centre + box.half) <= mm;
  });
}

struct Nearest {
  double mm = kInfinity;
  Vec3 at = Vec3::Zero();
};

/// Makes `best` the tumour's point that is nearest to `point`, where that is nearer.
void keepNearer(const TumourBoxes& tumour, const Vec3& point, Nearest& best, std::uint32_t of = 0) {
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
  const Box at{point, Vec3::Zero()};
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

NearSurface::Facing NearSurface::facingOf(const Box& block) const {
  Nearest nearest;
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
  std::vector<CutPiece> pieces;
  if (tumour_.boxes.empty()) {
    return pieces;
  }
  constexpr double kSlackMm = 10 * kOnPlaneMm;
  const double flattening = mostFlatteningMm(plan, spacing_) + kSlackMm;
  Nearest nearest;  // no farther than the nearest piece so far
  const bool flat = !hasBends(plan);
  std::vector<bool> done(flat ? liver_.runs.size() : 0);
  CutMaker maker(plan, spacing_);
  for (const auto& [least, n] : nearestFirst(cut, plan, flattening)) {
    if (least > nearest.mm + flattening) {
      break;
    }
    const RowBlock& block = blocks_.blocks[n];
    const auto isNear = [&, &facing = facings_[n]](const Box& box) {
      return facing.leastTo(box) <= nearest.mm + flattening && isWithin(tumour_, box, nearest.mm + flattening);
    };
    if (!isNear(block.box)) {
      continue;
    }
    for (std::size_t run = block.begin; run < block.end; ++run) {
      const RowRun& part = blocks_.rows.runs[run];
      const std::size_t whole = blocks_.origin[run];
      const std::size_t before = pieces.size();
      if (!flat) {
        maker.append(part, whole, pieces, isNear);
      } else if (!done[whole] && isNear(boxOf(part, spacing_))) {
        done[whole] = true;
        maker.append(liver_.runs[whole], whole, pieces);
      }
      for (std::size_t piece = before; piece < pieces.size(); ++piece) {
        const Vec3& corner = pieces[piece].polygon[0];  // the others are hardly nearer
        if (gapTo(tumour_.tree.nodes()[0], {corner, Vec3::Zero()}) < nearest.mm) {
          keepNearer(tumour_, corner, nearest);
        }
      }
    }
  }
  if (flat) {
    std::stable_sort(pieces.begin(), pieces.end(), [](const CutPiece& a, const CutPiece& b) { return a.run < b.run; });
  }
  return pieces;
}

}  // namespace glisson
