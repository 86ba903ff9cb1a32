#include "reconstruction/mesh/centreline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>

namespace glisson {

namespace {
constexpr unsigned kCentre = 13;  // of 27 neighbours, n = x + 3 y + 9 z

constexpr std::array<int, 3> placeOf(unsigned n) {
  return {static_cast<int>(n % 3) - 1, static_cast<int>(n / 3 % 3) - 1, static_cast<int>(n / 9) - 1};
}

constexpr int stepsBetween(unsigned a, unsigned b) {
  const auto p = placeOf(a);
  const auto q = placeOf(b);
  int steps = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int d = p[axis] > q[axis] ? p[axis] - q[axis] : q[axis] - p[axis];
    steps += d > 1 ? 10 : d;
  }
  return steps;
}

/// For each of 27 places the places that touch it by at most `steps` axes (1: faces, 3: corners too).
constexpr std::array<std::uint32_t, 27> neighbourTable(int steps) {
  std::array<std::uint32_t, 27> table{};
  for (unsigned a = 0; a < 27; ++a) {
    for (unsigned b = 0; b < 27; ++b) {
      if (a != b && stepsBetween(a, b) <= steps) {
        table[a] |= 1U << b;
      }
    }
  }
  return table;
}

constexpr auto kBySix = neighbourTable(1);
constexpr auto kByEighteen = neighbourTable(2);
constexpr auto kByTwentySix = neighbourTable(3);

/// Of `set`, what is connected to its members in `start`.
std::uint32_t grown(std::uint32_t start, std::uint32_t set, const std::array<std::uint32_t, 27>& table) {
  std::uint32_t reached = start & set;
  std::uint32_t fresh = reached;
  while (fresh != 0) {
    std::uint32_t around = 0;
    for (; fresh != 0; fresh &= fresh - 1) {
      around |= table[static_cast<unsigned>(std::countr_zero(fresh))];
    }
    fresh = around & set & ~reached;
    reached |= fresh;
  }
  return reached;
}

/// Can the centre go without a change of topology? One piece of foreground (26) around it, one of background (6, within 18) at it.
bool isSimple(std::uint32_t foreground) {
  foreground &= ~(1U << kCentre);
  const std::uint32_t background = ~foreground & kByEighteen[kCentre];
  const std::uint32_t atFaces = background & kBySix[kCentre];
  if (foreground == 0 || atFaces == 0) {
    return false;
  }
  const auto lowest = [](std::uint32_t set) { return set & (~set + 1U); };
  return grown(lowest(foreground), foreground, kByTwentySix) == foreground &&
         (atFaces & ~grown(lowest(atFaces), background, kBySix)) == 0;
}

class Thinning {
 public:
  explicit Thinning(const Mask& mask) : box_(mask.box()), ni_(box_.size[0] + 2), nj_(box_.size[1] + 2) {
    const std::size_t count =
        static_cast<std::size_t>(ni_) * static_cast<std::size_t>(nj_) * static_cast<std::size_t>(box_.size[2] + 2);
    distance_.assign(count, 0);
    const std::uint8_t* in = mask.values().data();
    for (int k = 0; k < box_.size[2]; ++k) {
      for (int j = 0; j < box_.size[1]; ++j) {
        for (int i = 0; i < box_.size[0]; ++i) {
          if (*in++ != 0) {
            distance_[offset(i, j, k)] = std::numeric_limits<int>::max() / 2;
          }
        }
      }
    }
    for (unsigned n = 0; n < 27; ++n) {
      const auto [x, y, z] = placeOf(n);
      step_[n] = x + static_cast<std::ptrdiff_t>(ni_) * (y + static_cast<std::ptrdiff_t>(nj_) * z);
    }
    measure();
  }

  std::vector<Index3> run(const ExecutionContext& context) {
    present_.assign(distance_.size(), 0);
    std::vector<std::vector<std::size_t>> ofDistance;
    forAll([&](std::size_t at) {
      if (distance_[at] > 0) {
        present_[at] = 1;
        const auto d = static_cast<std::size_t>(distance_[at]);
        ofDistance.resize(std::max(ofDistance.size(), d + 1));
        ofDistance[d].push_back(at);
      }
    });
    for (std::size_t d = 0; d < ofDistance.size(); ++d) {
      context.throwIfCancelled();
      auto& waiting = ofDistance[d];
      for (std::size_t n = 0; n < waiting.size(); ++n) {
        const std::size_t at = waiting[n];
        if (present_[at] == 0 || !canGo(at)) {
          continue;
        }
        present_[at] = 0;
        for (const std::ptrdiff_t step : step_) {
          const std::size_t other = at + step;
          if (present_[other] != 0 && distance_[other] <= static_cast<int>(d)) {
            waiting.push_back(other);
          }
        }
      }
    }
    std::vector<Index3> voxels;
    forAll([&](std::size_t at) {
      if (present_[at] != 0) {
        const auto n = static_cast<long long>(at);
        voxels.push_back({static_cast<int>(n % ni_) - 1 + box_.first[0], static_cast<int>(n / ni_ % nj_) - 1 + box_.first[1],
                          static_cast<int>(n / ni_ / nj_) - 1 + box_.first[2]});
      }
    });
    return voxels;
  }

 private:
  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i + 1) +
           static_cast<std::size_t>(ni_) *
               (static_cast<std::size_t>(j + 1) + static_cast<std::size_t>(nj_) * static_cast<std::size_t>(k + 1));
  }

  /// Calls visit(place) for every voxel of the box, without its border.
  template <typename Visit>
  void forAll(Visit&& visit) const {
    for (int k = 0; k < box_.size[2]; ++k) {
      for (int j = 0; j < box_.size[1]; ++j) {
        const std::size_t row = offset(0, j, k);
        for (std::size_t at = row; at < row + static_cast<std::size_t>(box_.size[0]); ++at) {
          visit(at);
        }
      }
    }
  }

  [[nodiscard]] static int lengthOf(unsigned n) {
    constexpr std::array<int, 4> kLength{0, 3, 4, 5};
    return kLength[static_cast<std::size_t>(stepsBetween(n, kCentre))];
  }

  /// Chamfer distance to the background, forward and backward.
  void measure() {
    forAll([&](std::size_t at) {
      for (unsigned n = 0; n < kCentre && distance_[at] > 0; ++n) {
        distance_[at] = std::min(distance_[at], distance_[at + step_[n]] + lengthOf(n));
      }
    });
    for (int k = box_.size[2] - 1; k >= 0; --k) {
      for (int j = box_.size[1] - 1; j >= 0; --j) {
        for (int i = box_.size[0] - 1; i >= 0; --i) {
          const std::size_t at = offset(i, j, k);
          for (unsigned n = kCentre + 1; n < 27 && distance_[at] > 0; ++n) {
            distance_[at] = std::min(distance_[at], distance_[at + step_[n]] + lengthOf(n));
          }
        }
      }
    }
  }

  [[nodiscard]] bool isCentreOfMaximalBall(std::size_t at) const {
    for (unsigned n = 0; n < 27; ++n) {
      if (n != kCentre && distance_[at + step_[n]] >= distance_[at] + lengthOf(n)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool canGo(std::size_t at) const {
    std::uint32_t foreground = 0;
    for (unsigned n = 0; n < 27; ++n) {
      foreground |= static_cast<std::uint32_t>(present_[at + step_[n]]) << n;
    }
    const bool isEnd = std::popcount(foreground & ~(1U << kCentre)) == 1;
    return isSimple(foreground) && !(isEnd && isCentreOfMaximalBall(at));
  }

  IndexBox box_;
  int ni_;
  int nj_;
  std::array<std::ptrdiff_t, 27> step_{};
  std::vector<int> distance_;
  std::vector<std::uint8_t> present_;
};
}  // namespace

std::vector<Index3> centrelineOf(const Mask& mask, const ExecutionContext& context) {
  if (mask.empty()) {
    return {};
  }
  return Thinning(mask).run(context);
}

}  // namespace glisson
