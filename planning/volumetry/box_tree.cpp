#include "planning/volumetry/box_tree.h"

#include <algorithm>
#include <numeric>

#include "planning/infinity.h"

namespace glisson {

namespace {
constexpr std::uint32_t kLeaf = 4;
}  // namespace

BoxTree::BoxTree(const std::vector<Vec3>& low, const std::vector<Vec3>& high) : order_(low.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!low.empty()) {
    build(low, high, 0, static_cast<std::uint32_t>(low.size()));
  }
}

std::uint32_t BoxTree::build(const std::vector<Vec3>& low, const std::vector<Vec3>& high, std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity), begin, end, 0};
  for (std::uint32_t n = begin; n < end; ++n) {
    node.low = node.low.cwiseMin(low[order_[n]]);
    node.high = node.high.cwiseMax(high[order_[n]]);
  }
  nodes_.push_back(node);
  if (end - begin > kLeaf) {
    Eigen::Index axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      const double ca = low[a][axis] + high[a][axis];
      const double cb = low[b][axis] + high[b][axis];
      return ca < cb || (ca == cb && a < b);
    });
    build(low, high, begin, middle);
    const std::uint32_t right = build(low, high, middle, end);
    nodes_[index].right = right;
  }
  return index;
}

}  // namespace glisson
