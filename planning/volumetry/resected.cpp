#include "planning/volumetry/resected.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planning/volumetry/box_fraction.h"
#include "planning/volumetry/flat_stretches.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {
enum class Side : std::uint8_t { Outside, Across, Inside };

/// A box that only touches the plane from outside is Across: the shared face is its section.
Side sideOf(const Box& box, const ImagePlane& plane) {
  const double distance = plane.distance(box.centre);
  const double support = plane.support(box.half);
  if (distance < -support - kOnPlaneMm) {
    return Side::Outside;
  }
  return distance < support - kOnPlaneMm ? Side::Across : Side::Inside;
}

/// The volume of (box and `taken`) outside resections [0, count), mm^3: outside a convex resection is the sum over its planes of
/// what lies inside the planes before and outside this one.
double volumeOutside(const Box& box, std::vector<ImagePlane>& taken, const std::vector<ImageResection>& plan, std::size_t count) {
  if (count == 0) {
    return volumeOf(box, taken);
  }
  const std::vector<ImagePlane>& planes = plan[count - 1].planes;
  for (const ImagePlane& plane : planes) {
    if (sideOf(box, plane) == Side::Outside) {
      return volumeOutside(box, taken, plan, count - 1);
    }
  }
  if (planes.empty()) {
    return volumeOutside(box, taken, plan, count - 1);
  }
  double sum = 0;
  const std::size_t before = taken.size();
  for (const ImagePlane& plane : planes) {
    if (sideOf(box, plane) == Side::Inside) {
      continue;
    }
    taken.push_back({-plane.normal, -plane.offset});
    sum += volumeOutside(box, taken, plan, count - 1);
    taken.back() = plane;
  }
  taken.resize(before);
  return sum;
}

class Counter {
 public:
  Counter(const Vec3& spacing, const std::vector<ImageResection>& plan, Resected& result)
      : spacing_(spacing), plan_(plan), result_(result) {}

  void count(const RowRun& run) {
    const Box box = boxOf(run, spacing_);
    std::size_t reached = 0;
    std::size_t first = 0;
    std::size_t across = 0;
    const ImagePlane* only = nullptr;
    for (std::size_t r = 0; r < plan_.size(); ++r) {
      std::size_t planesAcross = 0;
      const ImagePlane* last = nullptr;
      if (!reaches(box, plan_[r], planesAcross, last)) {
        continue;
      }
      if (reached++ == 0) {
        first = r;
        across = planesAcross;
        only = last;
      }
      if (planesAcross == 0) {
        break;  // what comes later finds nothing left
      }
    }
    if (reached == 0) {
      return;
    }
    if (across == 0) {
      result_.units[first] += whole(run);
    } else if (reached == 1 && across == 1) {
      const Vec3 widths = 2 * only->normal.cwiseAbs().cwiseProduct(box.half);
      // Touching from outside within rounding is touching: the section of the shared face is not lost.
      const double distance = std::max(only->distance(box.centre), -0.5 * widths.sum());
      const BoxCut cut = cutBox(distance, {widths[0], widths[1], widths[2]});
      result_.units[first] += std::llround(cut.fraction * run.n * kUnitsPerVoxel);
      singlePlaneArea_ += cut.density * 8 * box.half.prod();
    } else if (run.n > 1) {
      const int half = run.n / 2;
      count({run.i, run.j, run.k, half});
      count({run.i + half, run.j, run.k, run.n - half});
    } else {
      countVoxel(box);
    }
  }

  /// The section's area, where the plan is one plane: every run it cuts was counted in closed form.
  [[nodiscard]] double singlePlaneArea() const { return singlePlaneArea_; }

  /// Whether the run is on one side altogether, and on which.
  [[nodiscard]] Side sideOfRun(const RowRun& run) const {
    const Box box = boxOf(run, spacing_);
    Side side = Side::Outside;
    for (const ImageResection& resection : plan_) {
      std::size_t planesAcross = 0;
      const ImagePlane* last = nullptr;
      if (reaches(box, resection, planesAcross, last)) {
        if (planesAcross == 0) {
          return Side::Inside;
        }
        side = Side::Across;
      }
    }
    return side;
  }

 private:
  static std::int64_t whole(const RowRun& run) { return static_cast<std::int64_t>(run.n) << 32; }

  static bool reaches(const Box& box, const ImageResection& resection, std::size_t& planesAcross, const ImagePlane*& last) {
    for (const ImagePlane& plane : resection.planes) {
      const Side side = sideOf(box, plane);
      if (side == Side::Outside) {
        return false;
      }
      if (side == Side::Across) {
        ++planesAcross;
        last = &plane;
      }
    }
    return !resection.planes.empty();
  }

  void countVoxel(const Box& box) {
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

  const Vec3& spacing_;
  const std::vector<ImageResection>& plan_;
  Resected& result_;
  double singlePlaneArea_ = 0;
};

/// Appends the parts of `polygon` outside resections from `next` on (but `own`), the polygon lying on `plane` of resection `own`.
void appendOutside(Polygon polygon, const ImagePlane& plane, std::size_t own, std::size_t next, const Box& box,
                   const std::vector<ImageResection>& plan, std::vector<Polygon>& parts) {
  if (polygon.empty()) {
    return;
  }
  if (next == own) {
    ++next;
  }
  if (next >= plan.size()) {
    parts.push_back(std::move(polygon));
    return;
  }
  const double reach = 2 * box.half.norm();
  Polygon inside = std::move(polygon);
  for (const ImagePlane& other : plan[next].planes) {
    const Coplanar same = coplanar(plane, other, box.centre, reach);
    if (same == Coplanar::Same && own < next) {
      // One surface, two resections: the first one has it.
      appendOutside(std::move(inside), plane, own, next + 1, box, plan, parts);
      return;
    }
    if (same != Coplanar::No) {
      continue;
    }
    appendOutside(clipped(inside, {-other.normal, -other.offset}), plane, own, next + 1, box, plan, parts);
    inside = clipped(inside, other);
    if (inside.empty()) {
      return;
    }
  }
  if (plan[next].planes.empty()) {
    appendOutside(std::move(inside), plane, own, next + 1, box, plan, parts);
  }
}

/// The section of the box by one plane, where it bounds its own resection.
Polygon ownSection(const Box& box, const ImageResection& resection, std::size_t index) {
  const ImagePlane& plane = resection.planes[index];
  if (sideOf(box, plane) != Side::Across) {
    return {};
  }
  Polygon polygon = sectionOf(box, plane);
  const double reach = 2 * box.half.norm();
  for (std::size_t m = 0; m < resection.planes.size() && !polygon.empty(); ++m) {
    if (m == index) {
      continue;
    }
    const Coplanar same = coplanar(plane, resection.planes[m], box.centre, reach);
    if (same == Coplanar::Opposite || (same == Coplanar::Same && m < index)) {
      return {};
    }
    if (same == Coplanar::No) {
      polygon = clipped(polygon, resection.planes[m]);
    }
  }
  return polygon;
}

}  // namespace

std::int64_t Resected::totalUnits() const { return std::accumulate(units.begin(), units.end(), std::int64_t{0}); }

std::vector<ImageResection> toImage(const ResectionPlan& plan, const ImageGeometry& geometry) {
  std::vector<ImageResection> resections(plan.resections.size());
  for (std::size_t r = 0; r < resections.size(); ++r) {
    for (const ResectionPlane& plane : plan.resections[r].planes) {
      if (!plane.origin.allFinite() || !plane.normal.allFinite() || plane.normal.norm() < 1e-12) {
        throw PlanningError(plan.resections[r].name + " has a plane that is not finite; place it again.");
      }
      if (plane.bend) {
        resections[r].bends.push_back(BentSurface(checkedPlane(plane)).inFrame(geometry));
      } else {
        resections[r].planes.push_back(toImage(plane, geometry));
      }
    }
  }
  return resections;
}

namespace {
/// The runs [begin, end) of a plan with bends; cutAreaMm2 is right where the plan is one plane.
Resected resectBent(const VoxelRows& rows, std::size_t begin, std::size_t end, const Vec3& spacing,
                    const std::vector<ImageResection>& plan) {
  Resected part;
  part.units.resize(plan.size());
  part.cutAreaMm2.resize(plan.size());
  FlatStretches stretches(plan, spacing);
  for (std::size_t n = begin; n < end; ++n) {
    stretches.along(rows.runs[n], [&](const RowRun& run, const std::vector<ImageResection>& flat) {
      Counter counter(spacing, flat, part);
      counter.count(run);
      part.cutAreaMm2[0] += counter.singlePlaneArea();
    });
  }
  return part;
}

/// In parts of a fixed size and added in their order, so that the sums do not depend on the threads.
Resected resectBent(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  constexpr std::size_t kRuns = 512;
  std::vector<Resected> parts((rows.runs.size() + kRuns - 1) / kRuns);
  parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      parts[n] = resectBent(rows, n * kRuns, std::min((n + 1) * kRuns, rows.runs.size()), spacing, plan);
    }
  });
  Resected sum;
  sum.units.resize(plan.size());
  sum.cutAreaMm2.resize(plan.size());
  for (const Resected& part : parts) {
    for (std::size_t r = 0; r < plan.size(); ++r) {
      sum.units[r] += part.units[r];
      sum.cutAreaMm2[r] += part.cutAreaMm2[r];
    }
  }
  return sum;
}
}  // namespace

Resected resect(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  Resected result;
  if (hasBends(plan)) {
    result = resectBent(rows, spacing, plan);
    if (plan.size() == 1 && plan[0].bends.size() + plan[0].planes.size() == 1) {
      return result;
    }
    result.cutAreaMm2.assign(plan.size(), 0);
  } else {
    result.units.resize(plan.size());
    result.cutAreaMm2.resize(plan.size());
    Counter counter(spacing, plan, result);
    for (const RowRun& run : rows.runs) {
      counter.count(run);
    }
    if (plan.size() == 1 && plan[0].planes.size() == 1) {
      result.cutAreaMm2[0] = counter.singlePlaneArea();
      return result;
    }
  }
  for (const CutPiece& piece : cutSurface(rows, spacing, plan)) {
    result.cutAreaMm2[piece.resection] += areaOf(piece.polygon);
  }
  return result;
}

namespace {
/// Halves a run until every part is on one side or a single voxel; neighbours that are on the same side become one part again.
void appendParts(const RowRun& run, const Vec3& spacing, const std::vector<ImageResection>& plan, std::vector<RunPart>& parts) {
  Resected counted;
  counted.units.resize(plan.size());
  Counter counter(spacing, plan, counted);
  const Side side = counter.sideOfRun(run);
  if (side == Side::Across && run.n > 1) {
    const int half = run.n / 2;
    appendParts({run.i, run.j, run.k, half}, spacing, plan, parts);
    appendParts({run.i + half, run.j, run.k, run.n - half}, spacing, plan, parts);
    return;
  }
  RunPart part{run, 0, 0};
  if (side != Side::Outside) {
    counter.count(run);
    part.resected = counted.totalUnits();
    part.owner = static_cast<std::size_t>(std::max_element(counted.units.begin(), counted.units.end()) - counted.units.begin());
  }
  if (!parts.empty()) {
    RunPart& before = parts.back();
    const bool joins = before.run.j == run.j && before.run.k == run.k && before.run.i + before.run.n == run.i;
    const bool none = before.resected == 0 && part.resected == 0;
    const bool all = before.resected == before.units() && part.resected == part.units() && before.owner == part.owner;
    if (joins && (none || all)) {
      before.run.n += run.n;
      before.resected += part.resected;
      return;
    }
  }
  parts.push_back(part);
}
}  // namespace

std::vector<RunPart> partsOf(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<RunPart> parts;
  FlatStretches stretches(plan, spacing);
  for (const RowRun& run : rows.runs) {
    stretches.along(
        run, [&](const RowRun& piece, const std::vector<ImageResection>& flat) { appendParts(piece, spacing, flat, parts); });
  }
  return parts;
}

std::vector<CutPiece> cutSurface(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<CutPiece> pieces;
  std::vector<Polygon> parts;
  FlatStretches stretches(plan, spacing);
  for (std::size_t n = 0; n < rows.runs.size(); ++n) {
    stretches.along(rows.runs[n], [&](const RowRun& run, const std::vector<ImageResection>& flat) {
      const Box box = boxOf(run, spacing);
      for (std::size_t r = 0; r < flat.size(); ++r) {
        for (std::size_t p = 0; p < flat[r].planes.size(); ++p) {
          parts.clear();
          appendOutside(ownSection(box, flat[r], p), flat[r].planes[p], r, 0, box, flat, parts);
          // The bent planes are behind the flat ones, and what one cuts is a single voxel.
          const std::size_t flats = plan[r].planes.size();
          const double off = p < flats || parts.empty() ? 0.0 : flatteningMm(box, plan[r].bends[p - flats]);
          for (Polygon& part : parts) {
            pieces.push_back({std::move(part), n, r, flat[r].planes[p].normal, off});
          }
        }
      }
    });
  }
  return pieces;
}

}  // namespace glisson
