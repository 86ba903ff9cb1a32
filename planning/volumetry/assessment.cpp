#include "planning/volumetry/assessment.h"

#include <cmath>

#include "planning/volumetry/resected.h"
#include "planning/volumetry/tumour_margin.h"
#include "planning/volumetry/vessel_crossings.h"

namespace glisson {

struct PlanAssessor::Impl {
  struct Part {
    std::string id;
    std::string name;
    VoxelRows rows;
  };

  ImageGeometry geometry;
  VoxelRows liver;           ///< L
  VoxelRows lesionsInLiver;  ///< T and L
  double tumourMl = 0;
  std::vector<Part> tumours;  ///< every lesion's own voxels
  std::vector<Part> vessels;  ///< every vessel's voxels inside L
  std::uint64_t modelRevision = 0;

  [[nodiscard]] double ml(std::int64_t units) const {
    return static_cast<double>(units) / kUnitsPerVoxel * geometry.voxelVolumeMm3() * kMlPerMm3;
  }
  [[nodiscard]] PlanAssessment volumes(const std::vector<ImageResection>& plan, const ResectionPlan& names) const;
  [[nodiscard]] TumourAssessment assessTumour(const Part& tumour, const std::vector<ImageResection>& plan,
                                              const CutDistance& cut) const;
};

namespace {
std::int64_t unitsOf(const VoxelRows& rows) { return static_cast<std::int64_t>(rows.voxels) << 32; }

/// Splits a total so that the two doubles add up to it exactly: the larger part is at least half, so the difference has no
/// rounding.
void splitExactly(double total, double resected, double& resectedOut, double& remnantOut) {
  if (resected >= total - resected) {
    resectedOut = std::min(resected, total);
    remnantOut = total - resectedOut;
  } else {
    remnantOut = total - resected;
    resectedOut = total - remnantOut;
  }
}

std::string resectionName(const Resection& resection, std::size_t index) {
  return resection.name.empty() ? "Resection " + std::to_string(index + 1) : resection.name;
}
}  // namespace

PlanAssessor::PlanAssessor(const Case& source) : impl_(std::make_unique<Impl>()) {
  impl_->geometry = source.liver->geometry;
  impl_->liver = rowsOf(source.liver->liver);
  impl_->lesionsInLiver = rowsOf(source.liver->tumour, &source.liver->liver);
  impl_->tumourMl = source.liver->tumourMl();
  if (!source.model) {
    return;
  }
  impl_->modelRevision = source.model->revision;
  for (const Structure& structure : source.model->structures) {
    const auto& masks = source.segmentation->structures;
    if (structure.sourceIndex < 0 || static_cast<std::size_t>(structure.sourceIndex) >= masks.size()) {
      continue;
    }
    const auto& mask = masks[static_cast<std::size_t>(structure.sourceIndex)].mask;
    if (mask && isLesion(structure.kind)) {
      impl_->tumours.push_back({structure.id, structure.name, rowsOf(*mask)});
    } else if (mask && isVessel(structure.kind)) {
      impl_->vessels.push_back({structure.id, structure.name, rowsOf(*mask, &source.liver->liver)});
    }
  }
}

PlanAssessor::~PlanAssessor() = default;
PlanAssessor::PlanAssessor(PlanAssessor&&) noexcept = default;
PlanAssessor& PlanAssessor::operator=(PlanAssessor&&) noexcept = default;

PlanAssessment PlanAssessor::Impl::volumes(const std::vector<ImageResection>& plan, const ResectionPlan& names) const {
  const Resected inLiver = resect(liver, geometry.spacing, plan);
  const Resected inLesions = resect(lesionsInLiver, geometry.spacing, plan);
  const std::int64_t total = unitsOf(liver);
  const std::int64_t functional = total - unitsOf(lesionsInLiver);
  const std::int64_t resected = inLiver.totalUnits();
  const std::int64_t functionalRemnant = functional - (resected - inLesions.totalUnits());

  PlanAssessment result;
  result.modelRevision = modelRevision;
  result.totalMl = ml(total);
  result.tumourMl = tumourMl;
  result.functionalMl = ml(functional);
  splitExactly(result.totalMl, ml(resected), result.resectedMl, result.remnantMl);
  result.functionalRemnantMl = ml(functionalRemnant);
  result.flrPercent = functional > 0 ? 100.0 * static_cast<double>(functionalRemnant) / static_cast<double>(functional) : 0.0;
  double area = 0;
  for (std::size_t r = 0; r < plan.size(); ++r) {
    result.resections.push_back({resectionName(names.resections[r], r), ml(inLiver.units[r]), inLiver.cutAreaMm2[r]});
    area += inLiver.cutAreaMm2[r];
    if (inLiver.units[r] == 0 || inLiver.units[r] == total) {
      result.warning += (result.warning.empty() ? "" : " ") + result.resections.back().name +
                        " does not divide the liver: " + (inLiver.units[r] == 0 ? "nothing" : "all of it") + " is resected.";
    }
  }
  // A surface's place is uncertain by half a slice; the slice axis is the one with the widest voxels.
  result.volumeUncertaintyMl = 0.5 * geometry.spacing.maxCoeff() * area * kMlPerMm3;
  return result;
}

TumourAssessment PlanAssessor::Impl::assessTumour(const Part& tumour, const std::vector<ImageResection>& plan,
                                                  const CutDistance& cut) const {
  TumourAssessment result;
  result.id = tumour.id;
  result.name = tumour.name;
  const std::int64_t resected = resect(tumour.rows, geometry.spacing, plan).totalUnits();
  if (resected > 0 && resected < unitsOf(tumour.rows)) {
    Vec3 normal;
    result.state = TumourState::Cut;
    result.marginMm = -greatestDepth(tumour.rows, geometry.spacing, plan, normal);
    result.marginAtLeastMm = *result.marginMm - resolutionMm(normal, geometry.spacing);
    return result;
  }
  result.state = resected == 0 ? TumourState::Left : TumourState::Removed;
  const CutDistance::Way way = cut.shortest(tumour.rows, geometry.spacing);
  if (!std::isfinite(way.mm)) {
    return result;
  }
  if (result.state == TumourState::Left) {
    result.distanceMm = way.mm;
    return result;
  }
  const CutPiece& piece = cut.pieces()[way.piece];
  const Vec3 along = way.mm > kOnPlaneMm ? Vec3((way.to - way.from) / way.mm) : plan[piece.resection].planes[piece.plane].normal;
  result.marginMm = way.mm;
  result.marginAtLeastMm = way.mm - resolutionMm(along, geometry.spacing);
  return result;
}

PlanAssessment PlanAssessor::volumes(const ResectionPlan& plan) const {
  return impl_->volumes(toImage(plan, impl_->geometry), plan);
}

PlanAssessment PlanAssessor::assess(const ResectionPlan& plan) const {
  const std::vector<ImageResection> resections = toImage(plan, impl_->geometry);
  PlanAssessment result = impl_->volumes(resections, plan);
  const CutDistance cut(impl_->tumours.empty() ? std::vector<CutPiece>()
                                               : cutSurface(impl_->liver, impl_->geometry.spacing, resections));
  for (const Impl::Part& tumour : impl_->tumours) {
    result.tumours.push_back(impl_->assessTumour(tumour, resections, cut));
  }
  for (const Impl::Part& vessel : impl_->vessels) {
    auto crossings = vesselCrossings(vessel.id, vessel.name, vessel.rows, impl_->geometry, resections);
    result.vesselsCrossed.insert(result.vesselsCrossed.end(), crossings.begin(), crossings.end());
  }
  return result;
}

}  // namespace glisson
