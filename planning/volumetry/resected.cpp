#include "planning/volumetry/resected.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planning/volumetry/flat_stretches.h"
#include "planning/volumetry/parallel_append.h"
#include "planning/volumetry/run_counter.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {
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
  if (sideOf(box, plane) != RunSide::Across) {
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
      RunCounter counter(spacing, flat, part);
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
    RunCounter counter(spacing, plan, result);
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

std::vector<CutPiece> cutSurface(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<CutPiece> pieces;
  parallelAppend(rows.runs.size(), pieces, [&](std::size_t begin, std::size_t end, std::vector<CutPiece>& some) {
    std::vector<Polygon> parts;
    FlatStretches stretches(plan, spacing);
    for (std::size_t n = begin; n < end; ++n) {
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
              some.push_back({std::move(part), n, r, flat[r].planes[p].normal, off});
            }
          }
        }
      });
    }
  });
  return pieces;
}

}  // namespace glisson
