#include "reconstruction/poisson/solve.h"

#include <algorithm>

#include "reconstruction/parallel.h"

namespace glisson::poisson {

namespace {

constexpr std::size_t kSolveGrain = 64;  // blocks a piece in vector loops

/// Calls body(n) for the first node of every block and adds what it gives, in a fixed order: the same for any number of threads.
template <typename Body>
double sumOverBlocks(std::size_t nodes, const Body& body) {
  std::vector<double> parts(nodes / kBlockNodes);
  parallelFor(parts.size(), kSolveGrain, [&](std::size_t begin, std::size_t end) {
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
  parallelFor(p.size() / kBlockNodes, kSolveGrain, [&](std::size_t begin, std::size_t end) {
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
  }

  void apply(const Field& u, Field& out, const ExecutionContext& context) const {
    applyStiffness(level_.grid, u, out, context);
    if (screening_ > 0) {
      auto values = valuesAt(samples_, level_.grid, u, context);
      for (std::size_t n = 0; n < values.size(); ++n) {
        values[n] *= samples_.weights[n];
      }
      addScreening(values, out, context);
    }
  }

  /// The right-hand side's share: every sample pulls towards 1/2.
  void addTarget(Field& f, const ExecutionContext& context) const {
    if (screening_ > 0) {
      auto values = samples_.weights;
      for (float& value : values) {
        value *= 0.5F;
      }
      addScreening(values, f, context);
    }
  }

 private:
  void addScreening(std::span<const float> values, Field& out, const ExecutionContext& context) const {
    splat(samples_, values, level_.grid, screening_, out, context);
    for (std::size_t slot = 0; slot < level_.grid.blockCount(); ++slot) {
      level_.grid.clearFixedNodes(slot, out.data() + slot * kBlockNodes);
    }
  }

  const CubeSamples& samples_;
  const Level& level_;
  float screening_ = 0;
};

// These leave a liver's surface 3 micrometres (mean) and 0.05 mm (worst) from where a thousand steps would: docs/poisson.md.
constexpr int kSolvedLevel = 4;  // up to here a level is solved to the end
constexpr int kStepsToTheEnd = 40;
constexpr int kDenseSteps = 16;
constexpr int kBandSteps = 8;
constexpr float kCondition = 16.0F;
constexpr int kScreenedSteps = 14;  // the screened operator's largest eigenvalue is not known

}  // namespace

void conjugateGradients(const CubeSamples& samples, const HierarchyOptions& options, Level& level, int steps,
                        const ExecutionContext& context) {
  const Operator op(samples, options, level);
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

void chebyshev(const BlockGrid& grid, const Field& f, Field& x, int steps, float condition, const ExecutionContext& context) {
  // x_{n+1} = x_n + rho_n rho_{n-1} (x_n - x_{n-1}) + 2 rho_n / delta (f - S x_n), the eigenvalues within centre +- delta.
  const float centre = 0.5F * kLargestEigenvalue * (1 + 1 / condition);
  const float delta = 0.5F * kLargestEigenvalue * (1 - 1 / condition);
  Field other(x.size());
  float rho = delta / centre;
  iterate(grid, x, f, 0.0F, 1 / centre, other, context);
  for (int n = 1; n < steps; ++n) {
    std::swap(x, other);
    const float next = 1 / (2 * centre / delta - rho);
    iterate(grid, x, f, next * rho, 2 * next / delta, other, context);
    rho = next;
  }
  std::swap(x, other);
}

void solveLevels(const CubeSamples& samples, const HierarchyOptions& options, std::vector<Level>& levels,
                 const ExecutionContext& context) {
  for (std::size_t n = 0; n < levels.size(); ++n) {
    Level& level = levels[n];
    if (n == 0) {
      level.x = zeroField(level.grid.nodeCount());
    } else {
      level.x = Field(level.grid.nodeCount());
      prolong(levels[n - 1].grid, levels[n - 1].x, level.grid, level.x, context);
    }
    if (level.grid.level() <= kSolvedLevel) {
      conjugateGradients(samples, options, level, kStepsToTheEnd, context);
    } else if (options.pointWeight > 0) {
      conjugateGradients(samples, options, level, kScreenedSteps, context);
    } else {
      chebyshev(level.grid, level.f, level.x, level.grid.level() <= kDenseLevel ? kDenseSteps : kBandSteps, kCondition, context);
    }
    level.f = Field();
    // A level costs about four times the one before.
    context.report(std::pow(0.25, static_cast<double>(levels.size() - 1 - n)), "solve");
  }
}

}  // namespace glisson::poisson
