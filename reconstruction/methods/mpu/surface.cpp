#include "reconstruction/methods/mpu/surface.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reconstruction/parallel.h"
#include "reconstruction/poisson/extraction.h"

namespace glisson::mpu {

namespace {

using poisson::kBlock;

/// The nodes of all cells, i fastest; node (i, j, k) lies (i, j, k) cells from the cube's corner. Nodes on the cube's far sides are
/// outside whatever f is, so they are left out.
struct Nodes {
  Nodes(const Cube& cube, int depth) : corner(cube.corner), side(1 << depth), cellMm(cube.side / side) {}

  [[nodiscard]] std::size_t perLayer() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }
  [[nodiscard]] std::size_t inLayer(int i, int j) const {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(side) * static_cast<std::size_t>(j);
  }
  [[nodiscard]] Vec3 at(int i, int j, int k) const { return corner + cellMm * Vec3(i, j, k); }
  /// Nodes first..last of an axis within `reach` of x; none where first > last.
  [[nodiscard]] std::pair<int, int> range(double x, double low, double reach) const {
    return {std::max(0, static_cast<int>(std::ceil((x - reach - low) / cellMm))),
            std::min(side - 1, static_cast<int>(std::floor((x + reach - low) / cellMm)))};
  }

  Vec3 corner;
  int side;
  double cellMm;
};

/// Calls body(i, j, k, squared distance) for the nodes of layers [layer, layer + kBlock) within `radius` of `centre`.
template <typename Body>
void forNodesNear(const Nodes& nodes, int layer, const Vec3& centre, double radius, const Body& body) {
  const auto [firstK, lastK] = nodes.range(centre[2], nodes.corner[2], radius);
  const auto [firstJ, lastJ] = nodes.range(centre[1], nodes.corner[1], radius);
  for (int k = std::max(firstK, layer); k <= std::min(lastK, layer + kBlock - 1); ++k) {
    for (int j = firstJ; j <= lastJ; ++j) {
      const double z = nodes.corner[2] + nodes.cellMm * k - centre[2];
      const double y = nodes.corner[1] + nodes.cellMm * j - centre[1];
      const double left = radius * radius - z * z - y * y;
      if (left < 0) {
        continue;
      }
      const auto [firstI, lastI] = nodes.range(centre[0], nodes.corner[0], std::sqrt(left));
      for (int i = firstI; i <= lastI; ++i) {
        const double x = nodes.corner[0] + nodes.cellMm * i - centre[0];
        body(i, j, k, x * x + y * y + z * z);
      }
    }
  }
}

/// For each stretch of kBlock layers the places of the balls that reach into it, in their order.
std::vector<std::vector<std::uint32_t>> byLayers(const Nodes& nodes, std::size_t count,
                                                 const std::function<Ball(std::size_t)>& ballOf) {
  std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(nodes.side / kBlock));
  for (std::size_t n = 0; n < count; ++n) {
    const Ball ball = ballOf(n);
    const auto [first, last] = nodes.range(ball.centre[2], nodes.corner[2], ball.radius);
    for (int block = first / kBlock; first <= last && block <= last / kBlock; ++block) {
      lists[static_cast<std::size_t>(block)].push_back(static_cast<std::uint32_t>(n));
    }
  }
  return lists;
}

/// f and its weights at the nodes of kBlock layers.
class Stretch {
 public:
  Stretch(const Nodes& nodes, int layer)
      : nodes_(nodes), layer_(layer), inBand_(kBlock * nodes.perLayer()), sum_(inBand_.size()), weight_(inBand_.size()) {}

  void addToBand(const Ball& ball) {
    forNodesNear(nodes_, layer_, ball.centre, ball.radius,
                 [&](int i, int j, int k, double /*squared*/) { inBand_[place(i, j, k)] = 1; });
  }
  void add(const Patch& patch) {
    const Ball& ball = patch.ball;
    forNodesNear(nodes_, layer_, ball.centre, ball.radius, [&](int i, int j, int k, double squared) {
      const std::size_t at = place(i, j, k);
      if (inBand_[at] != 0) {
        const double weight = weightAt(std::sqrt(squared), ball.radius);
        sum_[at] += weight * ball.radius * patch.quadric.value((nodes_.at(i, j, k) - ball.centre) / ball.radius);
        weight_[at] += weight;
      }
    });
  }
  /// Nothing outside the band.
  [[nodiscard]] std::optional<double> value(int i, int j, int k) const {
    const std::size_t at = place(i, j, k);
    return inBand_[at] != 0 && weight_[at] > 0 ? std::optional(sum_[at] / weight_[at]) : std::nullopt;
  }

 private:
  [[nodiscard]] std::size_t place(int i, int j, int k) const {
    return static_cast<std::size_t>(k - layer_) * nodes_.perLayer() + nodes_.inLayer(i, j);
  }

  const Nodes& nodes_;
  int layer_;
  std::vector<std::uint8_t> inBand_;
  std::vector<double> sum_;
  std::vector<double> weight_;
};

/// The extraction takes what is above 0 for inside: minus f.
void write(const Stretch& stretch, const Nodes& nodes, int layer, double bandMm, const std::function<bool(const Vec3&)>& isInside,
           poisson::Level& level) {
  const int blocks = nodes.side / kBlock;
  for (int b = 0; b < blocks * blocks; ++b) {
    const poisson::Coord block{b % blocks, b / blocks, layer / kBlock};
    float* values = level.x.data() + static_cast<std::size_t>(level.grid.slot(block)) * poisson::kBlockNodes;
    for (int n = 0; n < static_cast<int>(poisson::kBlockNodes); ++n) {
      const int i = block[0] * kBlock + n % kBlock;
      const int j = block[1] * kBlock + n / kBlock % kBlock;
      const int k = layer + n / (kBlock * kBlock);
      const std::optional<double> f = stretch.value(i, j, k);
      const double inside = f ? -*f : isInside(nodes.at(i, j, k)) ? bandMm : -bandMm;
      const bool onCube = i == 0 || j == 0 || k == 0;
      values[n] = onCube ? 0.0F : static_cast<float>(inside);
    }
  }
}

}  // namespace

SurfaceMesh polygonise(std::span<const Patch> patches, std::span<const Vec3> samples, const Cube& cube,
                       const Polygonising& polygonising, const std::function<bool(const Vec3&)>& isInside,
                       const ExecutionContext& context) {
  const Nodes nodes(cube, polygonising.depth);
  std::vector<poisson::Level> levels;
  poisson::Level& level = levels.emplace_back(polygonising.depth);
  level.grid.markAll();
  level.grid.number();
  level.x.resize(level.grid.nodeCount());
  const auto bandBall = [&](std::size_t n) { return Ball{samples[n], polygonising.bandMm}; };
  const auto bandBalls = byLayers(nodes, samples.size(), bandBall);
  const auto patchBalls = byLayers(nodes, patches.size(), [&](std::size_t n) { return patches[n].ball; });
  parallelFor(bandBalls.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      context.throwIfCancelled();
      const int layer = static_cast<int>(block) * kBlock;
      Stretch stretch(nodes, layer);
      for (const std::uint32_t n : bandBalls[block]) {
        stretch.addToBand(bandBall(n));
      }
      for (const std::uint32_t n : patchBalls[block]) {
        stretch.add(patches[n]);
      }
      write(stretch, nodes, layer, polygonising.bandMm, isInside, level);
    }
  });
  return poisson::extractSurface(levels, 0.0F, cube.corner, nodes.cellMm, context);
}

}  // namespace glisson::mpu
