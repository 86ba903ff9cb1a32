#include "planning/volumetry/resected.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "planning/volumetry/cut_maker.h"
#include "planning/volumetry/flat_stretches.h"
#include "planning/volumetry/parallel_append.h"
#include "planning/volumetry/run_counter.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

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

bool isResected(const Box& box, const std::vector<ImageResection>& plan) {
  return std::any_of(plan.begin(), plan.end(), [&](const ImageResection& resection) {
    return !resection.takesNothing() && std::all_of(resection.planes.begin(), resection.planes.end(), [&](const ImagePlane& plane) {
      return plane.distance(box.centre) >= plane.support(box.half);
    }) && std::all_of(resection.bends.begin(), resection.bends.end(), [&](const BentSurface& bend) {
      return bend.above(box.centre) >= bend.reach(box.half);
    });
  });
}

namespace {
bool isOnePlane(const std::vector<ImageResection>& plan) {
  return plan.size() == 1 && plan[0].bends.size() + plan[0].planes.size() == 1;
}

/// In parts of a fixed size and added in their order, so that the sums do not depend on the threads. `count`(n, stretches, part)
/// counts thing n of `things`.
template <typename Count>
Resected resectBent(std::size_t things, std::size_t atOnce, const Vec3& spacing, const std::vector<ImageResection>& plan,
                    const Count& count) {
  Resected sum;
  sum.units.resize(plan.size());
  sum.cutAreaMm2.resize(plan.size());
  std::vector<Resected> parts((things + atOnce - 1) / atOnce, sum);
  parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    FlatStretches stretches(plan, spacing);
    for (std::size_t n = begin * atOnce; n < std::min(end * atOnce, things); ++n) {
      count(n, stretches, parts[n / atOnce]);
    }
  });
  for (const Resected& part : parts) {
    for (std::size_t r = 0; r < plan.size(); ++r) {
      sum.units[r] += part.units[r];
      sum.cutAreaMm2[r] += part.cutAreaMm2[r];
    }
  }
  return sum;
}

/// One run of a plan with bends; cutAreaMm2 is right where the plan is one plane.
void countRun(const RowRun& run, const Vec3& spacing, FlatStretches& stretches, Resected& part) {
  stretches.along(run, [&](const RowRun& stretch, const std::vector<ImageResection>& flat) {
    RunCounter counter(spacing, flat, part);
    counter.count(stretch);
    part.cutAreaMm2[0] += counter.singlePlaneArea();
  });
}

void setAreas(const std::vector<CutPiece>& pieces, std::size_t resections, Resected& result) {
  result.cutAreaMm2.assign(resections, 0);
  for (const CutPiece& piece : pieces) {
    result.cutAreaMm2[piece.resection] += areaOf(piece.polygon);
  }
}

/// Areas only where the plan is one plane.
Resected counted(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  Resected result;
  if (hasBends(plan)) {
    constexpr std::size_t kRuns = 512;
    result = resectBent(rows.runs.size(), kRuns, spacing, plan, [&](std::size_t n, FlatStretches& stretches, Resected& part) {
      countRun(rows.runs[n], spacing, stretches, part);
    });
  } else {
    result.units.resize(plan.size());
    result.cutAreaMm2.resize(plan.size());
    RunCounter counter(spacing, plan, result);
    for (const RowRun& run : rows.runs) {
      counter.count(run);
    }
    if (isOnePlane(plan)) {
      result.cutAreaMm2[0] = counter.singlePlaneArea();
    }
  }
  return result;
}

Resected counted(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  constexpr std::size_t kBlocks = 64;
  const auto count = [&](std::size_t n, FlatStretches& stretches, Resected& part) {
    const RowBlock& block = blocks.blocks[n];
    const std::vector<ImageResection>* flat = stretches.over(block.box);
    if (flat != nullptr && RunCounter(spacing, *flat, part).countUndivided(block.box, block.voxels)) {
      return;
    }
    stretches.stayWithin(block.box);
    for (std::size_t run = block.begin; run < block.end; ++run) {
      countRun(blocks.rows.runs[run], spacing, stretches, part);
    }
  };
  return resectBent(blocks.blocks.size(), kBlocks, spacing, plan, count);
}

template <typename Voxels>
Resected withAreas(const Voxels& voxels, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  Resected result = counted(voxels, spacing, plan);
  if (!isOnePlane(plan)) {
    setAreas(cutSurface(voxels, spacing, plan), plan.size(), result);
  }
  return result;
}
}  // namespace

Resected resect(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  return withAreas(rows, spacing, plan);
}

Resected resect(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  return withAreas(blocks, spacing, plan);
}

std::int64_t resectedUnits(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  return counted(rows, spacing, plan).totalUnits();
}

std::int64_t resectedUnits(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  return counted(blocks, spacing, plan).totalUnits();
}

std::vector<CutPiece> cutSurface(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<CutPiece> pieces;
  parallelAppend(rows.runs.size(), pieces, [&](std::size_t begin, std::size_t end, std::vector<CutPiece>& some) {
    CutMaker maker(plan, spacing);
    for (std::size_t n = begin; n < end; ++n) {
      maker.append(rows.runs[n], n, some);
    }
  });
  return pieces;
}

std::vector<std::size_t> cutBlocks(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<std::size_t> cut;
  parallelAppend(blocks.blocks.size(), cut, [&](std::size_t begin, std::size_t end, std::vector<std::size_t>& some) {
    CutMaker maker(plan, spacing);
    for (std::size_t n = begin; n < end; ++n) {
      if (maker.mayCut(blocks.blocks[n].box)) {
        some.push_back(n);
      }
    }
  });
  return cut;
}

std::vector<CutPiece> cutSurface(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan) {
  std::vector<std::size_t> runs;
  for (const std::size_t n : cutBlocks(blocks, spacing, plan)) {
    for (std::size_t run = blocks.blocks[n].begin; run < blocks.blocks[n].end; ++run) {
      runs.push_back(run);
    }
  }
  std::sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(blocks.origin[a], blocks.rows.runs[a].i) < std::pair(blocks.origin[b], blocks.rows.runs[b].i);
  });
  std::vector<CutPiece> pieces;
  parallelAppend(runs.size(), pieces, [&](std::size_t begin, std::size_t end, std::vector<CutPiece>& some) {
    CutMaker maker(plan, spacing);
    for (std::size_t n = begin; n < end; ++n) {
      maker.append(blocks.rows.runs[runs[n]], blocks.origin[runs[n]], some);
    }
  });
  return pieces;
}

}  // namespace glisson
