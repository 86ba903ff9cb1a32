#include "reconstruction/poisson/support.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <numeric>
#include <span>
#include <utility>

#include "reconstruction/mesh/edges.h"
#include "reconstruction/parallel.h"

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

/// The cells of a level (4 or more), each with the ways that some triangle in it does not face, and whether it holds a sample.
/// Those of a block of 16^3 lie in one page: memory that is zero until it is touched, which only the blocks near the surface are.
class Cells {
 public:
  Cells(int level, const Vec3& corner, double cellMm)
      : level_(level),
        corner_(corner),
        perMm_(1.0 / cellMm),
        bits_(static_cast<std::uint8_t*>(std::calloc(std::size_t{1} << (3 * level), 1))) {
    if (bits_ == nullptr) {
      throw std::bad_alloc();
    }
  }

  [[nodiscard]] Coord of(const Vec3& position) const {
    Coord cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      cell[a] = std::clamp(static_cast<int>((position[axis] - corner_[axis]) * perMm_), 0, (1 << level_) - 1);
    }
    return cell;
  }
  [[nodiscard]] std::uint8_t& at(const Coord& c) { return bits_[index(c)]; }
  /// From any thread.
  void add(const Box& box, unsigned bits) {
    forEachIn(box, [&](std::uint8_t& cell) {
      const std::atomic_ref shared(cell);
      if ((shared.load(std::memory_order_relaxed) & bits) != bits) {
        shared.fetch_or(static_cast<std::uint8_t>(bits), std::memory_order_relaxed);
      }
    });
  }
  [[nodiscard]] unsigned in(const Box& box) {
    unsigned any = 0;
    forEachIn(box, [&](std::uint8_t& cell) { any |= cell; });
    return any;
  }

 private:
  [[nodiscard]] std::size_t index(const Coord& c) const {
    constexpr unsigned kInBlock = (1U << kBlockBits) - 1;
    const auto joined = [&](unsigned mask, int down, int bits) {  // three coordinates of some bits each as one number
      const auto part = [&](int value) { return static_cast<std::size_t>((static_cast<unsigned>(value) >> down) & mask); };
      return part(c[0]) | part(c[1]) << bits | part(c[2]) << (2 * bits);
    };
    return joined(~0U, kBlockBits, level_ - kBlockBits) << (3 * kBlockBits) | joined(kInBlock, 0, kBlockBits);
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

  static constexpr int kBlockBits = 4;
  struct Free {
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };

  int level_;
  Vec3 corner_;
  double perMm_;
  std::unique_ptr<std::uint8_t[], Free> bits_;
};

bool isGone(const Triangle& t) { return t[0] == t[1]; }
std::size_t placeIn(const Triangle& t, std::uint32_t v) { return static_cast<std::size_t>(std::ranges::find(t, v) - t.begin()); }

/// The mesh that is coarsened, with what is known of its surroundings.
struct Surroundings {
  Cells cells;
  double cellMm;  ///< of the finest level
  SurfaceMesh& mesh;
  std::vector<std::uint8_t> free{};     ///< per vertex: no sample supports it
  std::vector<std::uint8_t> done{};     ///< per vertex: taken part in this round
  std::vector<std::uint8_t> fresh{};    ///< per vertex: its triangles are not those that the round before looked at
  std::vector<std::uint8_t> changed{};  ///< the same for the next round
  std::vector<std::uint32_t> first{};   ///< per vertex: the first of its triangles; one more at the end
  std::vector<std::uint32_t> trianglesAt{};

  [[nodiscard]] bool mayMove(std::uint32_t v) const { return free[v] != 0 && done[v] == 0; }
  void beginRound() {
    fresh = std::exchange(changed, std::vector<std::uint8_t>(mesh.vertices.size()));
    done.assign(mesh.vertices.size(), 0);
  }
  void addToCells(const Vec3& a, const Vec3& b, const Vec3& c) {
    Box box(a);
    cells.add(box.extend(b).extend(c), waysNotFaced((b - a).cross(c - a)));
  }

  /// Puts the triangles into the cells and finds the vertices in cells without samples.
  void lookAround(const ExecutionContext& context) {
    constexpr std::size_t kTrianglesAPiece = 8192;
    parallelFor(mesh.triangles.size(), kTrianglesAPiece, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      for (std::size_t t = begin; t < end; ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        addToCells(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
      }
    });
    free.resize(mesh.vertices.size());
    changed.assign(mesh.vertices.size(), 1);
    parallelFor(free.size(), kTrianglesAPiece, [&](std::size_t begin, std::size_t end) {
      context.throwIfCancelled();
      for (std::size_t v = begin; v < end; ++v) {
        free[v] = (cells.at(cells.of(mesh.vertices[v])) & kSampled) == 0 ? 1 : 0;
      }
    });
  }

  /// The triangles at every free vertex.
  void findTriangles(const ExecutionContext& context) {
    first.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t v : t) {
        first[v + 1] += free[v];
      }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    trianglesAt.resize(first.back());
    context.throwIfCancelled();
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        if (free[v] != 0) {
          trianglesAt[next[v]++] = t;
        }
      }
    }
  }
};

/// Collapses edges, one after the other. Several may be at work at once where they are blocks apart.
class Coarsener {
 public:
  explicit Coarsener(Surroundings& around) : around_(around), mesh_(around.mesh) {}

  /// Merges the vertex with one beside it, where that may be.
  void coarsenAt(std::uint32_t v) {
    if (around_.mayMove(v)) {
      findNear(v);
      collapseOneOf(v);
    }
  }

 private:
  /// What stays of a triangle whose corner `own` moves.
  struct Side {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t own;
  };

  template <typename Visit>
  void forEachTriangleAt(std::uint32_t v, Visit&& visit) const {
    for (std::uint32_t n = around_.first[v]; n < around_.first[v + 1]; ++n) {
      if (!isGone(mesh_.triangles[around_.trianglesAt[n]])) {
        visit(around_.trianglesAt[n]);
      }
    }
  }

  /// The other ends of the edges that may be collapsed into v, the shortest first. An edge is looked at from one end, and not again
  /// where nothing has changed around it.
  void findNear(std::uint32_t v) {
    near_.clear();
    const double most = kShort * around_.cellMm;
    forEachTriangleAt(v, [&](std::uint32_t n) {
      const Triangle& t = mesh_.triangles[n];
      const std::uint32_t other = t[(placeIn(t, v) + 1) % 3];  // every neighbour once
      const double length = (mesh_.vertices[other] - mesh_.vertices[v]).norm();
      const bool isNew = around_.fresh[v] != 0 || around_.fresh[other] != 0;
      if (v < other && isNew && around_.mayMove(other) && length < most) {
        near_.emplace_back(length, other);
      }
    });
    std::ranges::sort(near_);
  }

  /// Triangles with both ends go, those with one get a new corner: the sides that they keep are the ring.
  void findRing(std::uint32_t kept, std::uint32_t merged) {
    ring_.clear();
    const auto look = [&](std::uint32_t own, std::uint32_t other) {
      forEachTriangleAt(own, [&](std::uint32_t n) {
        const Triangle& t = mesh_.triangles[n];
        if (placeIn(t, other) == 3) {
          const std::size_t at = placeIn(t, own);
          ring_.push_back({.from = t[(at + 1) % 3], .to = t[(at + 2) % 3], .own = own});
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
    std::uint32_t at = ring_[0].from;
    std::size_t steps = 0;
    do {
      const auto next = std::ranges::find(ring_, at, &Side::from);
      if (next == ring_.end()) {
        return false;
      }
      at = next->to;
      ++steps;
    } while (at != ring_[0].from && steps < ring_.size());
    return at == ring_[0].from && steps == ring_.size();
  }

  /// Twice the area vector of the ring.
  [[nodiscard]] Vec3 areaOfRing() const {
    Vec3 sum = Vec3::Zero();
    for (const Side& side : ring_) {
      sum += (mesh_.vertices[side.from] - mesh_.vertices[ring_[0].from])
                 .cross(mesh_.vertices[side.to] - mesh_.vertices[ring_[0].from]);
    }
    return sum;
  }

  /// The place beside the edge's middle that keeps the volume.
  [[nodiscard]] Vec3 placeOf(std::uint32_t kept, std::uint32_t merged, const Vec3& area) const {
    const Vec3 middle = 0.5 * (mesh_.vertices[kept] + mesh_.vertices[merged]);
    double before = 0;  // six times the volume between the triangles and the middle
    for (const Side& side : ring_) {
      before +=
          (mesh_.vertices[side.own] - middle).dot((mesh_.vertices[side.from] - middle).cross(mesh_.vertices[side.to] - middle));
    }
    return middle + area * (before / area.squaredNorm());  // the triangles that go hold the middle: no volume
  }

  [[nodiscard]] bool isWellShaped(const Vec3& place, const Vec3& area) const {
    const double most = kLongest * around_.cellMm * kLongest * around_.cellMm;
    const double least = kTurn * kTurn * area.squaredNorm();
    return std::ranges::all_of(ring_, [&](const Side& side) {
      const Vec3 u = mesh_.vertices[side.from] - place;
      if (!(u.squaredNorm() < most)) {
        return false;
      }
      const Vec3 v = mesh_.vertices[side.to] - place;
      const Vec3 normal = u.cross(v);
      const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
      const double turn = normal.dot(area);
      return normal.squaredNorm() > kNeedle * kNeedle * longest * longest && turn > 0 && turn * turn > least * normal.squaredNorm();
    });
  }

  /// All that is near faces one way along an axis, the new triangles too. A line that way then meets the surface once, since it
  /// would have to enter the body again in between; and the new triangles lie where the old ones did as seen along it.
  [[nodiscard]] bool staysGraph(std::uint32_t kept, std::uint32_t merged, const Vec3& place) {
    Box box(place);
    box.extend(mesh_.vertices[kept]).extend(mesh_.vertices[merged]);
    unsigned notFaced = 0;
    for (const Side& side : ring_) {
      box.extend(mesh_.vertices[side.from]);
      notFaced |= waysNotFaced((mesh_.vertices[side.from] - place).cross(mesh_.vertices[side.to] - place));
    }
    return ((notFaced | around_.cells.in(box)) & kWays) != kWays;
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
    findRing(kept, merged);
    const Vec3 area = areaOfRing();
    const Vec3 place = placeOf(kept, merged, area);
    if (!isWellShaped(place, area) || !ringIsSimple() || !staysGraph(kept, merged, place)) {  // what fails most first
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
    around_.done[kept] = around_.done[merged] = around_.changed[kept] = 1;
    around_.free[merged] = 0;
    for (const Side& side : ring_) {
      around_.changed[side.from] = 1;
      around_.addToCells(place, mesh_.vertices[side.from], mesh_.vertices[side.to]);
    }
    return true;
  }

  Surroundings& around_;
  SurfaceMesh& mesh_;
  std::vector<std::pair<double, std::uint32_t>> near_;  ///< of the vertex that is looked at: length of edge, other end
  std::vector<Side> ring_;                              ///< of the edge that is looked at
};

/// The free vertices by block of kBlockCells cells of the finest level, in eight groups of blocks: blocks of one group lie a block
/// apart, farther than collapses reach (some four cells), so that they can be coarsened at once and the mesh is the same for any
/// number of threads.
class Blocks {
 public:
  Blocks(const Surroundings& around, int depth) : perSide_(std::max(1, (1 << depth) / kBlockCells)) {
    const auto count = static_cast<std::size_t>(perSide_) * static_cast<std::size_t>(perSide_) * static_cast<std::size_t>(perSide_);
    std::vector<std::uint32_t> blockOf(around.free.size());
    first_.assign(count + 1, 0);
    for (std::size_t v = 0; v < blockOf.size(); ++v) {
      if (around.free[v] != 0) {
        const Coord cell = around.cells.of(around.mesh.vertices[v]);  // of the level below the finest
        const auto along = [&](std::size_t a) {
          return static_cast<std::size_t>(std::min(cell[a] / (kBlockCells / 2), perSide_ - 1));
        };
        const auto side = static_cast<std::size_t>(perSide_);
        blockOf[v] = static_cast<std::uint32_t>(along(0) + side * (along(1) + side * along(2)));
        ++first_[blockOf[v] + 1];
      }
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    vertices_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t v = 0; v < blockOf.size(); ++v) {
      if (around.free[v] != 0) {
        vertices_[next[blockOf[v]]++] = v;
      }
    }
    for (std::size_t block = 0; block < count; ++block) {
      if (first_[block] != first_[block + 1]) {
        const auto side = static_cast<std::size_t>(perSide_);
        groups_[(block & 1U) + 2 * (block / side & 1U) + 4 * (block / side / side & 1U)].push_back(block);
      }
    }
  }

  /// Calls visit(vertices of a block), for the blocks of a group on several threads.
  template <typename Visit>
  void forEach(const ExecutionContext& context, const Visit& visit) const {
    for (const std::vector<std::size_t>& group : groups_) {
      parallelFor(group.size(), 4, [&](std::size_t begin, std::size_t end) {
        context.throwIfCancelled();
        for (std::size_t n = begin; n < end; ++n) {
          visit(std::span(vertices_).subspan(first_[group[n]], first_[group[n] + 1] - first_[group[n]]));
        }
      });
    }
  }

 private:
  static constexpr int kBlockCells = 16;
  // Two collapses of one group: the reach of each, a cell of the level below that both touch, and how far the vertices of both
  // have come in the first round (the half of what a collapse moves would do).
  static_assert(kRounds == 2 && 2 * (kShort + kLongest) + 2 + 2 * (1.733 + kLongest) < kBlockCells);
  int perSide_;
  std::vector<std::uint32_t> first_;  ///< per block: its first vertex; one more at the end
  std::vector<std::uint32_t> vertices_;
  std::array<std::vector<std::size_t>, 8> groups_;
};

}  // namespace

void coarsenUnsupported(const CubeSamples& samples, const Vec3& corner, double cellMm, SurfaceMesh& mesh,
                        const ExecutionContext& context) {
  Cells cells(samples.depth - 1, corner, 2 * cellMm);
  context.throwIfCancelled();
  for (const auto& [x, y, z] : samples.positions) {
    cells.at(cells.of(corner + cellMm * Vec3(x, y, z))) = kSampled;
  }
  Surroundings around{.cells = std::move(cells), .cellMm = cellMm, .mesh = mesh};
  around.lookAround(context);
  const Blocks blocks(around, samples.depth);
  for (int n = 0; n < kRounds; ++n) {
    around.findTriangles(context);
    around.beginRound();
    blocks.forEach(context, [&](std::span<const std::uint32_t> vertices) {
      Coarsener coarsener(around);
      std::ranges::for_each(vertices, [&](std::uint32_t v) { coarsener.coarsenAt(v); });
    });
    context.throwIfCancelled();
    std::erase_if(mesh.triangles, isGone);
  }
  dropUnusedVertices(mesh);
}

}  // namespace glisson::poisson
