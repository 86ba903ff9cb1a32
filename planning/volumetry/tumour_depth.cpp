#include "planning/volumetry/tumour_depth.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "planning/infinity.h"
#include "planning/volumetry/convex_projection.h"

namespace glisson {

namespace {

/// What the distance of a point outside to the surface surely does not pass: that of a point of it, where the plane that touches it
/// over the point would be met.
double mostDepth(const Vec3& p, const BentSurface& surface) {
  const HalfSpace touching = surface.tangentAt(p);
  const Vec3 on = surface.foot(p - touching.normal.dot(p - touching.origin) * touching.normal);
  return std::min(-surface.above(p), (on - p).norm());
}

/// Where to begin: the nearest of the surface's points around the point under or over `p`.
Vec3 nearestSample(const Vec3& p, const BentSurface& surface) {
  constexpr int kSteps = 6;
  const Vec3 under = surface.foot(p);
  const double radius = (under - p).norm();
  Vec3 nearest = under;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Vec3 q = surface.foot(p + radius / kSteps * (i * surface.u() + j * surface.v()));
      if ((q - p).squaredNorm() < (nearest - p).squaredNorm()) {
        nearest = q;
      }
    }
  }
  return nearest;
}

/// The same for a resection with bent planes: each is taken as the plane that touches it where the last step ended.
void keepBentProjection(const Vec3& p, const ImageResection& resection, double& best, Vec3& normal) {
  std::vector<Vec3> feet;
  bool inside =
      std::all_of(resection.planes.begin(), resection.planes.end(), [&](const ImagePlane& f) { return f.distance(p) >= 0; });
  for (const BentSurface& surface : resection.bends) {
    inside = inside && surface.above(p) >= 0;
    feet.push_back(nearestSample(p, surface));
  }
  if (inside) {
    best = 0;
    return;
  }
  constexpr int kTurns = 30;
  constexpr double kSettledMm = 1e-4;
  const Vec3 start = feet[0];
  double depth = kInfinity;
  Vec3 along = Vec3::UnitZ();
  double largest = 0;
  Vec3 alongLargest = along;
  for (int turn = 0; turn < kTurns; ++turn) {
    std::vector<ImagePlane> planes = resection.planes;
    for (std::size_t n = 0; n < feet.size(); ++n) {
      const HalfSpace touching = resection.bends[n].tangentAt(feet[n]);
      planes.push_back({touching.normal, -touching.normal.dot(touching.origin)});
    }
    const double before = depth;
    depth = kInfinity;
    if (planes.size() == 1) {
      depth = std::max(0.0, -planes[0].distance(p));
      along = planes[0].normal;
    } else {
      keepProjection(p, planes, depth, along);
    }
    if (std::isfinite(depth) && depth > largest) {
      largest = depth;
      alongLargest = along;
    }
    if (!std::isfinite(depth) || std::abs(depth - before) < kSettledMm) {
      break;
    }
    for (std::size_t n = 0; n < feet.size(); ++n) {
      feet[n] = resection.bends[n].foot(p + depth * along);
    }
  }
  if (!(largest > 0)) {
    // No turn has found a way: the deepest of the single planes, along its normal.
    for (const BentSurface& surface : resection.bends) {
      if (-surface.above(p) > largest) {
        largest = -surface.above(p);
        alongLargest = surface.normal();
      }
    }
    for (const ImagePlane& plane : resection.planes) {
      if (-plane.distance(p) > largest) {
        largest = -plane.distance(p);
        alongLargest = plane.normal;
      }
    }
  }
  if (resection.planes.empty() && resection.bends.size() == 1) {
    largest = std::min({largest, (start - p).norm(), mostDepth(p, resection.bends[0])});  // to points of the surface
  }
  if (largest < best) {
    best = largest;
    normal = alongLargest;
  }
}

/// The distance of a point to one resection and the direction to it, where it is less than `depth`.
void keepDepth(const Vec3& p, const ImageResection& resection, double& depth, Vec3& along) {
  if (!resection.bends.empty()) {
    keepBentProjection(p, resection, depth, along);
  } else if (resection.planes.size() == 1) {
    const double outside = std::max(0.0, -resection.planes[0].distance(p));
    if (outside < depth) {
      depth = outside;
      along = resection.planes[0].normal;
    }
  } else if (!resection.planes.empty()) {
    keepProjection(p, resection.planes, depth, along);
  }
}

/// The distance of a point to the resected region, and the direction to it.
double depthOf(const Vec3& p, const std::vector<ImageResection>& plan, Vec3& along) {
  double depth = kInfinity;
  for (const ImageResection& resection : plan) {
    keepDepth(p, resection, depth, along);
  }
  return depth;
}

/// What bounds the depth of a point without a projection: a single bent plane is no farther than along its normal, or than what
/// `finely` tells.
double mostDepth(const Vec3& p, const std::vector<ImageResection>& plan, bool finely) {
  double most = kInfinity;
  for (const ImageResection& resection : plan) {
    if (resection.planes.empty() && resection.bends.size() == 1) {
      most = std::min(most, finely ? mostDepth(p, resection.bends[0]) : -resection.bends[0].above(p));
    }
  }
  return most;
}

/// The greatest depth of a box under several half-spaces, exactly: the least of linear functions is greatest at a corner, or where
/// two of them are equal on an edge, three on a face, four inside.
class HalfSpaceDepth {
 public:
  explicit HalfSpaceDepth(std::vector<ImagePlane> planes) : planes_(std::move(planes)) {}

  void keep(const Box& box) {
    std::array<std::size_t, 4> chosen{};
    choose(box, chosen, 0, 0);
  }
  /// What no point of the box is deeper than.
  [[nodiscard]] double most(const Box& box) const {
    double least = kInfinity;
    for (const ImagePlane& plane : planes_) {
      least = std::min(least, outside(plane, box.centre) + plane.support(box.half));
    }
    return least;
  }
  [[nodiscard]] double greatest() const { return greatest_; }
  [[nodiscard]] const Vec3& along() const { return along_; }

 private:
  [[nodiscard]] static double outside(const ImagePlane& plane, const Vec3& p) { return -plane.distance(p); }

  /// All sets of one to four planes from the `from`-th on, and all edges and faces they may be equal on.
  void choose(const Box& box, std::array<std::size_t, 4>& chosen, std::size_t count, std::size_t from) {
    for (std::size_t n = from; n < planes_.size() && count < chosen.size(); ++n) {
      chosen[count] = n;
      meet(box, std::span(chosen).first(count + 1));
      choose(box, chosen, count + 1, n + 1);
    }
  }

  /// The planes of `equal` have one distance there; one coordinate less than planes is free, the others lie on the box's sides.
  void meet(const Box& box, std::span<const std::size_t> equal) {
    const std::size_t freeAxes = equal.size() - 1;
    for (unsigned mask = 0; mask < 8; ++mask) {
      if (static_cast<std::size_t>(std::popcount(mask)) != freeAxes) {
        continue;
      }
      for (unsigned sides = 0; sides < 8; ++sides) {
        if ((sides & mask) == 0) {
          meetAt(box, equal, mask, sides);
        }
      }
    }
  }

  void meetAt(const Box& box, std::span<const std::size_t> equal, unsigned mask, unsigned sides) {
    Vec3 p = cornerOf(box, sides);
    std::array<Eigen::Index, 3> axes{};
    std::size_t count = 0;
    for (Eigen::Index a = 0; a < 3; ++a) {
      if ((mask >> static_cast<unsigned>(a) & 1U) != 0) {
        axes[count++] = a;
        p[a] = box.centre[a];
      }
    }
    Mat3 system = Mat3::Identity();
    Vec3 right = Vec3::Zero();
    for (std::size_t n = 0; n < count; ++n) {
      const ImagePlane& one = planes_[equal[0]];
      const ImagePlane& other = planes_[equal[n + 1]];
      const auto row = static_cast<Eigen::Index>(n);
      for (std::size_t m = 0; m < count; ++m) {
        system(row, static_cast<Eigen::Index>(m)) = one.normal[axes[m]] - other.normal[axes[m]];
      }
      right[row] = outside(one, p) - outside(other, p);  // moving p along the free axes takes this away
    }
    const double determinant = system.determinant();
    if (std::abs(determinant) < 1e-12) {
      return;  // side by side there: what is greatest is met on other sides
    }
    const Vec3 move = system.inverse() * right;
    for (std::size_t n = 0; n < count; ++n) {
      p[axes[n]] += move[static_cast<Eigen::Index>(n)];
    }
    constexpr double kRoundingMm = 1e-9;
    if (((p - box.centre).cwiseAbs() - box.half).maxCoeff() > kRoundingMm) {
      return;
    }
    double depth = kInfinity;
    Vec3 along = Vec3::UnitZ();
    for (const ImagePlane& plane : planes_) {
      if (outside(plane, p) < depth) {
        depth = outside(plane, p);
        along = plane.normal;
      }
    }
    if (depth > greatest_) {
      greatest_ = depth;
      along_ = along;
    }
  }

  std::vector<ImagePlane> planes_;
  double greatest_ = 0;
  Vec3 along_ = Vec3::UnitZ();
};

/// The greatest depth under several resections: the distance to their union is the least of convex functions and can be greatest
/// inside a box, between its corners. Each of them is greatest at a corner, so the least of those bounds a box's depth; boxes that
/// may be deeper than what is known are halved.
class UnionDepth {
 public:
  explicit UnionDepth(const std::vector<ImageResection>& plan) {
    std::copy_if(plan.begin(), plan.end(), std::back_inserter(plan_),
                 [](const ImageResection& one) { return !one.takesNothing(); });
  }

  void keepCorners(const Box& box) { static_cast<void>(axisToHalve(box)); }
  void keep(const Box& whole) {
    std::vector<Box> open{whole};
    while (!open.empty()) {
      const Box box = open.back();
      open.pop_back();
      const std::optional<Eigen::Index> deeper = axisToHalve(box);
      if (!deeper) {
        continue;
      }
      const Eigen::Index axis = *deeper;
      const Vec3 half = box.half - 0.5 * box.half[axis] * Vec3::Unit(axis);
      for (const double side : {-0.5, 0.5}) {
        open.push_back({box.centre + side * box.half[axis] * Vec3::Unit(axis), half});
      }
    }
  }
  [[nodiscard]] double greatest() const { return greatest_; }
  [[nodiscard]] const Vec3& along() const { return along_; }

 private:
  static constexpr double kFineMm = 0.05;

  /// The axis along which the depths change most, where the box may reach deeper than what is known; its corners are part of that
  /// then. Faces that run side by side leave a whole plane at the greatest depth: along it nothing is to be halved.
  std::optional<Eigen::Index> axisToHalve(const Box& box) {
    std::array<Vec3, 8> corners;
    for (unsigned c = 0; c < corners.size(); ++c) {
      corners[c] = cornerOf(box, c);
    }
    const auto passes = [&](const auto& depthAt) {
      double most = 0;
      for (std::size_t c = 0; c < corners.size() && most <= greatest_ + kFineMm; ++c) {
        most = std::max(most, depthAt(c));
      }
      return most > greatest_ + kFineMm;
    };
    for (const ImageResection& one : plan_) {
      if (one.planes.empty() && one.bends.size() == 1 && !passes([&](std::size_t c) { return -one.bends[0].above(corners[c]); })) {
        return std::nullopt;
      }
    }
    std::array<double, 8> depths;
    std::array<Vec3, 8> directions;
    depths.fill(kInfinity);
    directions.fill(Vec3::UnitZ());
    constexpr double kShareOfLength = 0.16;  // what is as deep at both ends of a box may be less deep between them
    Vec3 changes = kShareOfLength * box.half;
    for (const ImageResection& one : plan_) {
      double most = 0;
      Vec3 change = Vec3::Zero();
      for (std::size_t c = 0; c < corners.size(); ++c) {
        double depth = kInfinity;
        Vec3 direction = Vec3::UnitZ();
        keepDepth(corners[c], one, depth, direction);
        most = std::max(most, depth);
        for (Eigen::Index a = 0; a < 3 && std::isfinite(depth); ++a) {
          change[a] += (c >> static_cast<std::size_t>(a) & 1U) != 0 ? depth : -depth;
        }
        if (depth < depths[c]) {
          depths[c] = depth;
          directions[c] = direction;
        }
      }
      if (most <= greatest_ + kFineMm) {
        return std::nullopt;
      }
      changes += change.cwiseAbs();
    }
    bool finite = false;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      finite = finite || std::isfinite(depths[c]);
      if (std::isfinite(depths[c]) && depths[c] > greatest_) {
        greatest_ = depths[c];
        along_ = directions[c];
      }
    }
    Eigen::Index axis = 0;
    changes.maxCoeff(&axis);
    return finite ? std::optional(axis) : std::nullopt;
  }

  std::vector<ImageResection> plan_;
  double greatest_ = 0;
  Vec3 along_ = Vec3::UnitZ();
};
}  // namespace

double greatestDepth(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan, Vec3& normal) {
  if (std::ranges::count_if(plan, [](const ImageResection& one) { return !one.takesNothing(); }) > 1) {
    if (std::ranges::all_of(plan, [](const ImageResection& one) { return one.bends.empty() && one.planes.size() <= 1; })) {
      std::vector<ImagePlane> planes;
      for (const ImageResection& one : plan) {
        planes.insert(planes.end(), one.planes.begin(), one.planes.end());
      }
      HalfSpaceDepth deepest(std::move(planes));
      std::vector<std::pair<double, std::size_t>> runs;  // what bounds the depth of each
      for (std::size_t n = 0; n < rows.runs.size(); ++n) {
        if (const double most = deepest.most(boxOf(rows.runs[n], spacing)); most > 0) {
          runs.emplace_back(most, n);
        }
      }
      // The deepest ones first: few of the others have to be looked at.
      std::ranges::make_heap(runs);
      for (auto end = runs.end(); end != runs.begin() && runs.front().first > deepest.greatest(); --end) {
        deepest.keep(boxOf(rows.runs[runs.front().second], spacing));
        std::pop_heap(runs.begin(), end);
      }
      normal = deepest.along();
      return deepest.greatest();
    }
    UnionDepth deepest(plan);
    for (const RowRun& run : rows.runs) {
      deepest.keepCorners(boxOf(run, spacing));
    }
    for (const RowRun& run : rows.runs) {
      deepest.keep(boxOf(run, spacing));
    }
    normal = deepest.along();
    return deepest.greatest();
  }
  struct Corner {
    Vec3 p;
    double most = kInfinity;
  };
  std::vector<Corner> corners;
  corners.reserve(8 * rows.runs.size());
  for (const RowRun& run : rows.runs) {
    const Box box = boxOf(run, spacing);
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3 p = cornerOf(box, corner);
      if (const double most = mostDepth(p, plan, false); most > 0) {
        corners.push_back({p, most});
      }
    }
  }
  // The deepest ones first: few of the others have to be looked at.
  const auto shallower = [](const Corner& a, const Corner& b) { return a.most < b.most; };
  std::make_heap(corners.begin(), corners.end(), shallower);
  double greatest = 0;
  normal = Vec3::UnitZ();
  for (auto end = corners.end(); end != corners.begin() && corners.front().most > greatest; --end) {
    const Vec3 p = corners.front().p;
    std::pop_heap(corners.begin(), end, shallower);
    if (!(mostDepth(p, plan, true) > greatest)) {
      continue;
    }
    Vec3 along = Vec3::UnitZ();
    const double depth = depthOf(p, plan, along);
    if (std::isfinite(depth) && depth > greatest) {
      greatest = depth;
      normal = along;
    }
  }
  return greatest;
}

}  // namespace glisson
