#include "reconstruction/methods/mpu/octree.h"

#include <algorithm>
#include <cmath>

#include "reconstruction/methods/point_tree.h"
#include "reconstruction/parallel.h"

namespace glisson::mpu {

namespace {

// As in the paper: a ball's radius over its cell's diagonal, the points it has to hold, the neighbours of an auxiliary point.
constexpr double kRadius = 0.75;
constexpr std::size_t kLeastPoints = 15;
constexpr std::size_t kNeighbours = 6;

struct Cell {
  Vec3 centre;
  double side;
};

class Octree {
 public:
  Octree(std::span<const Vec3> positions, std::span<const Vec3> normals, const Fitting& fitting)
      : positions_(positions), normals_(normals), fitting_(fitting), tree_(positions) {}

  /// The cell's patch; `isLeaf` says whether it is good enough, or the cell must not be divided.
  [[nodiscard]] Patch patchOf(const Cell& cell, bool& isLeaf) const;

 private:
  [[nodiscard]] std::vector<AuxiliaryPoint> auxiliaryPoints(const Cell& cell) const;

  std::span<const Vec3> positions_;
  std::span<const Vec3> normals_;
  Fitting fitting_;
  PointTree tree_;
};

/// The cell's corners and centre, each where its neighbours agree on which side of the surface it lies.
std::vector<AuxiliaryPoint> Octree::auxiliaryPoints(const Cell& cell) const {
  std::vector<AuxiliaryPoint> points;
  std::vector<std::uint32_t> near;
  for (int corner = 0; corner <= 8; ++corner) {
    Vec3 at = cell.centre;
    if (corner < 8) {
      at += 0.5 * cell.side * Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    }
    tree_.nearest(at, kNeighbours, near);
    double sum = 0;
    std::size_t outside = 0;
    for (const std::uint32_t n : near) {
      const double distance = normals_[n].dot(at - positions_[n]);
      sum += distance;
      outside += distance > 0 ? 1 : 0;
    }
    if (outside == 0 || outside == near.size()) {
      points.push_back({at, sum / static_cast<double>(near.size())});
    }
  }
  return points;
}

Patch Octree::patchOf(const Cell& cell, bool& isLeaf) const {
  Patch patch;
  patch.ball = {cell.centre, kRadius * std::sqrt(3.0) * cell.side};
  std::vector<std::uint32_t> places;
  tree_.within(patch.ball.centre, patch.ball.radius, places);
  const bool isEmpty = places.empty();
  if (places.size() < kLeastPoints) {
    tree_.nearest(cell.centre, kLeastPoints, places);
    constexpr double kBeyondTheLast = 1.1;  // where its weight is above 0
    patch.ball.radius = std::max(patch.ball.radius, kBeyondTheLast * (positions_[places.back()] - cell.centre).norm());
  }
  const BallPoints points{positions_, normals_, places};
  const Vec3 up = meanNormal(patch.ball, points);
  const bool turnsOver = std::any_of(places.begin(), places.end(), [&](std::uint32_t n) { return normals_[n].dot(up) <= 0; });
  isLeaf = isEmpty || 0.5 * cell.side < fitting_.leastSideMm;
  if (turnsOver) {
    const std::vector<AuxiliaryPoint> auxiliary = auxiliaryPoints(cell);
    if (!auxiliary.empty()) {
      patch.quadric = fitGeneral(patch.ball, points, auxiliary);
      isLeaf = isLeaf || greatestError(patch.ball, points, patch.quadric) <= fitting_.toleranceMm;
      return patch;
    }
    if (!isLeaf) {
      return patch;  // too coarse to tell its sides apart: it is divided
    }
  }
  patch.quadric = fitHeight(patch.ball, points, up);
  isLeaf = isLeaf || greatestError(patch.ball, points, patch.quadric) <= fitting_.toleranceMm;
  return patch;
}

}  // namespace

std::vector<Patch> fitPatches(std::span<const Vec3> positions, std::span<const Vec3> normals, const Cube& cube,
                              const Fitting& fitting, const ExecutionContext& context) {
  constexpr std::size_t kGrain = 16;
  constexpr double kLevels = 10;  // about: for the progress alone
  const Octree octree(positions, normals, fitting);
  std::vector<Patch> leaves;
  std::vector<Cell> cells{{cube.corner + Vec3::Constant(0.5 * cube.side), cube.side}};
  for (int level = 0; !cells.empty(); ++level) {
    context.report(std::min(1.0, level / kLevels), "solve");
    std::vector<Patch> patches(cells.size());
    std::vector<std::uint8_t> isLeaf(cells.size());
    parallelFor(cells.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        context.throwIfCancelled();
        bool leaf = false;
        patches[n] = octree.patchOf(cells[n], leaf);
        isLeaf[n] = leaf ? 1 : 0;
      }
    });
    std::vector<Cell> children;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      if (isLeaf[n] != 0) {
        leaves.push_back(patches[n]);
        continue;
      }
      for (int child = 0; child < 8; ++child) {
        const Vec3 towards((child & 1) != 0 ? 1 : -1, (child & 2) != 0 ? 1 : -1, (child & 4) != 0 ? 1 : -1);
        children.push_back({cells[n].centre + 0.25 * cells[n].side * towards, 0.5 * cells[n].side});
      }
    }
    cells = std::move(children);
  }
  return leaves;
}

}  // namespace glisson::mpu
