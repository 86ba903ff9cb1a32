#include "reconstruction/mesh/self_intersection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>
#include <tuple>

#include "reconstruction/mesh/predicates.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {
using Corners = std::array<const Vec3*, 3>;

int turn(const Corners& t, const Vec3& p) { return orientation(*t[0], *t[1], *t[2], p); }

/// The plane's two axes that keep the most of a triangle's area.
std::array<Eigen::Index, 2> flatAxes(const Corners& t) {
  Eigen::Index drop = 0;
  (*t[1] - *t[0]).cross(*t[2] - *t[0]).cwiseAbs().maxCoeff(&drop);
  return {(drop + 1) % 3, (drop + 2) % 3};
}

/// Points of one plane, seen along the axis that keeps it widest.
class Flat {
 public:
  explicit Flat(const Corners& t) : axes_(flatAxes(t)) {}
  [[nodiscard]] int turn(const Vec3& a, const Vec3& b, const Vec3& c) const { return orientation(at(a), at(b), at(c)); }
  /// Do the closed segments meet?
  [[nodiscard]] bool meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    const int c1 = turn(a, b, c);
    const int d1 = turn(a, b, d);
    const int a1 = turn(c, d, a);
    const int b1 = turn(c, d, b);
    if (c1 * d1 < 0 && a1 * b1 < 0) {
      return true;
    }
    return (c1 == 0 && between(a, b, c)) || (d1 == 0 && between(a, b, d)) || (a1 == 0 && between(c, d, a)) ||
           (b1 == 0 && between(c, d, b));
  }
  /// Does the closed triangle hold the point?
  [[nodiscard]] bool holds(const Corners& t, const Vec3& p) const {
    const int x = turn(*t[0], *t[1], p);
    const int y = turn(*t[1], *t[2], p);
    const int z = turn(*t[2], *t[0], p);
    return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
  }

 private:
  [[nodiscard]] Vec2 at(const Vec3& p) const { return {p[axes_[0]], p[axes_[1]]}; }
  [[nodiscard]] bool between(const Vec3& a, const Vec3& b, const Vec3& p) const {
    const Vec2 u = at(a);
    const Vec2 v = at(b);
    const Vec2 q = at(p);
    return (q.array() >= u.cwiseMin(v).array()).all() && (q.array() <= u.cwiseMax(v).array()).all();
  }
  std::array<Eigen::Index, 2> axes_;
};

/// Does the closed segment p-q meet the closed triangle?
bool meets(const Corners& t, const Vec3& p, const Vec3& q) {
  const int sideP = turn(t, p);
  const int sideQ = turn(t, q);
  if (sideP * sideQ > 0) {
    return false;
  }
  if (sideP == 0 && sideQ == 0) {
    const Flat flat(t);
    return flat.holds(t, p) || flat.holds(t, q) || flat.meet(p, q, *t[0], *t[1]) || flat.meet(p, q, *t[1], *t[2]) ||
           flat.meet(p, q, *t[2], *t[0]);
  }
  const int x = orientation(p, q, *t[0], *t[1]);
  const int y = orientation(p, q, *t[1], *t[2]);
  const int z = orientation(p, q, *t[2], *t[0]);
  return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

bool onOneSide(const Corners& t, const Corners& of) {
  const int first = turn(t, *of[0]);
  return first != 0 && turn(t, *of[1]) == first && turn(t, *of[2]) == first;
}

bool meetApart(const Corners& a, const Corners& b) {
  if (onOneSide(a, b) || onOneSide(b, a)) {
    return false;
  }
  for (std::size_t n = 0; n < 3; ++n) {
    if (meets(a, *b[n], *b[(n + 1) % 3]) || meets(b, *a[n], *a[(n + 1) % 3])) {
      return true;
    }
  }
  return false;
}

/// Triangles with the side u-v in common overlap where they are folded onto each other.
bool overlapAtSide(const Vec3& u, const Vec3& v, const Vec3& a, const Vec3& b) {
  if (orientation(u, v, a, b) != 0) {
    return false;
  }
  const Flat flat({&u, &v, &a});
  return flat.turn(u, v, a) == flat.turn(u, v, b);
}

class Checker {
 public:
  Checker(const SurfaceMesh& mesh, const ExecutionContext& context) : mesh_(mesh) {
    samePlace();
    context.throwIfCancelled();
    sortAlongCurve();
    context.throwIfCancelled();
    buildBoxes();
  }

  /// Pairs of all triangles, or of those marked with any others.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> pairs(const std::vector<std::uint8_t>& marked,
                                                                const ExecutionContext& context) const {
    std::vector<std::array<std::uint32_t, 2>> all;
    std::mutex mutex;
    parallelFor(order_.size(), 512, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      std::vector<std::array<std::uint32_t, 2>> found;
      for (std::size_t n = begin; n < end; ++n) {
        if (marked.empty()) {
          addPairs(n, n + 1, found);
        } else if (marked[order_[n]] != 0) {
          addPairs(n, 0, found);
        }
      }
      const std::lock_guard lock(mutex);
      all.insert(all.end(), found.begin(), found.end());
    });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
    void add(const Vec3& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    [[nodiscard]] bool meets(const Box& other) const {
      return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
  };

  /// Vertices at one place count as one: a vertex copied for each of its fans touches itself by right.
  void samePlace() {
    place_.resize(mesh_.vertices.size());
    std::vector<std::uint32_t> sorted(mesh_.vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      const Vec3& p = mesh_.vertices[a];
      const Vec3& q = mesh_.vertices[b];
      return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
    };
    std::sort(sorted.begin(), sorted.end(), before);
    for (std::size_t n = 0; n < sorted.size(); ++n) {
      const bool same = n > 0 && mesh_.vertices[sorted[n]] == mesh_.vertices[sorted[n - 1]];
      place_[sorted[n]] = same ? place_[sorted[n - 1]] : sorted[n];
    }
  }

  [[nodiscard]] Box boxOf(std::uint32_t triangle) const {
    Box box;
    for (const std::uint32_t corner : mesh_.triangles[triangle]) {
      box.add(mesh_.vertices[corner]);
    }
    return box;
  }

  /// Triangles along a Morton curve, so that neighbours in the list are neighbours in space.
  void sortAlongCurve() {
    Box all;
    for (const Vec3& v : mesh_.vertices) {
      all.add(v);
    }
    const double extent = std::max((all.high - all.low).maxCoeff(), std::numeric_limits<double>::min());
    const auto spread = [](std::uint64_t x) {
      x = (x | (x << 32U)) & 0x1f00000000ffffU;
      x = (x | (x << 16U)) & 0x1f0000ff0000ffU;
      x = (x | (x << 8U)) & 0x100f00f00f00f00fU;
      x = (x | (x << 4U)) & 0x10c30c30c30c30c3U;
      return (x | (x << 2U)) & 0x1249249249249249U;
    };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(mesh_.triangles.size());
    for (std::uint32_t n = 0; n < keys.size(); ++n) {
      const Box box = boxOf(n);
      const Vec3 at = (0.5 * (box.low + box.high) - all.low) / extent * 2097151.0;
      std::uint64_t key = 0;
      for (int axis = 0; axis < 3; ++axis) {
        key |= spread(static_cast<std::uint64_t>(std::clamp(at[axis], 0.0, 2097151.0))) << static_cast<unsigned>(axis);
      }
      keys[n] = {key, n};
    }
    std::sort(keys.begin(), keys.end());
    order_.reserve(keys.size());
    for (const auto& [key, n] : keys) {
      order_.push_back(n);
    }
  }

  /// Level 0: one box per triangle in order; every further level joins two.
  void buildBoxes() {
    levels_.emplace_back(order_.size());
    for (std::size_t n = 0; n < order_.size(); ++n) {
      levels_[0][n] = boxOf(order_[n]);
    }
    while (levels_.back().size() > 1) {
      const std::vector<Box>& fine = levels_.back();
      std::vector<Box> coarse((fine.size() + 1) / 2);
      for (std::size_t n = 0; n < fine.size(); ++n) {
        coarse[n / 2].add(fine[n].low);
        coarse[n / 2].add(fine[n].high);
      }
      levels_.push_back(std::move(coarse));
    }
  }

  /// Intersecting pairs of the n-th triangle in order with others from the `from`-th on.
  void addPairs(std::size_t n, std::size_t from, std::vector<std::array<std::uint32_t, 2>>& found) const {
    const Box& box = levels_[0][n];
    std::array<std::pair<std::size_t, std::size_t>, 128> stack;
    std::size_t top = 0;
    stack[top++] = {levels_.size() - 1, 0};
    while (top > 0) {
      const auto [level, at] = stack[--top];
      if (((at + 1) << level) <= from || !levels_[level][at].meets(box)) {
        continue;
      }
      if (level == 0) {
        if (at != n && intersect(order_[n], order_[at])) {
          found.push_back({std::min(order_[n], order_[at]), std::max(order_[n], order_[at])});
        }
        continue;
      }
      stack[top++] = {level - 1, 2 * at};
      if (2 * at + 1 < levels_[level - 1].size()) {
        stack[top++] = {level - 1, 2 * at + 1};
      }
    }
  }

  [[nodiscard]] bool intersect(std::uint32_t s, std::uint32_t t) const {
    const Triangle& a = mesh_.triangles[s];
    const Triangle& b = mesh_.triangles[t];
    std::array<std::size_t, 3> ofA{};
    std::array<std::size_t, 3> ofB{};
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (place_[a[i]] == place_[b[j]] && shared < 3) {
          ofA[shared] = i;
          ofB[shared++] = j;
        }
      }
    }
    const auto corner = [&](const Triangle& of, std::size_t n) -> const Vec3& { return mesh_.vertices[of[n % 3]]; };
    const Corners cornersA{&corner(a, 0), &corner(a, 1), &corner(a, 2)};
    const Corners cornersB{&corner(b, 0), &corner(b, 1), &corner(b, 2)};
    switch (shared) {
      case 0:
        return meetApart(cornersA, cornersB);
      case 1:
        // What they have in common beyond the corner reaches the side opposite to it in one of them.
        return meets(cornersA, corner(b, ofB[0] + 1), corner(b, ofB[0] + 2)) ||
               meets(cornersB, corner(a, ofA[0] + 1), corner(a, ofA[0] + 2));
      case 2:
        return overlapAtSide(corner(a, ofA[0]), corner(a, ofA[1]), corner(a, 3 - ofA[0] - ofA[1]), corner(b, 3 - ofB[0] - ofB[1]));
      default:
        return true;
    }
  }

  const SurfaceMesh& mesh_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Box>> levels_;
};
}  // namespace

std::vector<std::array<std::uint32_t, 2>> selfIntersections(const SurfaceMesh& mesh, const ExecutionContext& context) {
  if (mesh.triangles.size() < 2) {
    return {};
  }
  return Checker(mesh, context).pairs({}, context);
}

std::vector<std::array<std::uint32_t, 2>> selfIntersections(const SurfaceMesh& mesh, std::span<const std::uint32_t> among,
                                                            const ExecutionContext& context) {
  if (mesh.triangles.size() < 2) {
    return {};
  }
  std::vector<std::uint8_t> marked(mesh.triangles.size(), 0);
  for (const std::uint32_t triangle : among) {
    marked[triangle] = 1;
  }
  return Checker(mesh, context).pairs(marked, context);
}

std::size_t countSelfIntersections(const SurfaceMesh& mesh, const ExecutionContext& context) {
  return selfIntersections(mesh, context).size();
}

}  // namespace glisson
