#pragma once
// Purpose: finds the things of one row of voxels, along i, among many that are in order of their rows (by k, then j): parts of
// runs, pieces of a surface. In constant time, since a plan's numbers ask for every row's neighbours while its plane moves.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "planning/volumetry/voxel_rows.h"

namespace glisson {

class RowTable {
 public:
  RowTable() = default;
  /// `runOf(n)`: a run in the row of thing n, 0 <= n < count.
  template <typename RunOf>
  RowTable(std::size_t count, const RunOf& runOf) {
    if (count == 0) {
      return;
    }
    int lastJ = std::numeric_limits<int>::min();
    firstJ_ = std::numeric_limits<int>::max();
    for (std::size_t n = 0; n < count; ++n) {
      firstJ_ = std::min(firstJ_, runOf(n).j);
      lastJ = std::max(lastJ, runOf(n).j);
    }
    firstK_ = runOf(0).k;
    rows_ = lastJ - firstJ_ + 1;
    slices_ = runOf(count - 1).k - firstK_ + 1;
    begins_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(slices_) + 1, 0);
    for (std::size_t n = 0; n < count; ++n) {
      ++begins_[place(runOf(n).j, runOf(n).k) + 1];
    }
    for (std::size_t row = 1; row < begins_.size(); ++row) {
      begins_[row] += begins_[row - 1];
    }
  }

  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// Empty where there is nothing in that row.
  [[nodiscard]] Range row(int j, int k) const {
    if (j < firstJ_ || j >= firstJ_ + rows_ || k < firstK_ || k >= firstK_ + slices_) {
      return {};
    }
    return {begins_[place(j, k)], begins_[place(j, k) + 1]};
  }
  /// Calls visit(j, k, range) for every row that has something, in order.
  template <typename Visit>
  void forEachRow(const Visit& visit) const {
    for (int k = firstK_; k < firstK_ + slices_; ++k) {
      for (int j = firstJ_; j < firstJ_ + rows_; ++j) {
        const Range range = row(j, k);
        if (range.begin < range.end) {
          visit(j, k, range);
        }
      }
    }
  }

 private:
  [[nodiscard]] std::size_t place(int j, int k) const {
    return static_cast<std::size_t>(k - firstK_) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(j - firstJ_);
  }

  int firstJ_ = 0;
  int firstK_ = 0;
  int rows_ = 0;
  int slices_ = 0;
  std::vector<std::size_t> begins_;  ///< of each row, and the end of the last
};

}  // namespace glisson
