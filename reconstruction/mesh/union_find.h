#pragma once
// Purpose: disjoint sets over 0..n-1 (path halving, the smaller number is the root, so that results do not depend on the order).

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace glisson {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }
  std::uint32_t find(std::uint32_t n) {
    while (parent_[n] != n) {
      parent_[n] = parent_[parent_[n]];
      n = parent_[n];
    }
    return n;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }
  [[nodiscard]] bool isRoot(std::uint32_t n) const { return parent_[n] == n; }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// The set of every element, numbered 0..count-1 by first element.
  std::vector<std::uint32_t> numbered(std::uint32_t& count) {
    std::vector<std::uint32_t> number(parent_.size());
    count = 0;
    for (std::uint32_t n = 0; n < number.size(); ++n) {
      number[n] = isRoot(n) ? count++ : number[find(n)];
    }
    return number;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace glisson
