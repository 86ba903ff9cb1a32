#include "reconstruction/methods/point_tree.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace glisson {

namespace {
constexpr std::uint32_t kLeaf = 12;
}

PointTree::PointTree(std::span<const Vec3> points) : points_(points.begin(), points.end()), order_(points.size()) {
  if (points.empty()) {
    throw std::invalid_argument("PointTree: no points");
  }
  std::iota(order_.begin(), order_.end(), 0U);
  build(0, static_cast<std::uint32_t>(points.size()));
}

double PointTree::Node::squaredDistance(const Vec3& at) const { return (at - at.cwiseMax(low).cwiseMin(high)).squaredNorm(); }

void PointTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t place = nodes_.size();
  Node node{points_[order_[begin]], points_[order_[begin]], begin, end, 0};
  for (std::uint32_t n = begin; n < end; ++n) {
    node.low = node.low.cwiseMin(points_[order_[n]]);
    node.high = node.high.cwiseMax(points_[order_[n]]);
  }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) {
    return;
  }
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  // By place where the coordinates are the same: on a grid many are, and the halves have to be the same on every machine.
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
  };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, before);
  build(begin, middle);
  nodes_[place].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

void PointTree::nearest(const Vec3& at, std::size_t count, std::vector<std::uint32_t>& found) const {
  using Candidate = std::pair<double, std::uint32_t>;
  std::vector<Candidate> best;  // a heap, the worst on top
  best.reserve(count + 1);
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t place = open.back();
    open.pop_back();
    const Node& node = nodes_[place];
    if (best.size() == count && node.squaredDistance(at) > best.front().first) {
      continue;
    }
    if (node.right != 0) {
      const bool rightFirst = nodes_[node.right].squaredDistance(at) < nodes_[place + 1].squaredDistance(at);
      open.push_back(rightFirst ? place + 1 : node.right);
      open.push_back(rightFirst ? node.right : place + 1);
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      best.emplace_back((points_[order_[n]] - at).squaredNorm(), order_[n]);
      std::push_heap(best.begin(), best.end());
      if (best.size() > count) {
        std::pop_heap(best.begin(), best.end());
        best.pop_back();
      }
    }
  }
  std::sort_heap(best.begin(), best.end());
  found.clear();
  for (const Candidate& candidate : best) {
    found.push_back(candidate.second);
  }
}

void PointTree::within(const Vec3& centre, double radius, std::vector<std::uint32_t>& found) const {
  found.clear();
  const double squared = radius * radius;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t place = open.back();
    open.pop_back();
    const Node& node = nodes_[place];
    if (node.squaredDistance(centre) >= squared) {
      continue;
    }
    if (node.right != 0) {
      open.push_back(node.right);
      open.push_back(place + 1);
      continue;
    }
    for (std::uint32_t n = node.begin; n < node.end; ++n) {
      if ((points_[order_[n]] - centre).squaredNorm() < squared) {
        found.push_back(order_[n]);
      }
    }
  }
}

}  // namespace glisson
