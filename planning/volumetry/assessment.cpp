#include "planning/volumetry/assessment.h"

#include <array>
#include <cmath>
#include <functional>

#include "planning/volumetry/flat_stretches.h"
#include "planning/volumetry/island_depth.h"
#include "planning/volumetry/near_surface.h"
#include "planning/volumetry/resected.h"
#include "planning/volumetry/side_pieces.h"
#include "planning/volumetry/tumour_depth.h"
#include "planning/volumetry/tumour_margin.h"
#include "planning/volumetry/vessel_crossings.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {
/// A plan where the voxels are; the sides' pieces where they are needed.
struct PlanInImage {
  const ResectionPlan& source;
  std::vector<ImageResection> resections;
  std::optional<SidePieces> sides;

  [[nodiscard]] bool hasSwitched() const { return sides && sides->anySwitched(); }
};

/// Voxels twice: flat planes take whole runs, bent ones block by block.
struct Body {
  Body() = default;
  Body(const Mask& mask, const Vec3& spacing, const Mask* within = nullptr) : rows(rowsOf(mask, within)), blocks(rows, spacing) {}
  VoxelRows rows;
  RowBlocks blocks;
};

/// What `of` gives of the form of the voxels that is quicker for the plan.
template <typename Of>
auto quicker(const Body& body, const PlanInImage& plan, const Of& of) {
  return hasBends(plan.resections) ? of(body.blocks) : of(body.rows);
}

/// The margin of the tumour at a place.
using MarginOf = std::function<Margin(std::size_t)>;
}  // namespace

struct PlanAssessor::Impl {
  struct Part {
    std::string id;
    std::string name;
    Body body;
    bool isCyst = false;
  };

  ImageGeometry geometry;
  Body liver;           ///< L
  Body lesionsInLiver;  ///< T and L
  double tumourMl = 0;
  std::vector<Part> tumours;          ///< every lesion's own voxels
  std::vector<NearSurface> near;      ///< around the tumours
  std::vector<Part> vessels;          ///< every vessel's voxels inside L
  std::vector<InscribedBalls> balls;  ///< of the whole vessels
  std::uint64_t modelRevision = 0;

  [[nodiscard]] double ml(std::int64_t units) const {
    return static_cast<double>(units) / kUnitsPerVoxel * geometry.voxelVolumeMm3() * kMlPerMm3;
  }
  [[nodiscard]] Resected resected(const Body& body, const PlanInImage& plan) const {
    return quicker(body, plan, [&](const auto& voxels) { return resect(voxels, geometry.spacing, plan.resections); });
  }
  [[nodiscard]] std::int64_t resectedUnits(const Body& body, const PlanInImage& plan) const {
    return quicker(body, plan,
                   [&](const auto& voxels) { return glisson::resectedUnits(voxels, geometry.spacing, plan.resections); });
  }
  [[nodiscard]] PlanAssessment volumes(const PlanInImage& plan) const;
  [[nodiscard]] PlanAssessment assess(const ResectionPlan& source, bool withIslands) const;
  /// What is wrong with resections, or with the plan, that do not divide L.
  void explain(PlanAssessment& result, const Resected& inLiver, const PlanInImage& plan) const;
  void addVolumes(PlanAssessment& result, const Resected& inLiver, std::int64_t resected, std::int64_t diseased) const;
  [[nodiscard]] std::vector<IslandAssessment> listIslands(const PlanInImage& plan, const SidePieces& sides) const;
  [[nodiscard]] std::vector<TumourAssessment> assessTumours(const PlanInImage& plan) const;
  [[nodiscard]] std::vector<VesselCrossing> findCrossings(const PlanInImage& plan) const;
  /// `whole`: all of the resection surface, which is there where islands are switched.
  [[nodiscard]] TumourAssessment assessTumour(std::size_t place, const PlanInImage& plan, const std::optional<CutDistance>& whole,
                                              const MarginOf& marginAt) const;
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

PlanAssessor::PlanAssessor(const Case& source, const ExecutionContext& context) : impl_(std::make_unique<Impl>()) {
  impl_->geometry = source.liver->geometry;
  impl_->liver = Body(source.liver->liver, impl_->geometry.spacing);
  impl_->lesionsInLiver = Body(source.liver->tumour, impl_->geometry.spacing, &source.liver->liver);
  impl_->tumourMl = source.liver->tumourMl();
  if (!source.model) {
    return;
  }
  impl_->modelRevision = source.model->revision;
  for (const Structure& structure : source.model->structures) {
    context.throwIfCancelled();
    const auto& masks = source.segmentation->structures;
    if (structure.sourceIndex < 0 || static_cast<std::size_t>(structure.sourceIndex) >= masks.size()) {
      continue;
    }
    const auto& mask = masks[static_cast<std::size_t>(structure.sourceIndex)].mask;
    if (mask && isLesion(structure.kind)) {
      impl_->tumours.push_back(
          {structure.id, structure.name, Body(*mask, impl_->geometry.spacing), structure.kind == StructureKind::Cyst});
      impl_->near.emplace_back(impl_->tumours.back().body.rows, impl_->liver.rows, impl_->liver.blocks, impl_->geometry.spacing);
    } else if (mask && isVessel(structure.kind)) {
      impl_->vessels.push_back({structure.id, structure.name, Body(*mask, impl_->geometry.spacing, &source.liver->liver)});
      impl_->balls.emplace_back(*mask, impl_->geometry.spacing, context);
    }
  }
}

PlanAssessor::~PlanAssessor() = default;
PlanAssessor::PlanAssessor(PlanAssessor&&) noexcept = default;
PlanAssessor& PlanAssessor::operator=(PlanAssessor&&) noexcept = default;

namespace {
void addSentence(std::string& text, const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; }

/// The runs that have a piece of the surface, voxel by voxel: each piece has then one voxel before it and one behind. `origin`:
/// each voxel's run among `rows`.
VoxelRows voxelsAlong(const std::vector<CutPiece>& pieces, const VoxelRows& rows, std::vector<std::size_t>& origin) {
  VoxelRows voxels;
  std::size_t done = rows.runs.size();
  for (const CutPiece& piece : pieces) {
    if (piece.run == done) {
      continue;
    }
    done = piece.run;
    const RowRun& run = rows.runs[piece.run];
    for (int i = run.i; i < run.i + run.n; ++i) {
      voxels.runs.push_back({i, run.j, run.k, 1});
      origin.push_back(piece.run);
    }
    voxels.voxels += static_cast<std::size_t>(run.n);
  }
  return voxels;
}

/// The resection surface once islands are where they belong.
std::vector<CutPiece> surfaceOf(const Body& body, const Vec3& spacing, const PlanInImage& plan) {
  std::vector<CutPiece> pieces =
      quicker(body, plan, [&](const auto& voxels) { return cutSurface(voxels, spacing, plan.resections); });
  if (plan.hasSwitched()) {
    std::vector<std::size_t> origin;
    const VoxelRows voxels = voxelsAlong(pieces, body.rows, origin);
    pieces = cutSurface(voxels, spacing, plan.resections);
    std::erase_if(pieces, [&](const CutPiece& piece) { return !plan.sides->separates(piece); });
    for (CutPiece& piece : pieces) {
      piece.run = origin[piece.run];
    }
  }
  return pieces;
}
}  // namespace

void PlanAssessor::Impl::addVolumes(PlanAssessment& result, const Resected& inLiver, std::int64_t resected,
                                    std::int64_t diseased) const {
  const std::int64_t total = unitsOf(liver.rows);
  const std::int64_t functional = total - unitsOf(lesionsInLiver.rows);
  const std::int64_t functionalRemnant = functional - (resected - diseased);
  result.totalMl = ml(total);
  result.tumourMl = tumourMl;
  result.functionalMl = ml(functional);
  splitExactly(result.totalMl, ml(resected), result.resectedMl, result.remnantMl);
  result.functionalRemnantMl = ml(functionalRemnant);
  result.flrPercent = functional > 0 ? 100.0 * static_cast<double>(functionalRemnant) / static_cast<double>(functional) : 0.0;
  double area = 0;
  for (std::size_t r = 0; r < result.resections.size(); ++r) {
    result.resections[r].volumeMl = ml(inLiver.units[r]);
    result.resections[r].cutAreaMm2 = inLiver.cutAreaMm2[r];
    area += inLiver.cutAreaMm2[r];
  }
  // A surface's place is uncertain by half a slice; the slice axis is the one with the widest voxels.
  result.volumeUncertaintyMl = 0.5 * geometry.spacing.maxCoeff() * area * kMlPerMm3;
}

void PlanAssessor::Impl::explain(PlanAssessment& result, const Resected& inLiver, const PlanInImage& plan) const {
  const std::int64_t total = unitsOf(liver.rows);
  const bool takesAll = inLiver.totalUnits() == total;
  bool oneTakesAll = false;
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    if (inLiver.units[r] > 0 && !takesAll) {
      continue;
    }
    // Of what several resections take, the first one has it: only by itself a resection shows what it takes.
    const std::int64_t alone = resectedUnits(liver, {plan.source, {plan.resections[r]}, {}});
    ResectionVolume& resection = result.resections[r];
    if (alone == 0 || alone == total) {
      resection.dividesByItself = false;
      oneTakesAll = oneTakesAll || alone == total;
      addSentence(result.warning,
                  resection.name + " does not divide the liver: " + (alone == 0 ? "nothing" : "all of it") + " is resected.");
    } else if (inLiver.units[r] == 0) {
      addSentence(result.warning, resection.name + " takes nothing: other resections of the plan already take all that it would.");
    }
  }
  if (takesAll && !oneTakesAll && !plan.resections.empty()) {
    addSentence(result.warning, "The resections of the plan together take all of the liver, so nothing of it remains.");
  }
}

PlanAssessment PlanAssessor::Impl::volumes(const PlanInImage& plan) const {
  Resected inLiver = resected(liver, plan);
  const std::int64_t total = unitsOf(liver.rows);
  const std::int64_t byPlanes = inLiver.totalUnits();

  PlanAssessment result;
  result.modelRevision = modelRevision;
  result.divides = plan.resections.empty() || (byPlanes > 0 && byPlanes < total);
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    result.resections.push_back({resectionName(plan.source.resections[r], r), 0, 0});
  }
  explain(result, inLiver, plan);
  std::int64_t taken = byPlanes;
  std::int64_t diseased = resectedUnits(lesionsInLiver, plan);
  if (plan.hasSwitched()) {
    taken += plan.sides->switchedUnits(liver.rows, plan.resections);
    diseased += plan.sides->switchedUnits(lesionsInLiver.rows, plan.resections);
    std::fill(inLiver.cutAreaMm2.begin(), inLiver.cutAreaMm2.end(), 0.0);
    for (const CutPiece& piece : surfaceOf(liver, geometry.spacing, plan)) {
      inLiver.cutAreaMm2[piece.resection] += areaOf(piece.polygon);
    }
  }
  addVolumes(result, inLiver, taken, diseased);
  return result;
}

std::vector<IslandAssessment> PlanAssessor::Impl::listIslands(const PlanInImage& plan, const SidePieces& sides) const {
  std::vector<std::int64_t> diseased;
  (void)sides.switchedUnits(lesionsInLiver.rows, plan.resections, &diseased);
  std::vector<IslandAssessment> islands;
  for (std::size_t n = 0; n < sides.pieces().size(); ++n) {
    const SidePiece& piece = sides.pieces()[n];
    if (!piece.main && (piece.switched || ml(piece.units) > kListedIslandMl)) {
      islands.push_back({piece.side,
                         piece.switched,
                         ml(piece.units),
                         ml(piece.units - diseased[n]),
                         geometry.origin + geometry.direction * piece.point,
                         {}});
      for (std::size_t given = 0; given < plan.source.islands.size(); ++given) {
        const IslandAssignment& one = plan.source.islands[given];
        if (one.to != piece.side &&
            sides.pieceAt(piece.side, geometry.direction.transpose() * (one.point - geometry.origin)) == n) {
          islands.back().assignments.push_back(given);
        }
      }
    }
  }
  std::stable_sort(islands.begin(), islands.end(),
                   [](const IslandAssessment& a, const IslandAssessment& b) { return a.volumeMl > b.volumeMl; });
  return islands;
}

TumourAssessment PlanAssessor::Impl::assessTumour(std::size_t place, const PlanInImage& plan,
                                                  const std::optional<CutDistance>& whole, const MarginOf& marginAt) const {
  const Part& tumour = tumours[place];
  const VoxelRows& rows = tumour.body.rows;
  TumourAssessment result;
  result.id = tumour.id;
  result.name = tumour.name;
  result.isCyst = tumour.isCyst;
  std::int64_t taken = resectedUnits(tumour.body, plan);
  if (plan.hasSwitched()) {
    taken += plan.sides->switchedUnits(rows, plan.resections);
  }
  if (taken > 0 && taken < unitsOf(rows)) {
    result.state = TumourState::Cut;
    if (!plan.hasSwitched()) {
      Vec3 normal;
      result.marginMm = -greatestDepth(rows, geometry.spacing, plan.resections, normal);
      result.marginAtLeastMm = *result.marginMm - resolutionMm(normal, geometry.spacing);
    } else if (!whole->pieces().empty()) {  // else it lies beside the liver, where nothing divides the sides any more
      const CutDistance::Way way = greatestDepth(rows, geometry.spacing, plan.resections, *plan.sides, *whole);
      const CutPiece& piece = whole->pieces()[way.piece];
      const Vec3 along = way.mm > kOnPlaneMm ? Vec3((way.to - way.from) / way.mm) : piece.normal;
      result.marginMm = -way.mm;
      result.marginAtLeastMm = -way.mm - piece.flatteningMm - resolutionMm(along, geometry.spacing);
    }
    return result;
  }
  result.state = taken == 0 ? TumourState::Left : TumourState::Removed;
  const Margin margin = marginAt(place);
  if (!std::isfinite(margin.mm)) {
    return result;
  }
  result.way = {geometry.origin + geometry.direction * margin.from, geometry.origin + geometry.direction * margin.to};
  if (result.state == TumourState::Left) {
    result.distanceMm = margin.mm;
    return result;
  }
  result.marginMm = margin.mm;
  result.marginAtLeastMm = margin.atLeast;
  return result;
}

PlanAssessment PlanAssessor::volumes(const ResectionPlan& source) const {
  PlanInImage plan{source, toImage(source, impl_->geometry), {}};
  std::string warning;
  plan.sides = switchedSides(impl_->liver.rows, impl_->geometry, source, plan.resections, &warning);
  PlanAssessment result = impl_->volumes(plan);
  if (!warning.empty()) {
    addSentence(result.warning, warning);
  }
  return result;
}

std::vector<TumourAssessment> PlanAssessor::Impl::assessTumours(const PlanInImage& plan) const {
  std::vector<TumourAssessment> assessed(tumours.size());
  if (tumours.empty()) {
    return assessed;
  }
  // Islands decide what is left of the surface, so none of it can be left out.
  std::optional<CutDistance> whole;
  std::vector<std::size_t> cut;
  if (plan.hasSwitched()) {
    whole.emplace(surfaceOf(liver, geometry.spacing, plan));
  } else {
    cut = cutBlocks(liver.blocks, geometry.spacing, plan.resections);
  }
  const MarginOf margin = [&](std::size_t n) {
    return whole ? marginOf(near[n].tumour(), geometry.spacing, *whole)
                 : marginOf(near[n].tumour(), geometry.spacing, CutDistance(near[n].pieces(cut, plan.resections)));
  };
  parallelFor(tumours.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      assessed[n] = assessTumour(n, plan, whole, margin);
    }
  });
  return assessed;
}

std::vector<VesselCrossing> PlanAssessor::Impl::findCrossings(const PlanInImage& plan) const {
  std::vector<VesselCrossing> crossings;
  for (std::size_t n = 0; n < vessels.size(); ++n) {
    const Part& vessel = vessels[n];
    const std::vector<CutPiece> pieces = surfaceOf(vessel.body, geometry.spacing, plan);
    const auto found = vesselCrossings(vessel.id, vessel.name, vessel.body.rows, pieces, balls[n], geometry);
    crossings.insert(crossings.end(), found.begin(), found.end());
  }
  return crossings;
}

PlanAssessment PlanAssessor::Impl::assess(const ResectionPlan& source, bool withIslands) const {
  PlanInImage plan{source, toImage(source, geometry), {}};
  std::string warning;
  plan.sides = switchedSides(liver.rows, geometry, source, plan.resections, &warning);
  PlanAssessment result;
  std::vector<TumourAssessment> assessed;
  std::vector<VesselCrossing> crossings;
  std::optional<SidePieces> found;  // what only the list of islands asks for need not be there before the rest
  const std::array<std::function<void()>, 4> work{[&] { assessed = assessTumours(plan); }, [&] { crossings = findCrossings(plan); },
                                                  [&] {
                                                    if (withIslands && !plan.sides && !source.resections.empty()) {
                                                      found.emplace(liver.rows, geometry.spacing, plan.resections);
                                                    }
                                                  },
                                                  [&] { result = volumes(plan); }};
  parallelFor(work.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      work[n]();
    }
  });
  if (!warning.empty()) {
    addSentence(result.warning, warning);
  }
  const std::optional<SidePieces>& sides = plan.sides ? plan.sides : found;
  if (withIslands && sides && result.divides) {
    result.islands = listIslands(plan, *sides);
  }
  result.tumours = std::move(assessed);
  result.vesselsCrossed = std::move(crossings);
  return result;
}

PlanAssessment PlanAssessor::assessMoving(const ResectionPlan& plan) const { return impl_->assess(plan, false); }
PlanAssessment PlanAssessor::assess(const ResectionPlan& plan) const { return impl_->assess(plan, true); }

}  // namespace glisson
