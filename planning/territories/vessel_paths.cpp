#include "planning/territories/vessel_paths.h"

#include <algorithm>
#include <queue>

#include "planning/infinity.h"
#include "planning/territories/place.h"
#include "planning/volumetry/inscribed_balls.h"

namespace glisson {

namespace {
constexpr double kCoverRadii = 2;   ///< a way covers this many of its radii around it,
constexpr double kCoverVoxels = 1;  ///< and this many of the longest edges of a voxel more
constexpr double kNearRadii = 0.5;  ///< a later way ends this near to it, instead of running beside it
using Voxels = std::vector<std::int32_t>;

/// The mask's voxels by number, and the numbers around one.
class VoxelList {
 public:
  VoxelList(const Mask& mask, const Vec3& spacing) : spacing_(spacing) {
    for (std::size_t a = 0; a < 3; ++a) {
      box_.first[a] = mask.box().first[a] - 1;
      box_.size[a] = mask.box().size[a] + 2;
    }
    numbers_.assign(box_.voxelCount(), -1);
    const IndexBox& inner = mask.box();
    std::size_t n = 0;
    for (int k = inner.first[2]; k < inner.first[2] + inner.size[2]; ++k) {
      for (int j = inner.first[1]; j < inner.first[1] + inner.size[1]; ++j) {
        for (int i = inner.first[0]; i < inner.first[0] + inner.size[0]; ++i, ++n) {
          if (mask.values()[n] != 0) {
            numbers_[offset({i, j, k})] = static_cast<std::int32_t>(voxels_.size());
            voxels_.push_back({i, j, k});
          }
        }
      }
    }
    for (int m = 0; m < 27; ++m) {
      const Index3 step{m % 3 - 1, m / 3 % 3 - 1, m / 9 - 1};
      steps_[static_cast<std::size_t>(m)] = step[0] + stride(1) * step[1] + stride(2) * step[2];
      lengths_[static_cast<std::size_t>(m)] = spacing.cwiseProduct(Vec3(step[0], step[1], step[2])).norm();
    }
  }

  [[nodiscard]] std::size_t count() const { return voxels_.size(); }
  [[nodiscard]] const Index3& voxel(std::int32_t n) const { return voxels_[at(n)]; }

  /// visit(number, mm) for the mask's voxels that touch voxel n.
  template <typename Visit>
  void forNeighbours(std::int32_t n, Visit&& visit) const {
    const auto here = static_cast<std::ptrdiff_t>(offset(voxels_[at(n)]));
    for (std::size_t m = 0; m < 27; ++m) {
      const std::int32_t other = numbers_[static_cast<std::size_t>(here + steps_[m])];
      if (m != 13 && other >= 0) {
        visit(other, lengths_[m]);
      }
    }
  }

  /// visit(number) for the mask's voxels within `mm` of voxel n.
  template <typename Visit>
  void forBall(std::int32_t n, double mm, Visit&& visit) const {
    const Index3& c = voxels_[at(n)];
    Index3 low{};
    Index3 high{};
    for (std::size_t a = 0; a < 3; ++a) {
      const double reach = mm / spacing_[static_cast<Eigen::Index>(a)];
      low[a] = std::max(box_.first[a], static_cast<int>(std::ceil(c[a] - reach)));
      high[a] = std::min(box_.first[a] + box_.size[a] - 1, static_cast<int>(std::floor(c[a] + reach)));
    }
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          const std::int32_t other = numbers_[offset({i, j, k})];
          if (other >= 0 && spacing_.cwiseProduct(Vec3(i - c[0], j - c[1], k - c[2])).squaredNorm() <= mm * mm) {
            visit(other);
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] std::ptrdiff_t stride(std::size_t axis) const {
    return axis == 1 ? box_.size[0] : static_cast<std::ptrdiff_t>(box_.size[0]) * box_.size[1];
  }
  [[nodiscard]] std::size_t offset(const Index3& v) const {
    return static_cast<std::size_t>(v[0] - box_.first[0] + stride(1) * (v[1] - box_.first[1]) + stride(2) * (v[2] - box_.first[2]));
  }

  Vec3 spacing_;
  IndexBox box_;
  std::vector<std::int32_t> numbers_;
  std::vector<Index3> voxels_;
  std::array<std::ptrdiff_t, 27> steps_{};
  std::array<double, 27> lengths_{};
};

class PathFinder {
 public:
  PathFinder(const VoxelList& list, std::vector<double> radii, const Vec3& spacing, const ExecutionContext& context)
      : list_(list),
        context_(context),
        radii_(std::move(radii)),
        voxelMm_(spacing.maxCoeff()),
        way_(list.count(), kInfinity),
        parent_(list.count(), -1),
        nearest_(list.count(), -1),
        covered_(list.count(), 0) {}

  std::vector<PathVoxel> run() {
    for (std::int32_t seed = 0; at(seed) < list_.count(); ++seed) {
      if (way_[at(seed)] == kInfinity) {
        context_.throwIfCancelled();
        takePiece(seed);
      }
    }
    return std::move(made_);
  }

 private:
  void takePiece(std::int32_t seed) {
    Voxels piece = spread(seed, false);
    const std::int32_t root = piece.back();
    forget(piece);
    piece = spread(root, false);  // nearest first
    Voxels order(piece.rbegin(), piece.rend());
    forget(piece);
    spread(root, true);
    cover(root, add(root, -1));
    for (const std::int32_t far : order) {
      if (covered_[at(far)] == 0) {
        takeWay(far);
      }
    }
  }

  /// All voxels of the piece, nearest first: by length, or by cost, which also sets the parents.
  Voxels spread(std::int32_t from, bool byCost) {
    using WayTo = std::pair<double, std::int32_t>;
    std::priority_queue<WayTo, std::vector<WayTo>, std::greater<>> open;
    Voxels order;
    way_[at(from)] = 0;
    parent_[at(from)] = -1;
    open.emplace(0.0, from);
    while (!open.empty()) {
      const double way = open.top().first;
      const std::int32_t n = open.top().second;  // not a structured binding: captured below
      open.pop();
      if (way > way_[at(n)]) {
        continue;
      }
      order.push_back(n);
      if (order.size() % 65536 == 0) {
        context_.throwIfCancelled();
      }
      list_.forNeighbours(n, [&](std::int32_t other, double mm) {
        const double radius = radii_[at(other)];
        const double next = way_[at(n)] + (byCost ? mm / (radius * radius * radius) : mm);
        if (next < way_[at(other)]) {
          way_[at(other)] = next;
          parent_[at(other)] = n;
          open.emplace(next, other);
        }
      });
    }
    return order;
  }

  void forget(const Voxels& piece) {
    for (const std::int32_t n : piece) {
      way_[at(n)] = kInfinity;
    }
  }

  void takeWay(std::int32_t far) {
    Voxels way;
    std::int32_t n = far;
    while (nearest_[at(n)] < 0) {
      way.push_back(n);
      n = parent_[at(n)];
    }
    std::int32_t last = nearest_[at(n)];
    for (auto step = way.rbegin(); step != way.rend(); ++step) {
      last = add(*step, last);
    }
    for (auto step = way.rbegin(); step != way.rend(); ++step) {
      cover(*step, last - static_cast<std::int32_t>(way.size()) + 1 + static_cast<std::int32_t>(step - way.rbegin()));
    }
  }

  std::int32_t add(std::int32_t n, std::int32_t parent) {
    made_.push_back({list_.voxel(n), radii_[at(n)], parent});
    return static_cast<std::int32_t>(made_.size()) - 1;
  }

  void cover(std::int32_t n, std::int32_t number) {
    list_.forBall(n, kCoverRadii * radii_[at(n)] + kCoverVoxels * voxelMm_, [&](std::int32_t other) { covered_[at(other)] = 1; });
    list_.forBall(n, std::max(kNearRadii * radii_[at(n)], voxelMm_),
                  [&](std::int32_t other) { nearest_[at(other)] = nearest_[at(other)] < 0 ? number : nearest_[at(other)]; });
    nearest_[at(n)] = number;
  }

  const VoxelList& list_;
  const ExecutionContext& context_;
  std::vector<double> radii_;
  double voxelMm_;
  std::vector<double> way_;
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> nearest_;  ///< number in made_ of the way's voxel that a later way ends at
  std::vector<std::uint8_t> covered_;
  std::vector<PathVoxel> made_;
};
}  // namespace

std::vector<PathVoxel> vesselPaths(const Mask& vessel, const Vec3& spacing, const ExecutionContext& context) {
  context.throwIfCancelled();
  if (vessel.empty()) {
    return {};
  }
  const VoxelList list(vessel, spacing);
  return PathFinder(list, inscribedRadii(vessel, spacing, context), spacing, context).run();
}

}  // namespace glisson
