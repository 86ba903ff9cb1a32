#include "reconstruction/poisson/hierarchy.h"

#include <algorithm>

#include "reconstruction/parallel.h"
#include "reconstruction/poisson/operators.h"

namespace glisson::poisson {

namespace {

constexpr int kDenseLevel = 6;      // 64^3 nodes: cheaper to keep whole than to band
constexpr std::size_t kGrain = 64;  // blocks a piece in vector loops

/// Number of conjugate-gradient steps: the coarsest levels are solved to the end, the fine ones start close to the solution.
int stepsOf(int level) { return level <= 4 ? 40 : level <= kDenseLevel ? 24 : 14; }

/// Marks the blocks of a level within `reach` cells (of that level) of a sample.
void markNearSamples(const CubeSamples& samples, float reach, BlockGrid& grid) {
  const float scale = 1.0F / static_cast<float>(1 << (samples.depth - grid.level()));
  const auto blockAt = [&](float p) {
    return std::clamp(static_cast<int>(std::max(p, 0.0F)) / kBlock, 0, grid.blocksPerSide() - 1);
  };
  for (const auto& position : samples.positions) {
    Coord low{};
    Coord high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = blockAt(position[a] * scale - reach);
      high[a] = blockAt(position[a] * scale + 1 + reach);
    }
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          grid.mark({i, j, k});
        }
      }
    }
  }
}

/// Every coarse block that a fine block is prolonged from: the one under it and those that hold the node after.
void markParents(const BlockGrid& fine, BlockGrid& coarse) {
  for (std::size_t n = 0; n < fine.blockCount(); ++n) {
    const Coord& b = fine.coord(n);
    for (int c = 0; c < 8; ++c) {
      coarse.mark({(b[0] + (c & 1)) / 2, (b[1] + ((c >> 1) & 1)) / 2, (b[2] + (c >> 2)) / 2});
    }
  }
}

std::vector<Level> makeLevels(const CubeSamples& samples, const HierarchyOptions& options) {
  std::vector<Level> levels;
  for (int l = kCoarsestLevel; l <= samples.depth; ++l) {
    levels.emplace_back(l);
  }
  for (std::size_t n = levels.size(); n-- > 0;) {
    Level& level = levels[n];
    if (level.grid.level() <= kDenseLevel) {
      level.grid.markAll();
    } else {
      const float cells = options.bandCells / static_cast<float>(1 << (samples.depth - level.grid.level()));
      markNearSamples(samples, std::max(3.0F, cells), level.grid);
      if (n + 1 < levels.size()) {
        markParents(levels[n + 1].grid, level.grid);
      }
    }
    level.grid.number();
  }
  return levels;
}

/// f on every level: V is splatted on the kernel level, carried exactly to finer levels (P) and f to coarser ones (P^T).
void makeRightHandSides(const CubeSamples& samples, const HierarchyOptions& options, std::vector<Level>& levels,
                        const ExecutionContext& context) {
  const std::size_t kernel = static_cast<std::size_t>(options.kernelLevel - kCoarsestLevel);
  const double kernelCell = options.cellMm * (1 << (samples.depth - options.kernelLevel));
  for (auto& level : levels) {
    level.f.assign(level.grid.nodeCount(), 0.0F);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto density = static_cast<float>(-1.0 / (kernelCell * kernelCell * kernelCell));
    Field v(levels[kernel].grid.nodeCount(), 0.0F);
    splat(samples, levels[kernel].grid, axis, density, v, context);
    for (std::size_t n = kernel; n < levels.size(); ++n) {
      if (n > kernel) {
        Field finer(levels[n].grid.nodeCount());
        prolong(levels[n - 1].grid, v, levels[n].grid, finer, 0, context);
        v = std::move(finer);
      }
      const double cell = options.cellMm * (1 << (samples.depth - levels[n].grid.level()));
      addDivergence(levels[n].grid, v, axis, static_cast<float>(cell), levels[n].f, context);
    }
  }
  for (std::size_t n = kernel; n-- > 0;) {
    restrictTo(levels[n + 1].grid, levels[n + 1].f, levels[n].grid, levels[n].f, 0.5F, context);
  }
}

/// Calls body(n) for the first node of every block and adds what it gives, in a fixed order: the same for any number of threads.
template <typename Body>
double sumOverBlocks(std::size_t nodes, const Body& body) {
  std::vector<double> parts(nodes / kBlockNodes);
  parallelFor(parts.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      parts[block] = body(block * kBlockNodes);
    }
  });
  double sum = 0;
  for (const double part : parts) {
    sum += part;
  }
  return sum;
}

/// Products of a block's values in double, in four sums side by side (a single one would wait for itself).
double dotOfBlock(const float* a, const float* b) {
  std::array<double, 4> sums{};
  for (std::size_t n = 0; n < kBlockNodes; n += sums.size()) {
    for (std::size_t lane = 0; lane < sums.size(); ++lane) {
      sums[lane] += static_cast<double>(a[n + lane]) * static_cast<double>(b[n + lane]);
    }
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double dot(const Field& a, const Field& b) {
  return sumOverBlocks(a.size(), [&](std::size_t n) { return dotOfBlock(&a[n], &b[n]); });
}

/// y += a x over one block.
void addTo(float* y, float a, const float* x) {
  for (std::size_t n = 0; n < kBlockNodes; ++n) {
    y[n] += a * x[n];
  }
}

/// x += alpha p and r -= alpha ap in one walk; gives r.r.
double step(Field& x, Field& r, const Field& p, const Field& ap, float alpha) {
  return sumOverBlocks(x.size(), [&](std::size_t n) {
    addTo(&x[n], alpha, &p[n]);
    addTo(&r[n], -alpha, &ap[n]);
    return dotOfBlock(&r[n], &r[n]);
  });
}

/// p = r + beta p.
void turn(Field& p, float beta, const Field& r) {
  parallelFor(p.size() / kBlockNodes, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin * kBlockNodes; n < end * kBlockNodes; ++n) {
      p[n] = beta * p[n] + r[n];
    }
  });
}

/// The screened operator: S u + (a h) * sum over samples of area * phi_i u(s), on the unknowns; a = pointWeight, h in mm cancels
/// one power.
class Operator {
 public:
  Operator(const CubeSamples& samples, const HierarchyOptions& options, const Level& level) : samples_(samples), level_(level) {
    const double cell = options.cellMm * (1 << (samples.depth - level.grid.level()));
    screening_ = static_cast<float>(options.pointWeight / cell);
    if (screening_ > 0) {
      weighted_ = samples;
    }
  }

  void apply(const Field& u, Field& out, const ExecutionContext& context) {
    applyStiffness(level_.grid, u, out, context);
    if (screening_ <= 0) {
      return;
    }
    const auto values = valuesAt(samples_, level_.grid, u, context);
    for (std::size_t n = 0; n < values.size(); ++n) {
      weighted_.weights[n] = samples_.weights[n] * values[n];
    }
    addScreening(out, context);
  }

  /// The right-hand side's share: every sample pulls towards 1/2.
  void addTarget(Field& f, const ExecutionContext& context) {
    if (screening_ > 0) {
      for (std::size_t n = 0; n < samples_.weights.size(); ++n) {
        weighted_.weights[n] = 0.5F * samples_.weights[n];
      }
      addScreening(f, context);
    }
  }

 private:
  void addScreening(Field& out, const ExecutionContext& context) {
    splat(weighted_, level_.grid, 3, screening_, out, context);
    for (std::size_t slot = 0; slot < level_.grid.blockCount(); ++slot) {
      level_.grid.clearFixedNodes(slot, out.data() + slot * kBlockNodes);
    }
  }

  const CubeSamples& samples_;
  const Level& level_;
  CubeSamples weighted_;
  float screening_ = 0;
};

void conjugateGradients(Operator& op, Level& level, int steps, const ExecutionContext& context) {
  Field ap(level.x.size());
  Field r = level.f;
  op.addTarget(r, context);
  op.apply(level.x, ap, context);
  for (std::size_t n = 0; n < r.size(); n += kBlockNodes) {
    addTo(&r[n], -1.0F, &ap[n]);
  }
  for (std::size_t slot = 0; slot < level.grid.blockCount(); ++slot) {
    level.grid.clearFixedNodes(slot, r.data() + slot * kBlockNodes);
  }
  Field p = r;
  double rr = dot(r, r);
  const double enough = 1e-10 * rr;
  for (int n = 0; n < steps && rr > enough && rr > 0; ++n) {
    context.throwIfCancelled();
    op.apply(p, ap, context);
    const double pap = dot(p, ap);
    if (!(pap > 0)) {
      break;
    }
    const double next = step(level.x, r, p, ap, static_cast<float>(rr / pap));
    turn(p, static_cast<float>(next / rr), r);
    rr = next;
  }
}

}  // namespace

std::vector<Level> solveIndicator(const CubeSamples& samples, const HierarchyOptions& options, const ExecutionContext& context) {
  std::vector<Level> levels = makeLevels(samples, options);
  makeRightHandSides(samples, options, levels, context);
  for (std::size_t n = 0; n < levels.size(); ++n) {
    Level& level = levels[n];
    level.x.assign(level.grid.nodeCount(), 0.0F);
    if (n > 0) {
      prolong(levels[n - 1].grid, levels[n - 1].x, level.grid, level.x, 0, context);
    }
    Operator op(samples, options, level);
    conjugateGradients(op, level, stepsOf(level.grid.level()), context);
    level.f = Field();
    // A level costs about four times the one before.
    context.report(std::pow(0.25, static_cast<double>(levels.size() - 1 - n)), "solve");
  }
  return levels;
}

float nodeValue(const std::vector<Level>& levels, std::size_t n, const Coord& node) {
  const int side = 1 << levels[n].grid.level();
  if (std::any_of(node.begin(), node.end(), [side](int c) { return c <= 0 || c >= side; })) {
    return 0.0F;
  }
  const std::int32_t slot = levels[n].grid.slot({node[0] / kBlock, node[1] / kBlock, node[2] / kBlock});
  if (slot >= 0) {
    return levels[n]
        .x[static_cast<std::size_t>(slot) * kBlockNodes + nodeIndex(node[0] % kBlock, node[1] % kBlock, node[2] % kBlock)];
  }
  float sum = 0;
  for (int c = 0; c < 8; ++c) {
    sum += nodeValue(levels, n - 1, {(node[0] + (c & 1)) / 2, (node[1] + ((c >> 1) & 1)) / 2, (node[2] + (c >> 2)) / 2});
  }
  return 0.125F * sum;
}

}  // namespace glisson::poisson
