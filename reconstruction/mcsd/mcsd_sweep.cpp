// The sets of a sweep as a tree of stages: extraction - one branch per decimation (DecimateFirst) or filter (SmoothFirst) - one
// twig per set. Branches run on several threads, the most work first; each thread takes the next one when it is free.
#include <algorithm>
#include <atomic>
#include <map>
#include <memory>

#include "reconstruction/errors.h"
#include "reconstruction/mcsd/mcsd_stages.h"
#include "reconstruction/mesh/sharp_edges.h"
#include "reconstruction/parallel.h"
#include "reconstruction/stopwatch.h"

namespace glisson {

namespace {
using mcsd::IndexSurface;
using Sets = std::vector<std::size_t>;

/// A surface between two stages, shared by all that go on from it, and the seconds that led to it.
struct Staged {
  std::shared_ptr<const IndexSurface> surface;
  double extractSeconds = 0.0;
  double decimateSeconds = 0.0;
  double smoothSeconds = 0.0;
};

/// `from` with the surface that `step` makes of it; its time is added to `seconds`.
template <typename Step>
Staged after(const Staged& from, double Staged::*seconds, Step&& step) {
  const Stopwatch stopwatch;
  Staged next = from;
  next.surface = std::make_shared<const IndexSurface>(step());
  next.*seconds += stopwatch.seconds();
  return next;
}

/// Sets that have their first stage in common.
struct SweepBranch {
  McsdOrder order = McsdOrder::DecimateFirst;
  double decimation = 0.0;                         ///< of DecimateFirst
  SmoothingFilter filter = SmoothingFilter::Sinc;  ///< of SmoothFirst
  Sets sets;
  double work = 0.0;  ///< an estimate, for the order of branches and for progress
};

/// The progress of a branch: a step for the common stage and one for every set.
class Steps {
 public:
  Steps(ExecutionContext context, std::size_t sets) : context_(std::move(context)), all_(static_cast<double>(sets + 1)) {}
  /// The part of the next `count` steps.
  ExecutionContext next(std::size_t count) {
    const double from = static_cast<double>(done_) / all_;
    done_ += count;
    return context_.range(from, static_cast<double>(done_) / all_);
  }

 private:
  ExecutionContext context_;
  double all_;
  std::size_t done_ = 0;
};

class Sweep {
 public:
  Sweep(const ImageGeometry& geometry, std::span<const McsdParameters> sets, const McsdVisitor& visit)
      : geometry_(geometry), parameters_(sets), visit_(visit) {}

  [[nodiscard]] std::vector<SweepBranch> branches() const;
  void run(const SweepBranch& branch, const Staged& extracted, const ExecutionContext& context) const;

 private:
  /// `sets` told apart by `key`, in ascending order of it.
  template <typename Key>
  auto groupedBy(const Sets& sets, Key key) const {
    std::map<std::remove_cvref_t<decltype(parameters_[0].*key)>, Sets> groups;
    for (const std::size_t set : sets) {
      groups[parameters_[set].*key].push_back(set);
    }
    return groups;
  }

  [[nodiscard]] Staged oriented(const Staged& from) const;
  static Staged decimated(const Staged& from, double share, const ExecutionContext& context);
  /// Calls use(smoothed surface, sets that ask for it, their progress) for all `sets`, which share a filter.
  template <typename Use>
  void smoothEach(const Staged& from, SmoothingFilter filter, const Sets& sets, Steps& steps, Use&& use) const;
  void decimateEach(const Staged& from, const Sets& sets, const ExecutionContext& context) const;
  void finish(const Staged& made, const Sets& sets, const ExecutionContext& context) const;

  const ImageGeometry& geometry_;
  std::span<const McsdParameters> parameters_;
  const McsdVisitor& visit_;
};

std::vector<SweepBranch> Sweep::branches() const {
  constexpr double kStageWork = 20.0;  // a decimation or a check costs about as much as 20 iterations
  std::map<std::pair<int, double>, SweepBranch> found;
  for (std::size_t set = 0; set < parameters_.size(); ++set) {
    const McsdParameters& p = parameters_[set];
    const bool decimateFirst = p.order == McsdOrder::DecimateFirst;
    SweepBranch& branch = found[decimateFirst ? std::pair(0, p.decimation) : std::pair(1 + static_cast<int>(p.filter), 0.0)];
    branch.order = p.order;
    branch.decimation = p.decimation;
    branch.filter = p.filter;
    branch.sets.push_back(set);
    branch.work += kStageWork + p.smoothing * (decimateFirst ? 1.0 - p.decimation : 1.0);
  }
  std::vector<SweepBranch> branches;
  branches.reserve(found.size());
  for (auto& [key, branch] : found) {
    branches.push_back(std::move(branch));
  }
  std::stable_sort(branches.begin(), branches.end(), [](const SweepBranch& a, const SweepBranch& b) { return a.work > b.work; });
  return branches;
}

Staged Sweep::oriented(const Staged& from) const {
  if (!geometry_.leftHanded()) {
    return from;
  }
  return after(from, &Staged::extractSeconds, [&] { return mcsd::reversed(*from.surface); });
}

Staged Sweep::decimated(const Staged& from, double share, const ExecutionContext& context) {
  if (share == 0.0) {
    return from;
  }
  return after(from, &Staged::decimateSeconds, [&] { return mcsd::decimate(*from.surface, share, context); });
}

template <typename Use>
void Sweep::smoothEach(const Staged& from, SmoothingFilter filter, const Sets& sets, Steps& steps, Use&& use) const {
  const auto groups = groupedBy(sets, &McsdParameters::smoothing);
  const bool goesOn = filter == SmoothingFilter::Laplacian && groups.size() > 1 && mcsd::everyEdgeHasTwoTriangles(*from.surface);
  Staged last = from;
  int done = 0;
  for (const auto& [iterations, same] : groups) {
    const ExecutionContext part = steps.next(same.size());
    if (iterations > 0) {
      const Staged start = goesOn ? last : from;
      const int missing = goesOn ? iterations - done : iterations;
      last =
          after(start, &Staged::smoothSeconds, [&] { return mcsd::smooth(*start.surface, filter, missing, part.range(0.0, 0.5)); });
      done = iterations;
    }
    use(last, same, part.range(0.5, 1.0));
  }
}

void Sweep::decimateEach(const Staged& from, const Sets& sets, const ExecutionContext& context) const {
  const auto groups = groupedBy(sets, &McsdParameters::decimation);
  std::vector<std::pair<double, Sets>> list(groups.begin(), groups.end());
  parallelFor(list.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto part = context.range(static_cast<double>(n) / static_cast<double>(list.size()),
                                      static_cast<double>(n + 1) / static_cast<double>(list.size()));
      finish(decimated(from, list[n].first, part.range(0.0, 0.5)), list[n].second, part.range(0.5, 1.0));
    }
  });
}

void Sweep::finish(const Staged& made, const Sets& sets, const ExecutionContext& context) const {
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const auto part = context.range(static_cast<double>(n) / static_cast<double>(sets.size()),
                                    static_cast<double>(n + 1) / static_cast<double>(sets.size()));
    McsdResult result{toWorld(*made.surface, geometry_), made.extractSeconds, made.decimateSeconds, made.smoothSeconds};
    if (parameters_[sets[n]].splitNormals) {
      result.mesh = splitAtSharpEdges(result.mesh);
    }
    visit_(sets[n], std::move(result), part);
  }
}

void Sweep::run(const SweepBranch& branch, const Staged& extracted, const ExecutionContext& context) const {
  Steps steps(context, branch.sets.size());
  if (branch.order == McsdOrder::SmoothFirst) {
    (void)steps.next(1);
    smoothEach(oriented(extracted), branch.filter, branch.sets, steps,
               [&](const Staged& smoothed, const Sets& same, const ExecutionContext& part) { decimateEach(smoothed, same, part); });
    return;
  }
  const Staged surface = oriented(decimated(extracted, branch.decimation, steps.next(1)));
  for (const auto& [filter, sets] : groupedBy(branch.sets, &McsdParameters::filter)) {
    smoothEach(surface, filter, sets, steps,
               [&](const Staged& smoothed, const Sets& same, const ExecutionContext& part) { finish(smoothed, same, part); });
  }
}
}  // namespace

void sweepMcsd(const Mask& mask, const ImageGeometry& geometry, std::span<const McsdParameters> sets, const McsdVisitor& visit,
               const ExecutionContext& context) {
  for (const McsdParameters& parameters : sets) {
    parameters.validate();
  }
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  if (sets.empty()) {
    return;
  }
  const Sweep sweep(geometry, sets, visit);
  const std::vector<SweepBranch> branches = sweep.branches();
  const double extractShare = 0.3 / static_cast<double>(sets.size());
  const Staged extracted =
      after({}, &Staged::extractSeconds, [&] { return mcsd::extractSurface(mask, context.range(0.0, extractShare)); });
  std::vector<double> start{0.0};
  for (const SweepBranch& branch : branches) {
    start.push_back(start.back() + branch.work);
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  // Each body takes the next branch in order, whatever its own number: the greatest ones first on every thread.
  parallelFor(branches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end && !failed; ++n) {
      const std::size_t taken = next++;
      const auto fraction = [&](double work) { return extractShare + (1.0 - extractShare) * work / start.back(); };
      try {
        sweep.run(branches[taken], extracted, context.range(fraction(start[taken]), fraction(start[taken + 1])));
      } catch (...) {
        failed = true;
        throw;
      }
    }
  });
  context.report(1.0, "marching cubes, smoothing, decimation");
}

}  // namespace glisson
