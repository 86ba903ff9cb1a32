#include "planning/volumetry/near_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "planning/volumetry/cut_maker.h"

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

/// Makes `best` the distance from the tumour's boxes to a point, where that is less.
void keepNearer(const TumourBoxes& tumour, const Vec3& point, double& best, std::uint32_t of = 0) {
  const BoxTree::Node& node = tumour.tree.nodes()[of];
  if (node.isLeaf()) {
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      const Box& box = tumour.boxes[tumour.tree.order()[n]];
      best = std::min(best, ((point - box.centre).cwiseAbs() - box.half).cwiseMax(0.0).norm());
    }
    return;
  }
  const Box at{point, Vec3::Zero()};
  const double left = gapTo(tumour.tree.nodes()[of + 1], at);
  const double right = gapTo(tumour.tree.nodes()[node.right], at);
  const std::uint32_t nearer = left <= right ? of + 1 : node.right;
  if (std::min(left, right) < best) {
    keepNearer(tumour, point, best, nearer);
  }
  if (std::max(left, right) < best) {
    keepNearer(tumour, point, best, nearer == node.right ? of + 1 : node.right);
  }
}
}  // namespace

std::vector<CutPiece> surfaceNear(const TumourBoxes& tumour, const RowBlocks& liver, const std::vector<std::size_t>& cut,
                                  const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<CutPiece> pieces;
  if (tumour.boxes.empty()) {
    return pieces;
  }
  using Near = std::pair<double, std::size_t>;  // how near at least, block
  std::vector<Near> blocks;
  blocks.reserve(cut.size());
  for (const std::size_t n : cut) {
    blocks.emplace_back(gapTo(tumour.tree.nodes()[0], liver.blocks[n].box), n);
  }
  const auto farther = [](const Near& a, const Near& b) { return b < a; };
  std::make_heap(blocks.begin(), blocks.end(), farther);
  const double flattening = mostFlatteningMm(plan, spacing) + kOnPlaneMm;
  double nearest = kInfinity;  // no more than the distance of the nearest piece so far
  CutMaker maker(plan, spacing);
  while (!blocks.empty() && blocks.front().first <= nearest + flattening) {
    const RowBlock& block = liver.blocks[blocks.front().second];
    std::pop_heap(blocks.begin(), blocks.end(), farther);
    blocks.pop_back();
    if (!isWithin(tumour, block.box, nearest + flattening)) {
      continue;
    }
    for (std::size_t run = block.begin; run < block.end; ++run) {
      const std::size_t before = pieces.size();
      maker.append(liver.rows.runs[run], liver.origin[run], pieces, [&](const Box& box) {
        return gapTo(tumour.tree.nodes()[0], box) <= nearest + flattening && isWithin(tumour, box, nearest + flattening);
      });
      for (std::size_t n = before; n < pieces.size(); ++n) {
        const Vec3& corner = pieces[n].polygon[0];  // the others are hardly nearer
        if (gapTo(tumour.tree.nodes()[0], {corner, Vec3::Zero()}) < nearest) {
          keepNearer(tumour, corner, nearest);
        }
      }
    }
  }
  return pieces;
}

}  // namespace glisson
