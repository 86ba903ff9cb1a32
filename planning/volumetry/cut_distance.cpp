#include "planning/volumetry/cut_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "planning/infinity.h"

namespace glisson {

namespace {

void keepShorter(CutDistance::Way& best, const Vec3& from, const Vec3& to) {
  const double mm = (to - from).norm();
  if (mm < best.mm) {
    best.mm = mm;
    best.from = from;
    best.to = to;
  }
}

Vec3 nearestInBox(const Box& box, const Vec3& p) { return box.centre + (p - box.centre).cwiseMax(-box.half).cwiseMin(box.half); }

/// Closest points of segments p1 q1 (a box's edge) and p2 q2 (Ericson, Real-Time Collision Detection, 2005, 5.1.9).
void keepSegments(CutDistance::Way& best, const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2) {
  const Vec3 d1 = q1 - p1;
  const Vec3 d2 = q2 - p2;
  const Vec3 r = p1 - p2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double b = d1.dot(d2);
  const double c = d1.dot(r);
  const double f = d2.dot(r);
  const double denominator = a * e - b * b;
  double s = denominator > 1e-14 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0.0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  keepShorter(best, p1 + s * d1, p2 + t * d2);
}

/// The foot of a box's corner on the polygon, where it falls inside.
void keepFoot(CutDistance::Way& best, const Vec3& corner, const Polygon& polygon, const Vec3& normal) {
  const Vec3 foot = corner - normal.dot(corner - polygon[0]) * normal;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    const Vec3& a = polygon[n];
    const Vec3& b = polygon[(n + 1) % polygon.size()];
    if ((b - a).cross(foot - a).dot(normal) < 0) {
      return;
    }
  }
  keepShorter(best, corner, foot);
}

/// Unit normal; zero where the polygon has no area to speak of: its plane is then unknown and bounds nothing.
Vec3 normalOf(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t n = 2; n < polygon.size(); ++n) {
    sum += (polygon[n - 1] - polygon[0]).cross(polygon[n] - polygon[0]);
  }
  constexpr double kLeastMm2 = 1e-6;
  return sum.norm() > kLeastMm2 ? Vec3(sum.normalized()) : Vec3(0, 0, 0);
}

bool cross(const Box& box, Polygon polygon) {
  for (Eigen::Index axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    for (const double side : {1.0, -1.0}) {
      polygon = clipped(polygon, {side * Vec3::Unit(axis), box.half[axis] - side * box.centre[axis]});
    }
  }
  return !polygon.empty();
}

double gapTo(const Box& box, const Vec3& low, const Vec3& high) {
  return gap(box.centre - box.half, box.centre + box.half, low, high);
}
}  // namespace

CutDistance::Way shortestWay(const Box& box, const Polygon& polygon) {
  CutDistance::Way best;
  best.mm = kInfinity;
  if (cross(box, polygon)) {
    best.mm = 0;
    best.from = best.to = nearestInBox(box, polygon[0]);
    return best;
  }
  for (const Vec3& p : polygon) {
    keepShorter(best, nearestInBox(box, p), p);
  }
  const Vec3 normal = normalOf(polygon);
  if (!normal.isZero(0)) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      keepFoot(best, cornerOf(box, corner), polygon, normal);
    }
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      if ((corner & axis) != 0) {
        continue;
      }
      for (std::size_t n = 0; n < polygon.size(); ++n) {
        keepSegments(best, cornerOf(box, corner), cornerOf(box, corner | axis), polygon[n], polygon[(n + 1) % polygon.size()]);
      }
    }
  }
  return best;
}

CutDistance::CutDistance(std::vector<CutPiece> pieces) : pieces_(std::move(pieces)) {
  for (const CutPiece& piece : pieces_) {
    Vec3 low = piece.polygon[0];
    Vec3 high = low;
    for (const Vec3& p : piece.polygon) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Vec3 normal = normalOf(piece.polygon);
    planes_.push_back({normal, -normal.dot(piece.polygon[0])});
    low_.push_back(low);
    high_.push_back(high);
  }
  tree_ = BoxTree(low_, high_);
  findSharedPlanes();
}

namespace {
constexpr double kSharedMm = 1e-6;  ///< planes that differ by less are the same one, with rounding

bool isSame(const ImagePlane& a, const ImagePlane& b) { return a.normal == b.normal && std::abs(a.offset - b.offset) < kSharedMm; }
}  // namespace

/// Children come behind their parents.
void CutDistance::findSharedPlanes() {
  sharedPlanes_.resize(tree_.nodes().size());
  const auto planeOf = [&](std::uint32_t place) {
    const CutPiece& piece = pieces_[tree_.order()[place]];
    return ImagePlane{piece.normal, -piece.normal.dot(piece.polygon[0])};
  };
  for (std::size_t n = tree_.nodes().size(); n-- > 0;) {
    const BoxTree::Node& node = tree_.nodes()[n];
    if (!node.isLeaf()) {
      const std::optional<ImagePlane>& left = sharedPlanes_[n + 1];
      const std::optional<ImagePlane>& right = sharedPlanes_[node.right];
      sharedPlanes_[n] = left && right && isSame(*left, *right) ? left : std::nullopt;
      continue;
    }
    sharedPlanes_[n] = planeOf(node.begin);
    for (std::uint32_t place = node.begin + 1; place < node.end && sharedPlanes_[n]; ++place) {
      if (!isSame(*sharedPlanes_[n], planeOf(place))) {
        sharedPlanes_[n].reset();
      }
    }
  }
}

namespace {
std::vector<Box> boxesOf(const VoxelRows& rows, const Vec3& spacing) {
  std::vector<Box> boxes;
  boxes.reserve(rows.runs.size());
  for (const RowRun& run : rows.runs) {
    boxes.push_back(boxOf(run, spacing));
  }
  return boxes;
}
}  // namespace

TumourBoxes::TumourBoxes(const VoxelRows& rows, const Vec3& spacing) : TumourBoxes(boxesOf(rows, spacing)) {}

TumourBoxes::TumourBoxes(std::vector<Box> from) : boxes(std::move(from)) {
  std::vector<Vec3> low;
  std::vector<Vec3> high;
  for (const Box& box : boxes) {
    low.push_back(box.centre - box.half);
    high.push_back(box.centre + box.half);
  }
  tree = BoxTree(low, high);
}

/// No way from the box to the piece is shorter, up to kOnPlaneMm: the distance to the piece's plane is the sharper bound where the
/// box lies over it, the gap where it lies beside it.
double CutDistance::bound(std::uint32_t piece, const Box& box) const {
  const double toPlane = std::abs(planes_[piece].distance(box.centre)) - planes_[piece].support(box.half);
  return std::max(toPlane - kOnPlaneMm, gapTo(box, low_[piece], high_[piece]));
}

void CutDistance::keepShortest(const Box& box, std::uint32_t piece, Way& best) const {
  Way way = shortestWay(box, pieces_[piece].polygon);
  if (way.mm < best.mm) {
    way.piece = piece;
    best = way;
  }
}

/// No way from the node's boxes to the pieces is shorter. An oblique plane's pieces lie in bounds that are mostly empty: there the
/// distance to the plane tells more.
double CutDistance::bound(const BoxTree::Node& of, std::uint32_t to) const {
  const BoxTree::Node& node = tree_.nodes()[to];
  double least = gap(of.low, of.high, node.low, node.high);
  if (const std::optional<ImagePlane>& plane = sharedPlanes_[to]) {
    constexpr double kSlackMm = 100 * kSharedMm;  // of planes that are the same one in turn
    const double toPlane = std::abs(plane->distance(0.5 * (of.low + of.high))) - plane->support(0.5 * (of.high - of.low));
    least = std::max(least, toPlane - kSlackMm);
  }
  return least;
}

/// Calls look(box, piece, bound) for pairs that may be nearer than `best`, which the calls make less. Goes down both trees at once,
/// in the larger node first.
template <typename Look>
void CutDistance::search(const TumourBoxes& tumour, std::uint32_t of, std::uint32_t to, const double& best,
                         const Look& look) const {
  const BoxTree::Node& from = tumour.tree.nodes()[of];
  const BoxTree::Node& node = tree_.nodes()[to];
  if (from.isLeaf() && node.isLeaf()) {
    for (std::uint32_t n = from.begin; n < from.end; ++n) {
      const Box& box = tumour.boxes[tumour.tree.order()[n]];
      for (std::uint32_t m = node.begin; m < node.end; ++m) {
        const double least = bound(tree_.order()[m], box);
        if (least < best) {
          look(box, tree_.order()[m], least);
        }
      }
    }
    return;
  }
  const bool splitTumour = node.isLeaf() || (!from.isLeaf() && (from.high - from.low).sum() > (node.high - node.low).sum());
  const BoxTree& split = splitTumour ? tumour.tree : tree_;
  const std::uint32_t parent = splitTumour ? of : to;
  const std::array<std::uint32_t, 2> children{parent + 1, split.nodes()[parent].right};
  std::array<double, 2> bounds{};
  for (std::size_t n = 0; n < 2; ++n) {
    bounds[n] = splitTumour ? bound(split.nodes()[children[n]], to) : bound(from, children[n]);
  }
  const std::size_t nearer = bounds[1] < bounds[0] ? 1 : 0;
  for (const std::size_t child : {nearer, 1 - nearer}) {
    if (bounds[child] < best) {
      search(tumour, splitTumour ? children[child] : of, splitTumour ? to : children[child], best, look);
    }
  }
}

CutDistance::Way CutDistance::shortest(const TumourBoxes& tumour) const {
  Way best;
  best.mm = kInfinity;
  if (pieces_.empty() || tumour.boxes.empty()) {
    return best;
  }
  // The pair of the least bound is near the shortest way: from there few pairs are left to be measured.
  double least = kInfinity;
  Box likely;
  std::uint32_t piece = 0;
  search(tumour, 0, 0, least, [&](const Box& box, std::uint32_t found, double bound) {
    least = bound;
    likely = box;
    piece = found;
  });
  keepShortest(likely, piece, best);
  search(tumour, 0, 0, best.mm, [&](const Box& box, std::uint32_t found, double /*bound*/) { keepShortest(box, found, best); });
  return best;
}

double CutDistance::atLeast(const TumourBoxes& tumour, const Way& way) const {
  const double flattening = pieces_[way.piece].flatteningMm;
  double least = way.mm - flattening;
  const BoxTree::Node& around = tumour.tree.nodes()[0];
  for (std::size_t n = 0; n < pieces_.size(); ++n) {
    // A piece that is flattened no more than the nearest one cannot come nearer.
    const double off = pieces_[n].flatteningMm;
    if (off <= flattening || gap(around.low, around.high, low_[n], high_[n]) - off >= least) {
      continue;
    }
    for (const Box& box : tumour.boxes) {
      if (gapTo(box, low_[n], high_[n]) - off < least) {
        least = std::min(least, shortestWay(box, pieces_[n].polygon).mm - off);
      }
    }
  }
  return least;
}

}  // namespace glisson
