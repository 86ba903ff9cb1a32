#include "planning/volumetry/flat_stretches.h"

#include <algorithm>

namespace glisson {

namespace {
/// Stands for a bent plane that is far away: farther than any box reaches.
constexpr double kFarMm = 1e9;

bool isBent(const ImageResection& resection) { return !resection.bends.empty(); }

/// How far the surface can be from the plane that stands for it in a voxel where nothing is curved more than this: a half from the
/// touching plane, a sixth from its move to the mean height.
double flatteningOf(double mostCurved, double u, double v) { return (1.0 / 2 + 1.0 / 6) * mostCurved * (u * u + v * v); }

double slackOf(const BentSurface& surface, const Vec3& spacing) {
  const double u = surface.u().cwiseAbs().dot(0.5 * spacing);
  const double v = surface.v().cwiseAbs().dot(0.5 * spacing);
  return flatteningOf(surface.shape().mostCurved(), u, v);
}

/// How far above() can be from its value at the box's centre, by the touching plane there and the surface's curvature.
double reachByCurvature(const BentSurface& surface, const Box& box) {
  const Slab slab = slabOf(box, surface);
  return slab.slope.cwiseAbs().dot(box.half) + slab.off;
}
}  // namespace

bool hasBends(const std::vector<ImageResection>& plan) { return std::any_of(plan.begin(), plan.end(), isBent); }

Slab slabOf(const Box& box, const BentSurface& surface) {
  const BendShape::Local local = surface.localAt(box.centre);
  const double u = surface.u().cwiseAbs().dot(box.half);
  const double v = surface.v().cwiseAbs().dot(box.half);
  return {surface.normal() - local.du * surface.u() - local.dv * surface.v(),
          surface.normal().dot(box.centre - surface.origin()) - local.height, 0.5 * surface.shape().mostCurved() * (u * u + v * v)};
}

ImagePlane planeIn(const Box& voxel, const BentSurface& surface) {
  const BendShape::Local local = surface.localAt(voxel.centre);
  const Vec3 slope = surface.normal() - local.du * surface.u() - local.dv * surface.v();
  const Vec3 u = surface.u().cwiseProduct(voxel.half);
  const Vec3 v = surface.v().cwiseProduct(voxel.half);
  const double mean = local.height + (local.duu * u.squaredNorm() + 2 * local.duv * u.dot(v) + local.dvv * v.squaredNorm()) / 6;
  const double above = surface.normal().dot(voxel.centre - surface.origin()) - mean;
  const double length = slope.norm();
  const Vec3 normal = slope / length;
  return {normal, above / length - normal.dot(voxel.centre)};
}

double flatteningMm(const Box& voxel, const BentSurface& surface) {
  const BendShape& shape = surface.shape();
  const double u = surface.u().cwiseAbs().dot(voxel.half);
  const double v = surface.v().cwiseAbs().dot(voxel.half);
  const Vec3 from = voxel.centre - surface.origin();
  const double farthest = std::max(std::abs(surface.u().dot(from)) + u, std::abs(surface.v().dot(from)) + v);
  const double curved = farthest < shape.halfSizeMm() ? shape.mostCurvedInside() : shape.mostCurved();
  return flatteningOf(curved, u, v);
}

FlatStretches::FlatStretches(const std::vector<ImageResection>& plan, const Vec3& spacing) : plan_(plan), spacing_(spacing) {
  if (!hasBends(plan)) {
    return;
  }
  flat_ = plan;
  for (std::size_t r = 0; r < plan.size(); ++r) {
    flat_[r].bends.clear();
    for (const BentSurface& surface : plan[r].bends) {
      const Changes changes = changesEverywhere(surface, spacing);
      bends_.push_back({&surface, r, flat_[r].planes.size(), slackOf(surface, spacing), changes, changes, 0});
      flat_[r].planes.emplace_back();
    }
  }
}

FlatStretches::Changes FlatStretches::changesEverywhere(const BentSurface& surface, const Vec3& spacing) {
  const auto times = [](const Range& slopes, double step) {
    return step < 0 ? Range{slopes.high * step, slopes.low * step} : Range{slopes.low * step, slopes.high * step};
  };
  const Range alongU = times(surface.shape().slopesU(), surface.u()[0] * spacing[0]);
  const Range alongV = times(surface.shape().slopesV(), surface.v()[0] * spacing[0]);
  const double rise = surface.normal()[0] * spacing[0];
  return {surface.reach(0.5 * spacing), {rise - alongU.high - alongV.high, rise - alongU.low - alongV.low}};
}

/// By the slopes at the box's centre, and how far they can be from it within the box.
FlatStretches::Changes FlatStretches::changesWithin(const Box& box, const Bent& bent) const {
  const BentSurface& surface = *bent.surface;
  const auto extent = [&](const Vec3& half) {
    return std::hypot(surface.u().cwiseAbs().dot(half), surface.v().cwiseAbs().dot(half));
  };
  const double turn = surface.shape().mostCurved() * extent(box.half);
  const Vec3 slope = slabOf(box, surface).slope;
  // A stand-in reaches farther than the surface.
  const double reach = slope.cwiseAbs().dot(0.5 * spacing_) + turn * extent(0.5 * spacing_) + bent.slack + 2 * kOnPlaneMm;
  const double step = slope[0] * spacing_[0];
  const double spread = turn * extent(Vec3(spacing_[0], 0, 0));
  return {std::min(reach, bent.everywhere.reach),
          {std::max(step - spread, bent.everywhere.perVoxel.low), std::min(step + spread, bent.everywhere.perVoxel.high)}};
}

void FlatStretches::stayWithin(const Box& box) {
  // What several planes leave of a stretch depends in its last digits on where it ends.
  if (plan_.size() != 1 || plan_[0].planes.size() + bends_.size() != 1) {
    return;
  }
  for (Bent& bent : bends_) {
    bent.here = changesWithin(box, bent);
  }
}

void FlatStretches::decide(Bent& bent, const RowRun& rest) {
  const Box voxel = boxOf({rest.i, rest.j, rest.k, 1}, spacing_);
  ImagePlane& plane = flat_[bent.resection].planes[bent.plane];
  const double above = bent.surface->above(voxel.centre);
  const double clear = std::abs(above) - bent.here.reach;
  if (!(clear > 0)) {
    plane = planeIn(voxel, *bent.surface);
    bent.until = rest.i + 1;
    return;
  }
  plane = {bent.surface->normal(), above > 0 ? kFarMm : -kFarMm};
  // The next voxel that may reach the surface, at the fastest approach.
  const double approach = above > 0 ? -bent.here.perVoxel.low : bent.here.perVoxel.high;
  const double voxels = approach > 0 ? std::ceil(clear / approach) : rest.n;
  bent.until = rest.i + (voxels < rest.n ? std::max(1, static_cast<int>(voxels)) : rest.n);
}

const std::vector<ImageResection>* FlatStretches::over(const Box& box) {
  if (bends_.empty()) {
    return &plan_;
  }
  for (const Bent& bent : bends_) {
    const double above = bent.surface->above(box.centre);
    const double clear = std::abs(above) - bent.slack;
    if (!(clear > bent.surface->reach(box.half)) && !(clear > reachByCurvature(*bent.surface, box))) {
      return nullptr;
    }
    flat_[bent.resection].planes[bent.plane] = {bent.surface->normal(), above > 0 ? kFarMm : -kFarMm};
  }
  return &flat_;
}

double mostFlatteningMm(const std::vector<ImageResection>& plan, const Vec3& spacing) {
  double most = 0;
  for (const ImageResection& resection : plan) {
    for (const BentSurface& surface : resection.bends) {
      most = std::max(most, slackOf(surface, spacing));
    }
  }
  return most;
}

}  // namespace glisson
