#include "planning/volumetry/tumour_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "planning/infinity.h"
#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

/// From a point to the nearest point of [low, high].
Vec3 stepTo(const Vec3& point, const Vec3& low, const Vec3& high) { return point.cwiseMax(low).cwiseMin(high) - point; }

}  // namespace

TumourDistance::TumourDistance(const Case& source) {
  if (!source.model || !source.segmentation || !source.liver) {
    return;
  }
  geometry_ = source.liver->geometry;
  const auto& masks = source.segmentation->structures;
  for (const Structure& structure : source.model->structures) {
    const auto index = static_cast<std::size_t>(structure.sourceIndex);
    if (structure.kind != StructureKind::Tumour || structure.sourceIndex < 0 || index >= masks.size() || !masks[index].mask) {
      continue;
    }
    for (const RowRun& run : rowsOf(*masks[index].mask).runs) {
      boxes_.push_back(boxOf(run, geometry_.spacing));
    }
  }
  if (!boxes_.empty()) {
    build(0, static_cast<std::uint32_t>(boxes_.size()));
  }
}

std::uint32_t TumourDistance::build(std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t kLeaf = 8;
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity), begin, end, 0};
  for (std::uint32_t n = begin; n < end; ++n) {
    node.low = node.low.cwiseMin(boxes_[n].centre - boxes_[n].half);
    node.high = node.high.cwiseMax(boxes_[n].centre + boxes_[n].half);
  }
  nodes_.push_back(node);
  if (end - begin > kLeaf) {
    Eigen::Index axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(boxes_.begin() + begin, boxes_.begin() + middle, boxes_.begin() + end, [&](const Box& a, const Box& b) {
      return std::ranges::lexicographical_compare(std::array{a.centre[axis], a.centre[0], a.centre[1], a.centre[2]},
                                                  std::array{b.centre[axis], b.centre[0], b.centre[1], b.centre[2]});
    });
    build(begin, middle);
    const std::uint32_t right = build(middle, end);
    nodes_[index].right = right;
  }
  return index;
}

void TumourDistance::search(std::uint32_t index, const Vec3& point, Best& best) const {
  const Node& node = nodes_[index];
  if (node.right == 0) {
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      const Vec3 step = stepTo(point, boxes_[n].centre - boxes_[n].half, boxes_[n].centre + boxes_[n].half);
      if (step.squaredNorm() < best.squared) {
        best = {step.squaredNorm(), step, true};
      }
    }
    return;
  }
  std::array<std::uint32_t, 2> children{index + 1, node.right};
  std::array<double, 2> squared{};
  for (std::size_t n = 0; n < 2; ++n) {
    squared[n] = stepTo(point, nodes_[children[n]].low, nodes_[children[n]].high).squaredNorm();
  }
  if (squared[1] < squared[0]) {
    std::swap(children[0], children[1]);
    std::swap(squared[0], squared[1]);
  }
  for (std::size_t n = 0; n < 2; ++n) {
    if (squared[n] < best.squared) {
      search(children[n], point, best);
    }
  }
}

TumourDistance::Way TumourDistance::from(const Vec3& point, double within) const {
  if (empty()) {
    return {};
  }
  const Vec3 inImage = geometry_.direction.transpose() * (point - geometry_.origin);
  Best best{within * within, Vec3::Zero(), false};
  search(0, inImage, best);
  if (!best.found) {
    return {};
  }
  const double mm = std::sqrt(best.squared);
  return {mm, mm > kOnPlaneMm ? mm - resolutionMm(best.step / mm, geometry_.spacing) : mm};
}

MarginMap marginMap(const TumourDistance& tumours, const PlaneGrid& grid, double within, const BentSurface* bent) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  MarginMap map{grid, std::vector<TumourDistance::Way>(columns * static_cast<std::size_t>(grid.rows))};
  if (tumours.empty()) {
    return map;
  }
  parallelFor(static_cast<std::size_t>(grid.rows), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const Vec3 point = grid.origin + grid.stepMm * (static_cast<double>(column) * grid.u + static_cast<double>(row) * grid.v);
        map.ways[row * columns + column] = tumours.from(bent != nullptr ? bent->foot(point) : point, within);
      }
    }
  });
  return map;
}

}  // namespace glisson
