#include "reconstruction/poisson/support.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "reconstruction/mesh/edges.h"

namespace glisson::poisson {

namespace {

constexpr double kShort = 1.2;    // cells of the finest level: shorter edges are collapsed
constexpr double kLongest = 2.0;  // cells of the finest level: no edge becomes longer
constexpr int kRounds = 2;        // a third one takes less than a hundredth away
constexpr double kNeedle = 0.1;   // least height of a new triangle over its longest side
constexpr double kTurn = 0.5;     // least cosine between a new triangle's normal and that of its ring
constexpr double kFacing = 0.02;  // least share of a normal along an axis: well above rounding
constexpr unsigned kWays = 63;    // bits of the six ways along the axes
constexpr std::uint8_t kSampled = 64;

using Box = Eigen::AlignedBox3d;

/// The ways along the axes, +x -x +y -y +z -z, that a triangle of this normal does not face, as bits.
unsigned waysNotFaced(const Vec3& normal) {
  const double least = kFacing * normal.norm();
  unsigned bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    bits |= (normal[axis] > least ? 0U : 1U) << (2 * axis);
    bits |= (normal[axis] < -least ? 0U : 2U) << (2 * axis);
  }
  return bits;
}

/// The cells of a level, each with the ways that some triangle in it does not face, and whether it holds a sample.
class Cells {
 public:
  Cells(int level, const Vec3& corner, double cellMm)
      : level_(level), corner_(corner), perMm_(1.0 / cellMm), bits_(std::size_t{1} << (3 * level), 0) {}

  [[nodiscard]] Coord of(const Vec3& position) const {
    Coord cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      cell[a] = std::clamp(static_cast<int>((position[axis] - corner_[axis]) * perMm_), 0, (1 << level_) - 1);
    }
    return cell;
  }
  [[nodiscard]] std::uint8_t& at(const Coord& c) { return bits_[index(c)]; }
  void add(const Box& box, unsigned bits) {
    forEachIn(box, [&](std::uint8_t& cell) { cell = static_cast<std::uint8_t>(cell | bits); });
  }
  [[nodiscard]] unsigned in(const Box& box) {
    unsigned any = 0;
    forEachIn(box, [&](std::uint8_t& cell) { any |= cell; });
    return any;
  }

 private:
  [[nodiscard]] std::size_t index(const Coord& c) const {
    return static_cast<std::size_t>(c[0]) + (static_cast<std::size_t>(c[1]) << level_) +
           (static_cast<std::size_t>(c[2]) << (2 * level_));
  }
  template <typename Visit>
  void forEachIn(const Box& box, Visit&& visit) {
    const Coord low = of(box.min());
    const Coord high = of(box.max());
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          visit(at({i, j, k}));
        }
      }
    }
  }

  int level_;
  Vec3 corner_;
  double perMm_;
  std::vector<std::uint8_t> bits_;
};

class Coarsener {
 public:
  Coarsener(Cells cells, double cellMm, SurfaceMesh& mesh) : cells_(std::move(cells)), cellMm_(cellMm), mesh_(mesh) {}

  /// Puts the triangles into the cells and finds the vertices in cells without samples.
  void lookAround(const ExecutionContext& context) {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % kPoll == 0) {
        context.throwIfCancelled();
      }
      const auto& [a, b, c] = mesh_.triangles[t];
      addToCells(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
    }
    context.throwIfCancelled();
    free_.resize(mesh_.vertices.size());
    for (std::size_t v = 0; v < free_.size(); ++v) {
      free_[v] = (cells_.at(cells_.of(mesh_.vertices[v])) & kSampled) == 0 ? 1 : 0;
    }
  }

  /// One collapse at most for every vertex.
  void round(const ExecutionContext& context) {
    findTriangles(context);
    done_.assign(mesh_.vertices.size(), 0);
    for (std::uint32_t v = 0; v < free_.size(); ++v) {
      if (v % kPoll == 0) {
        context.throwIfCancelled();
      }
      if (mayMove(v)) {
        findNear(v);
        collapseOneOf(v);
      }
    }
    context.throwIfCancelled();
    std::erase_if(mesh_.triangles, isGone);
  }

 private:
  static constexpr std::size_t kPoll = 4096;

  static bool isGone(const Triangle& t) { return t[0] == t[1]; }
  static std::size_t placeIn(const Triangle& t, std::uint32_t v) {
    return static_cast<std::size_t>(std::ranges::find(t, v) - t.begin());
  }
  [[nodiscard]] bool mayMove(std::uint32_t v) const { return free_[v] != 0 && done_[v] == 0; }

  void addToCells(const Vec3& a, const Vec3& b, const Vec3& c) {
    Box box(a);
    cells_.add(box.extend(b).extend(c), waysNotFaced((b - a).cross(c - a)));
  }

  /// The triangles at every free vertex.
  void findTriangles(const ExecutionContext& context) {
    first_.assign(mesh_.vertices.size() + 1, 0);
    for (const Triangle& t : mesh_.triangles) {
      for (const std::uint32_t v : t) {
        first_[v + 1] += free_[v];
      }
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    trianglesAt_.resize(first_.back());
    context.throwIfCancelled();
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (free_[v] != 0) {
          trianglesAt_[next[v]++] = t;
        }
      }
    }
  }

  template <typename Visit>
  void forEachTriangleAt(std::uint32_t v, Visit&& visit) const {
    for (std::uint32_t n = first_[v]; n < first_[v + 1]; ++n) {
      if (!isGone(mesh_.triangles[trianglesAt_[n]])) {
        visit(trianglesAt_[n]);
      }
    }
  }

  /// The other ends of the edges that may be collapsed into v, the shortest first.
  void findNear(std::uint32_t v) {
    near_.clear();
    const double most = kShort * cellMm_;
    forEachTriangleAt(v, [&](std::uint32_t n) {
      const Triangle& t = mesh_.triangles[n];
      const std::uint32_t other = t[(placeIn(t, v) + 1) % 3];  // every neighbour once
      const double length = (mesh_.vertices[other] - mesh_.vertices[v]).norm();
      if (mayMove(other) && length < most) {
        near_.emplace_back(length, other);
      }
    });
    std::ranges::sort(near_);
  }

  /// Triangles with both ends go, those with one are changed: the sides that they keep are the ring.
  void findStar(std::uint32_t kept, std::uint32_t merged) {
    changed_.clear();
    ring_.clear();
    box_.setEmpty();
    const auto look = [&](std::uint32_t from, std::uint32_t other) {
      forEachTriangleAt(from, [&](std::uint32_t n) {
        const Triangle& t = mesh_.triangles[n];
        std::ranges::for_each(t, [&](std::uint32_t corner) { box_.extend(mesh_.vertices[corner]); });
        if (placeIn(t, other) == 3) {
          const std::size_t at = placeIn(t, from);
          changed_.push_back(n);
          ring_.push_back({t[(at + 1) % 3], t[(at + 2) % 3]});
        }
      });
    };
    look(kept, merged);
    look(merged, kept);
  }

  /// The ring is one closed line that meets itself nowhere: the link condition.
  [[nodiscard]] bool ringIsSimple() const {
    if (ring_.size() < 3) {
      return false;
    }
    std::uint32_t at = ring_[0][0];
    std::size_t steps = 0;
    do {
      const auto next = std::ranges::find(ring_, at, [](const auto& side) { return side[0]; });
      if (next == ring_.end()) {
        return false;
      }
      at = (*next)[1];
      ++steps;
    } while (at != ring_[0][0] && steps < ring_.size());
    return at == ring_[0][0] && steps == ring_.size();
  }

  /// Twice the area vector of the ring.
  [[nodiscard]] Vec3 areaOfRing() const {
    Vec3 sum = Vec3::Zero();
    for (const auto& [b, c] : ring_) {
      sum += (mesh_.vertices[b] - mesh_.vertices[ring_[0][0]]).cross(mesh_.vertices[c] - mesh_.vertices[ring_[0][0]]);
    }
    return sum;
  }

  /// The place beside the edge's middle that keeps the volume.
  [[nodiscard]] Vec3 placeOf(std::uint32_t kept, std::uint32_t merged, const Vec3& area) const {
    const Vec3 middle = 0.5 * (mesh_.vertices[kept] + mesh_.vertices[merged]);
    double before = 0;  // six times the volume between the triangles and the middle
    for (std::size_t n = 0; n < ring_.size(); ++n) {
      const Triangle& t = mesh_.triangles[changed_[n]];
      const Vec3& own = mesh_.vertices[placeIn(t, kept) < 3 ? kept : merged];
      before += (own - middle).dot((mesh_.vertices[ring_[n][0]] - middle).cross(mesh_.vertices[ring_[n][1]] - middle));
    }
    return middle + area * (before / area.squaredNorm());  // the triangles that go hold the middle: no volume
  }

  [[nodiscard]] bool isWellShaped(const Vec3& place, const Vec3& area) const {
    return std::ranges::all_of(ring_, [&](const auto& side) {
      const Vec3 u = mesh_.vertices[side[0]] - place;
      const Vec3 v = mesh_.vertices[side[1]] - place;
      const Vec3 normal = u.cross(v);
      const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
      const double most = kLongest * cellMm_;
      return u.squaredNorm() < most * most && normal.norm() > kNeedle * longest &&
             normal.dot(area) > kTurn * normal.norm() * area.norm();
    });
  }

  /// All that is near faces one way along an axis, the new triangles too. A line that way then meets the surface once, since it
  /// would have to enter the body again in between; and the new triangles lie where the old ones did as seen along it.
  [[nodiscard]] bool staysGraph(const Vec3& place) {
    unsigned notFaced = cells_.in(box_);
    for (const auto& [b, c] : ring_) {
      notFaced |= waysNotFaced((mesh_.vertices[b] - place).cross(mesh_.vertices[c] - place));
    }
    return (notFaced & kWays) != kWays;
  }

  void collapseOneOf(std::uint32_t v) {
    for (const auto& [length, other] : near_) {
      if (collapse(v, other)) {
        return;
      }
    }
  }

  /// Merges two ends of an edge; false where that must not be.
  bool collapse(std::uint32_t kept, std::uint32_t merged) {
    findStar(kept, merged);
    if (!ringIsSimple()) {
      return false;
    }
    const Vec3 area = areaOfRing();
    const Vec3 place = placeOf(kept, merged, area);
    box_.extend(place);
    if (!isWellShaped(place, area) || !staysGraph(place)) {
      return false;
    }
    forEachTriangleAt(merged, [&](std::uint32_t n) {
      Triangle& t = mesh_.triangles[n];
      if (placeIn(t, kept) == 3) {
        t[placeIn(t, merged)] = kept;
      } else {
        t = {kept, kept, kept};
      }
    });
    mesh_.vertices[kept] = place;
    done_[kept] = done_[merged] = 1;
    free_[merged] = 0;
    for (const auto& [b, c] : ring_) {
      addToCells(place, mesh_.vertices[b], mesh_.vertices[c]);
    }
    return true;
  }

  Cells cells_;
  double cellMm_;  ///< of the finest level
  SurfaceMesh& mesh_;
  std::vector<std::uint8_t> free_;    ///< per vertex: no sample supports it
  std::vector<std::uint8_t> done_;    ///< per vertex: taken part in this round
  std::vector<std::uint32_t> first_;  ///< per vertex: the first of its triangles; one more at the end
  std::vector<std::uint32_t> trianglesAt_;
  std::vector<std::pair<double, std::uint32_t>> near_;  ///< of the vertex that is looked at: length of edge, other end
  // of the edge that is looked at
  std::vector<std::uint32_t> changed_;              ///< triangles that get a new corner
  std::vector<std::array<std::uint32_t, 2>> ring_;  ///< the side of each that stays
  Box box_;                                         ///< of all its triangles, and of the place they get
};

}  // namespace

void coarsenUnsupported(const CubeSamples& samples, const Vec3& corner, double cellMm, SurfaceMesh& mesh,
                        const ExecutionContext& context) {
  Cells cells(samples.depth - 1, corner, 2 * cellMm);
  context.throwIfCancelled();
  for (const auto& [x, y, z] : samples.positions) {
    cells.at(cells.of(corner + cellMm * Vec3(x, y, z))) = kSampled;
  }
  Coarsener coarsener(std::move(cells), cellMm, mesh);
  coarsener.lookAround(context);
  for (int n = 0; n < kRounds; ++n) {
    coarsener.round(context);
  }
  dropUnusedVertices(mesh);
}

}  // namespace glisson::poisson
