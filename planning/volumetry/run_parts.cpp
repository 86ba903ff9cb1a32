#include "planning/volumetry/run_parts.h"

#include <algorithm>

#include "planning/volumetry/flat_stretches.h"
#include "planning/volumetry/parallel_append.h"
#include "planning/volumetry/run_counter.h"

namespace glisson {

namespace {
/// Appends the parts of one run after the other.
class PartMaker {
 public:
  PartMaker(const Vec3& spacing, std::vector<RunPart>& parts) : spacing_(spacing), parts_(parts) {}

  void append(const RowRun& run, const std::vector<ImageResection>& plan) {
    const RunCounter counter(spacing_, plan, counted_);
    const RunSide side = counter.sideOfRun(run);
    if (side == RunSide::Outside) {
      join({run});
    } else if (side == RunSide::Inside) {
      RunPart part = counted(run, plan);
      part.resected = part.units();  // several resections' shares are rounded each for itself
      join(part);
    } else if (run.n == 1) {
      join(counted(run, plan));
    } else if (const OnlyPlane only = counter.onlyPlaneAcross(run); only.plane != nullptr) {
      appendCutByOne(run, only, plan);
    } else {
      const int half = run.n / 2;
      append({run.i, run.j, run.k, half}, plan);
      append({run.i + half, run.j, run.k, run.n - half}, plan);
    }
  }

 private:
  RunPart counted(const RowRun& run, const std::vector<ImageResection>& plan) {
    counted_.units.assign(plan.size(), 0);
    RunCounter(spacing_, plan, counted_).count(run);
    const auto most = std::max_element(counted_.units.begin(), counted_.units.end());
    return {run, counted_.totalUnits(), static_cast<std::size_t>(most - counted_.units.begin())};
  }

  /// Along a run the voxels are on one side first, then across, then on the other side.
  void appendCutByOne(const RowRun& run, const OnlyPlane& only, const std::vector<ImageResection>& plan) {
    const int end = run.i + run.n;
    const double start = only.plane->distance(spacing_.cwiseProduct(Vec3(run.i, run.j, run.k)));
    const double step = only.plane->normal[0] * spacing_[0];
    const double support = only.plane->support(0.5 * spacing_);
    const auto sideAt = [&](int i) { return sideOf(start + (i - run.i) * step, support); };
    const RunSide before = sideAt(run.i);
    const RunSide behind = sideAt(end - 1);
    const int first = before == RunSide::Across ? run.i : firstFrom(run.i, end, [&](int i) { return sideAt(i) != before; });
    const int stop = behind == RunSide::Across ? end : firstFrom(first, end, [&](int i) { return sideAt(i) == behind; });
    const auto appendWhole = [&](int from, int to, RunSide side) {
      if (from < to) {
        RunPart part{{from, run.j, run.k, to - from}};
        if (side == RunSide::Inside) {
          part.resected = part.units();
          part.owner = only.resection;
        }
        join(part);
      }
    };
    const auto appendAcross = [&](int from, int to) {
      if (from < to) {
        join(counted({from, run.j, run.k, to - from}, plan));
      }
    };
    appendWhole(run.i, first, before);
    // Voxels at either end may be touched so little that no unit is left for one side: these are on the other one.
    const auto isDivided = [&](int i) { return counted({i, run.j, run.k, 1}, plan).isDivided(); };
    int dividedFrom = first;
    while (dividedFrom < stop && !isDivided(dividedFrom)) {
      appendAcross(dividedFrom, dividedFrom + 1);
      ++dividedFrom;
    }
    int dividedTo = stop;
    while (dividedTo > dividedFrom && !isDivided(dividedTo - 1)) {
      --dividedTo;
    }
    appendAcross(dividedFrom, dividedTo);
    for (int i = dividedTo; i < stop; ++i) {
      appendAcross(i, i + 1);
    }
    appendWhole(stop, end, behind);
  }

  template <typename Is>
  static int firstFrom(int low, int high, const Is& is) {
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (is(middle)) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  /// Neighbours that are on the same side altogether are one part.
  void join(const RunPart& part) {
    if (!parts_.empty()) {
      RunPart& before = parts_.back();
      const bool follows = before.run.j == part.run.j && before.run.k == part.run.k && before.run.i + before.run.n == part.run.i;
      const bool none = before.resected == 0 && part.resected == 0;
      const bool all = before.resected == before.units() && part.resected == part.units() && before.owner == part.owner;
      if (follows && (none || all)) {
        before.run.n += part.run.n;
        before.resected += part.resected;
        return;
      }
    }
    parts_.push_back(part);
  }

  const Vec3& spacing_;
  std::vector<RunPart>& parts_;
  Resected counted_;  ///< scratch space
};
}  // namespace

std::vector<RunPart> partsOf(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<RunPart> parts;
  parallelAppend(rows.runs.size(), parts, [&](std::size_t begin, std::size_t end, std::vector<RunPart>& some) {
    PartMaker maker(spacing, some);
    FlatStretches stretches(plan, spacing);
    for (std::size_t n = begin; n < end; ++n) {
      stretches.along(rows.runs[n], [&](const RowRun& run, const std::vector<ImageResection>& flat) { maker.append(run, flat); });
    }
  });
  return parts;
}

}  // namespace glisson
