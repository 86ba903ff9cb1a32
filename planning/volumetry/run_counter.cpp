#include "planning/volumetry/run_counter.h"

#include <algorithm>
#include <cmath>

#include "planning/volumetry/box_fraction.h"

namespace glisson {

namespace {
/// The volume of (box and `taken`) outside resections [0, count), mm^3: outside a convex resection is the sum over its planes of
/// what lies inside the planes before and outside this one.
double volumeOutside(const Box& box, std::vector<ImagePlane>& taken, const std::vector<ImageResection>& plan, std::size_t count) {
  if (count == 0) {
    return volumeOf(box, taken);
  }
  const std::vector<ImagePlane>& planes = plan[count - 1].planes;
  for (const ImagePlane& plane : planes) {
    if (sideOf(box, plane) == RunSide::Outside) {
      return volumeOutside(box, taken, plan, count - 1);
    }
  }
  if (planes.empty()) {
    return volumeOutside(box, taken, plan, count - 1);
  }
  double sum = 0;
  const std::size_t before = taken.size();
  for (const ImagePlane& plane : planes) {
    if (sideOf(box, plane) == RunSide::Inside) {
      continue;
    }
    taken.push_back({-plane.normal, -plane.offset});
    sum += volumeOutside(box, taken, plan, count - 1);
    taken.back() = plane;
  }
  taken.resize(before);
  return sum;
}

/// Whether the resection has a part of the box; then how many of its planes cut it, and the last of them.
bool reaches(const Box& box, const ImageResection& resection, std::size_t& planesAcross, const ImagePlane*& last) {
  for (const ImagePlane& plane : resection.planes) {
    const RunSide side = sideOf(box, plane);
    if (side == RunSide::Outside) {
      return false;
    }
    if (side == RunSide::Across) {
      ++planesAcross;
      last = &plane;
    }
  }
  return !resection.planes.empty();
}

std::int64_t whole(const RowRun& run) { return static_cast<std::int64_t>(run.n) << 32; }
}  // namespace

RunCounter::RunCounter(const Vec3& spacing, const std::vector<ImageResection>& plan, Resected& result)
    : spacing_(spacing), plan_(plan), result_(result) {}

RunCounter::Reached RunCounter::reachedBy(const Box& box) const {
  Reached reached;
  for (std::size_t r = 0; r < plan_.size(); ++r) {
    std::size_t planesAcross = 0;
    const ImagePlane* last = nullptr;
    if (!reaches(box, plan_[r], planesAcross, last)) {
      continue;
    }
    if (reached.resections++ == 0) {
      reached.first = r;
      reached.planesAcross = planesAcross;
      reached.only = last;
    }
    if (planesAcross == 0) {
      reached.rest = reached.resections == 2 ? std::optional(r) : std::nullopt;
      break;  // what comes later finds nothing left
    }
  }
  return reached;
}

void RunCounter::count(const RowRun& run) {
  const Box box = boxOf(run, spacing_);
  const Reached reached = reachedBy(box);
  if (reached.resections == 0) {
    return;
  }
  if (reached.planesAcross == 0) {
    result_.units[reached.first] += whole(run);
  } else if (reached.planesAcross == 1 && (reached.resections == 1 || reached.rest)) {
    const std::int64_t units = unitsAbove(*reached.only, run, box);
    result_.units[reached.first] += units;
    if (reached.rest) {
      result_.units[*reached.rest] += whole(run) - units;
    }
  } else if (run.n > 1) {
    const int half = run.n / 2;
    count({run.i, run.j, run.k, half});
    count({run.i + half, run.j, run.k, run.n - half});
  } else {
    countVoxel(box);
  }
}

std::int64_t RunCounter::unitsAbove(const ImagePlane& plane, const RowRun& run, const Box& box) {
  const Vec3 widths = 2 * plane.normal.cwiseAbs().cwiseProduct(box.half);
  // Touching from outside within rounding is touching: the section of the shared face is not lost.
  const double distance = std::max(plane.distance(box.centre), -0.5 * widths.sum());
  const BoxCut cut = cutBox(distance, {widths[0], widths[1], widths[2]});
  singlePlaneArea_ += cut.density * 8 * box.half.prod();
  return std::llround(cut.fraction * run.n * kUnitsPerVoxel);
}

bool RunCounter::countUndivided(const Box& box, std::size_t voxels) {
  const Reached reached = reachedBy(box);
  if (reached.planesAcross > 0) {
    return false;
  }
  if (reached.resections > 0) {
    result_.units[reached.first] += static_cast<std::int64_t>(voxels) << 32;
  }
  return true;
}

RunSide RunCounter::sideOfBox(const Box& box) const {
  RunSide side = RunSide::Outside;
  for (const ImageResection& resection : plan_) {
    std::size_t planesAcross = 0;
    const ImagePlane* last = nullptr;
    if (reaches(box, resection, planesAcross, last)) {
      if (planesAcross == 0) {
        return RunSide::Inside;
      }
      side = RunSide::Across;
    }
  }
  return side;
}

OnlyPlane RunCounter::onlyPlaneAcross(const RowRun& run) const {
  const Reached reached = reachedBy(boxOf(run, spacing_));
  return reached.resections == 1 && reached.planesAcross == 1 ? OnlyPlane{reached.only, reached.first} : OnlyPlane{};
}

void RunCounter::countVoxel(const Box& box) {
  const double volume = 8 * box.half.prod();
  auto left = static_cast<std::int64_t>(kUnitsPerVoxel);
  std::vector<ImagePlane> taken;
  for (std::size_t r = 0; r < plan_.size(); ++r) {
    std::size_t planesAcross = 0;
    const ImagePlane* last = nullptr;
    if (!reaches(box, plan_[r], planesAcross, last)) {
      continue;
    }
    taken = plan_[r].planes;
    const double part = volumeOutside(box, taken, plan_, r) / volume;
    const std::int64_t units = std::min<std::int64_t>(std::llround(part * kUnitsPerVoxel), left);
    result_.units[r] += units;
    left -= units;
  }
}

}  // namespace glisson
