#include "reconstruction/sample/vessel_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

namespace glisson::sample {

namespace {

constexpr double kTreeGapMm = 3.4;    // above a voxel's diagonal at 2.5 mm slices: the masks cannot touch
constexpr double kTumourGapMm = 3.2;  // likewise
constexpr double kCapsuleMm = 4.0;    // vessels end below the liver's surface
constexpr double kStepMm = 1.5;
constexpr int kAttempts = 48;

/// splitmix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// In [-1, 1).
  double next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * (2.0 / 9007199254740992.0) - 1.0;
  }
  Vec3 vector() {
    const double x = next();
    const double y = next();
    const double z = next();
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

using Points = std::vector<Vec3>;

/// A branch that may divide, with the part of the liver it feeds.
struct Tip {
  int branch = 0;
  Points territory;
};

struct Growing {
  VesselTree tree;
  std::deque<Tip> tips;
};

Points pointsInLiver() {
  Points points;
  for (int k = -80; k <= 80; k += 5) {
    for (int j = -80; j <= 80; j += 5) {
      for (int i = -130; i <= 100; i += 5) {
        const Vec3 p(i, j, k);
        if (liverDistance(p) < -5) {
          points.push_back(p);
        }
      }
    }
  }
  return points;
}

Vec3 meanOf(const Points& points) {
  double x = 0;
  double y = 0;
  double z = 0;
  for (const Vec3& p : points) {
    x += p[0];
    y += p[1];
    z += p[2];
  }
  const auto n = static_cast<double>(points.size());
  return {x / n, y / n, z / n};
}

Vec3 unit(const Vec3& v) { return v / std::max(length3(v), 1e-9); }

/// The direction across `axis` in which the points spread most (power iteration on their covariance).
Vec3 spreadAcross(const Points& points, const Vec3& centre, const Vec3& axis) {
  double c[6] = {0, 0, 0, 0, 0, 0};
  for (const Vec3& p : points) {
    const Vec3 d0 = p - centre;
    const double t = dot3(d0, axis);
    const Vec3 d(d0[0] - t * axis[0], d0[1] - t * axis[1], d0[2] - t * axis[2]);
    c[0] += d[0] * d[0];
    c[1] += d[0] * d[1];
    c[2] += d[0] * d[2];
    c[3] += d[1] * d[1];
    c[4] += d[1] * d[2];
    c[5] += d[2] * d[2];
  }
  Vec3 v = unit(Vec3(0.61, -0.53, 0.59));
  for (int n = 0; n < 24; ++n) {
    const double x = (c[0] * v[0] + c[1] * v[1]) + c[2] * v[2];
    const double y = (c[1] * v[0] + c[3] * v[1]) + c[4] * v[2];
    const double z = (c[2] * v[0] + c[4] * v[1]) + c[5] * v[2];
    v = unit(Vec3(x, y, z));
  }
  return v;
}

Vec3 along(const Capsule& c, double t) {
  return {c.from[0] + t * (c.to[0] - c.from[0]), c.from[1] + t * (c.to[1] - c.from[1]), c.from[2] + t * (c.to[2] - c.from[2])};
}

/// A place of the axis is free: inside the liver, clear of the tumours and of the other tree.
bool isFree(const Vec3& p, double radius, const VesselTree& other) {
  if (liverDistance(p) > -(radius + kCapsuleMm)) {
    return false;
  }
  for (const Ellipsoid& tumour : tumours()) {
    if (signedDistance(tumour, p) < radius + kTumourGapMm) {
      return false;
    }
  }
  return std::none_of(other.branches.begin(), other.branches.end(),
                      [&](const Branch& branch) { return signedDistance(branch.shape, p) < radius + kTreeGapMm; });
}

/// Where it has left its parent, the branch is free, and clear of its own tree but for the branches that begin where it does.
bool fits(const Capsule& shape, int parent, const VesselTree& own, const VesselTree& other) {
  const double length = length3(shape.to - shape.from);
  const int steps = std::max(2, static_cast<int>(length / kStepMm) + 1);
  const double leave = own.branches[static_cast<std::size_t>(parent)].shape.toRadius + shape.fromRadius + 1.0;
  for (int n = 1; n <= steps; ++n) {
    const double t = static_cast<double>(n) / steps;
    const Vec3 p = along(shape, t);
    const double radius = shape.fromRadius + t * (shape.toRadius - shape.fromRadius);
    if (!isFree(p, radius, other)) {
      return false;
    }
    if (t * length < leave) {
      continue;
    }
    for (std::size_t b = 0; b < own.branches.size(); ++b) {
      const bool family = static_cast<int>(b) == parent || own.branches[b].parent == parent;
      if (signedDistance(own.branches[b].shape, p) < radius + (family ? 0.4 : kTreeGapMm)) {
        return false;
      }
    }
  }
  return true;
}

int addBranch(VesselTree& tree, const Capsule& shape, int parent, int generation) {
  tree.branches.push_back({shape, parent, generation});
  return static_cast<int>(tree.branches.size()) - 1;
}

/// Tries to place a child that feeds `territory`; returns its index or -1.
int placeChild(VesselTree& own, const VesselTree& other, int parent, const Points& territory, double radius, Random& random) {
  const Branch from = own.branches[static_cast<std::size_t>(parent)];
  const Vec3 start = from.shape.to;
  const Vec3 way = meanOf(territory) - start;
  const double reach = length3(way);
  const double shortest = std::max(7.0, 2.4 * from.shape.toRadius + 2.0);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const double share = 0.62 - 0.006 * attempt;
    const double wanted = std::clamp(share * reach, shortest, 36.0);
    const double jitter = 0.08 + 0.022 * attempt;
    const Vec3 shake = random.vector();
    const Vec3 towards = unit(way);
    const Vec3 aim = unit(Vec3(towards[0] + jitter * shake[0], towards[1] + jitter * shake[1], towards[2] + jitter * shake[2]));
    const Vec3 end(start[0] + wanted * aim[0], start[1] + wanted * aim[1], start[2] + wanted * aim[2]);
    const Capsule shape{start, end, std::min(radius * 1.06, from.shape.toRadius), radius};
    if (fits(shape, parent, own, other)) {
      return addBranch(own, shape, parent, from.generation + 1);
    }
  }
  return -1;
}

/// Divides the oldest tip: its territory is halved and each half gets a branch.
void growOne(Growing& growing, const VesselTree& other, double tipRadius, Random& random) {
  const Tip tip = std::move(growing.tips.front());
  growing.tips.pop_front();
  const Branch from = growing.tree.branches[static_cast<std::size_t>(tip.branch)];
  if (tip.territory.size() < 2) {
    return;
  }
  const Vec3 centre = meanOf(tip.territory);
  const Vec3 axis = unit(centre - from.shape.to);
  const Vec3 across = spreadAcross(tip.territory, centre, axis);
  Points halves[2];
  for (const Vec3& p : tip.territory) {
    halves[dot3(p - centre, across) < 0 ? 0 : 1].push_back(p);
  }
  for (const Points& half : halves) {
    if (half.empty()) {
      continue;
    }
    const double share = static_cast<double>(half.size()) / static_cast<double>(tip.territory.size());
    // Cube root by Newton's method: std::cbrt may differ in its last bit between machines.
    double root = 0.8;
    for (int n = 0; n < 6; ++n) {
      root = root - (root * root * root - share) / (3 * root * root);
    }
    const double radius = from.shape.toRadius * root;
    if (radius < 0.88 * tipRadius) {
      continue;
    }
    const int child = placeChild(growing.tree, other, tip.branch, half, std::max(radius, tipRadius), random);
    if (child >= 0 && radius > tipRadius) {
      growing.tips.push_back({child, half});
    }
  }
}

/// Deals the liver's points to the tree's tips by distance.
void dealTerritories(Growing& growing, const Points& points) {
  for (const Vec3& p : points) {
    const auto distanceTo = [&](const Tip& tip) {
      return signedDistance(growing.tree.branches[static_cast<std::size_t>(tip.branch)].shape, p);
    };
    std::min_element(growing.tips.begin(), growing.tips.end(), [&](const Tip& a, const Tip& b) {
      return distanceTo(a) < distanceTo(b);
    })->territory.push_back(p);
  }
}

Growing portalRoots() {
  Growing portal;
  VesselTree& tree = portal.tree;
  const int trunk = addBranch(tree, {{14, 26, -50}, {-16, 12, -10}, 6.8, 6.4}, -1, 0);
  const int right = addBranch(tree, {{-16, 12, -10}, {-44, 8, -4}, 5.4, 5.1}, trunk, 1);
  const int left = addBranch(tree, {{-16, 12, -10}, {-4, -18, 6}, 4.8, 4.6}, trunk, 1);
  const int umbilical = addBranch(tree, {{-4, -18, 6}, {10, -34, 24}, 4.6, 4.3}, left, 1);
  portal.tips = {{right, {}}, {umbilical, {}}};
  return portal;
}

Growing hepaticRoots() {
  Growing hepatic;
  VesselTree& tree = hepatic.tree;
  const int cava = addBranch(tree, cavaStump(), -1, 0);
  const Vec3 mouth(-8, 43, 34);
  const int right = addBranch(tree, {mouth, {-42, 22, 36}, 5.6, 5.2}, cava, 1);
  const int common = addBranch(tree, {mouth, {-10, 4, 42}, 5.8, 5.4}, cava, 1);
  const int middle = addBranch(tree, {{-10, 4, 42}, {-34, -14, 34}, 4.7, 4.5}, common, 2);
  const int left = addBranch(tree, {{-10, 4, 42}, {14, -24, 38}, 4.4, 4.2}, common, 2);
  hepatic.tips = {{right, {}}, {middle, {}}, {left, {}}};
  return hepatic;
}

}  // namespace

std::vector<Vec3> VesselTree::branchPoints() const {
  std::vector<int> children(branches.size(), 0);
  std::vector<Vec3> starts(branches.size(), Vec3::Zero());
  for (const Branch& branch : branches) {
    if (branch.parent >= 0) {
      const auto parent = static_cast<std::size_t>(branch.parent);
      ++children[parent];
      starts[parent] = branch.shape.from;
    }
  }
  std::vector<Vec3> points;
  for (std::size_t b = 0; b < branches.size(); ++b) {
    if (children[b] >= 2) {
      points.push_back(starts[b]);
    }
  }
  return points;
}

int VesselTree::generations() const {
  std::vector<int> children(branches.size(), 0);
  for (const Branch& branch : branches) {
    if (branch.parent >= 0) {
      ++children[static_cast<std::size_t>(branch.parent)];
    }
  }
  int most = 0;
  std::vector<int> passed(branches.size(), 0);
  for (std::size_t b = 0; b < branches.size(); ++b) {
    if (branches[b].parent >= 0) {
      const auto parent = static_cast<std::size_t>(branches[b].parent);
      passed[b] = passed[parent] + (children[parent] >= 2 ? 1 : 0);
    }
    most = std::max(most, passed[b]);
  }
  return most;
}

double VesselTree::distance(const Vec3& p) const {
  double d = 1e30;
  for (const Branch& branch : branches) {
    d = std::min(d, signedDistance(branch.shape, p));
  }
  return d;
}

VesselTrees growVessels(double tipRadiusMm) {
  const Points points = pointsInLiver();
  Growing portal = portalRoots();
  Growing hepatic = hepaticRoots();
  dealTerritories(portal, points);
  dealTerritories(hepatic, points);
  Random random(0x61155061);
  // In turns, so that both trees reach everywhere.
  while (!portal.tips.empty() || !hepatic.tips.empty()) {
    if (!portal.tips.empty()) {
      growOne(portal, hepatic.tree, tipRadiusMm, random);
    }
    if (!hepatic.tips.empty()) {
      growOne(hepatic, portal.tree, tipRadiusMm, random);
    }
  }
  return {std::move(portal.tree), std::move(hepatic.tree)};
}

}  // namespace glisson::sample
