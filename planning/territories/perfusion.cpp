#include "planning/territories/perfusion.h"

#include <algorithm>

#include "planning/territories/vessel_cuts.h"
#include "planning/volumetry/nearest_site.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
/// Complete trees have some 0.5 to 1 mm of centreline per mL of liver; the trunk alone less than 0.05.
constexpr double kFewestMmPerMl = 0.1;

/// A run of voxels of L with one nearest site of each system.
struct Cell {
  RowRun run;
  std::int32_t portal = kNoSite;
  std::int32_t hepatic = kNoSite;
  bool functional = false;
};

/// The nearest supplying site per voxel of a box that holds L; empty where there is none.
struct NearestMap {
  IndexBox box;
  std::vector<std::int32_t> nearest;

  [[nodiscard]] const std::int32_t* row(int i, int j, int k) const {
    return nearest.empty() ? nullptr
                           : &nearest[static_cast<std::size_t>(i - box.first[0]) +
                                      static_cast<std::size_t>(box.size[0]) *
                                          (static_cast<std::size_t>(j - box.first[1]) +
                                           static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k - box.first[2]))];
  }
};

NearestMap nearestSupply(const VesselGraph& graph, const LiverVoxels& liver, const ExecutionContext& context) {
  std::vector<Index3> sites;
  std::vector<std::int32_t> numbers;
  NearestMap map;
  map.box = liver.liver.box();
  for (std::size_t s = 0; s < graph.sites.size(); ++s) {
    if (graph.branches[static_cast<std::size_t>(graph.sites[s].branch)].role == BranchRole::Supplying) {
      sites.push_back(graph.sites[s].voxel);
      numbers.push_back(static_cast<std::int32_t>(s));
      map.box = enclosing(map.box, {graph.sites[s].voxel, {1, 1, 1}});
    }
  }
  if (sites.empty()) {
    return map;
  }
  map.nearest = nearestSites(map.box, liver.geometry.spacing, sites, context);
  for (std::int32_t& site : map.nearest) {
    site = numbers[static_cast<std::size_t>(site)];
  }
  return map;
}

/// A label that hardly enters the liver says nothing about what is supplied: its branches own nothing then.
void dropIfSparse(VesselGraph& graph, const LiverVoxels& liver) {
  double mm = 0;
  for (const VesselSite& site : graph.sites) {
    const bool supplies = graph.branches[static_cast<std::size_t>(site.branch)].role == BranchRole::Supplying;
    if (supplies && site.inLiver && site.parent >= 0) {
      mm += (site.positionMm - graph.sites[static_cast<std::size_t>(site.parent)].positionMm).norm();
    }
  }
  if (graph.empty() || mm >= kFewestMmPerMl * liver.totalMl()) {
    return;
  }
  for (VesselBranch& branch : graph.branches) {
    branch.role = branch.role == BranchRole::Supplying ? BranchRole::Outside : branch.role;
  }
  graph.mainBifurcation.reset();
  graph.notes.push_back(std::string(graph.system == VesselSystem::Portal ? "Portal vein" : "Hepatic veins") + ": only " +
                        formatNumber(mm, 0) +
                        " mm of branches are labelled inside the liver, too few to say what they supply or drain.");
}

/// All structures of the kinds, as one mask.
Mask maskOfKinds(const Segmentation& segmentation, std::initializer_list<StructureKind> kinds) {
  Mask all;
  for (const LabelledMask& structure : segmentation.structures) {
    if (structure.mask && structure.kind && std::find(kinds.begin(), kinds.end(), *structure.kind) != kinds.end()) {
      all = all.empty() ? *structure.mask : unionOf(all, *structure.mask);
    }
  }
  return all;
}

/// The cells of one run of L.
struct CellRow {
  RowRun run;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What is lost, by 2 x (1: devascularised only, 2: congested only, 3: both) + functional.
constexpr std::size_t kNoInflow = 2;
constexpr std::size_t kNoOutflow = 4;
constexpr std::size_t kFunctional = 1;
using LostRows = std::array<VoxelRows, 8>;
}  // namespace

struct LiverPerfusion::Impl {
  ImageGeometry geometry;
  VesselGraph portal;
  VesselGraph hepatic;
  bool hasPortal = false;
  bool hasHepatic = false;
  VoxelRows whole;  ///< L
  VoxelRows functional;
  std::vector<Cell> cells;
  std::vector<CellRow> rows;
  std::uint64_t modelRevision = 0;

  void dealCells(const LiverVoxels& liver, const NearestMap& portalMap, const NearestMap& hepaticMap);
  [[nodiscard]] LostRows lostRows(const LostSites& portalLost, const LostSites& hepaticLost,
                                  const std::vector<ImageResection>& plan, const SidePieces* sides) const;
  [[nodiscard]] std::int64_t remnantUnits(const VoxelRows& part, const std::vector<ImageResection>& plan,
                                          const SidePieces* sides) const {
    const std::int64_t switched = sides != nullptr ? sides->switchedUnits(part, plan) : 0;
    return (static_cast<std::int64_t>(part.voxels) << 32) - resectedUnits(part, geometry.spacing, plan) - switched;
  }
};

void LiverPerfusion::Impl::dealCells(const LiverVoxels& liver, const NearestMap& portalMap, const NearestMap& hepaticMap) {
  for (const RowRun& run : rowsOf(liver.liver).runs) {
    const std::size_t begin = cells.size();
    const std::int32_t* nearestPortal = portalMap.row(run.i, run.j, run.k);
    const std::int32_t* nearestHepatic = hepaticMap.row(run.i, run.j, run.k);
    for (int n = 0; n < run.n; ++n) {
      Cell cell;
      cell.run = {run.i + n, run.j, run.k, 1};
      cell.portal = nearestPortal != nullptr ? nearestPortal[n] : kNoSite;
      cell.hepatic = nearestHepatic != nullptr ? nearestHepatic[n] : kNoSite;
      cell.functional = !liver.tumour.at(run.i + n, run.j, run.k);
      if (n > 0 && cells.back().portal == cell.portal && cells.back().hepatic == cell.hepatic &&
          cells.back().functional == cell.functional) {
        ++cells.back().run.n;
      } else {
        cells.push_back(cell);
      }
    }
    rows.push_back({run, begin, cells.size()});
  }
  cells.shrink_to_fit();
}

LostRows LiverPerfusion::Impl::lostRows(const LostSites& portalLost, const LostSites& hepaticLost,
                                        const std::vector<ImageResection>& plan, const SidePieces* sides) const {
  LostRows lost;
  if (portalLost.cuts.empty() && hepaticLost.cuts.empty()) {
    return lost;
  }
  for (const CellRow& row : rows) {
    if (sides == nullptr && isResected(boxOf(row.run, geometry.spacing), plan)) {
      continue;
    }
    for (std::size_t c = row.begin; c < row.end; ++c) {
      const Cell& cell = cells[c];
      const bool noInflow = cell.portal >= 0 && portalLost.isLost[static_cast<std::size_t>(cell.portal)] != 0;
      const bool noOutflow = cell.hepatic >= 0 && hepaticLost.isLost[static_cast<std::size_t>(cell.hepatic)] != 0;
      if (noInflow || noOutflow) {
        append(lost[(noInflow ? kNoInflow : 0) + (noOutflow ? kNoOutflow : 0) + (cell.functional ? kFunctional : 0)], cell.run);
      }
    }
  }
  return lost;
}

LiverPerfusion::LiverPerfusion(const Case& source, const ExecutionContext& context) : impl_(std::make_unique<Impl>()) {
  const LiverVoxels& liver = *source.liver;
  impl_->geometry = liver.geometry;
  impl_->modelRevision = source.model ? source.model->revision : 0;
  impl_->whole = rowsOf(liver.liver);
  impl_->functional = rowsOf(liver.functional);
  context.report(0.0, "portal vein");
  impl_->portal = vesselGraphOf(VesselSystem::Portal, maskOfKinds(*source.segmentation, {StructureKind::PortalVein}),
                                liver.geometry, liver.liver, nullptr, context);
  context.report(0.3, "hepatic veins");
  const Mask cava = maskOfKinds(*source.segmentation, {StructureKind::VenaCava});
  impl_->hepatic =
      vesselGraphOf(VesselSystem::Hepatic, maskOfKinds(*source.segmentation, {StructureKind::HepaticVein, StructureKind::VenaCava}),
                    liver.geometry, liver.liver, &cava, context);
  dropIfSparse(impl_->portal, liver);
  dropIfSparse(impl_->hepatic, liver);
  context.report(0.6, "territories");
  const NearestMap portalMap = nearestSupply(impl_->portal, liver, context);
  context.report(0.8, "territories");
  const NearestMap hepaticMap = nearestSupply(impl_->hepatic, liver, context);
  impl_->hasPortal = !portalMap.nearest.empty();
  impl_->hasHepatic = !hepaticMap.nearest.empty();
  context.report(0.9, "territories");
  impl_->dealCells(liver, portalMap, hepaticMap);
  context.report(1.0, "territories");
}

LiverPerfusion::~LiverPerfusion() = default;
LiverPerfusion::LiverPerfusion(LiverPerfusion&&) noexcept = default;
LiverPerfusion& LiverPerfusion::operator=(LiverPerfusion&&) noexcept = default;

const VesselGraph& LiverPerfusion::portal() const { return impl_->portal; }
const VesselGraph& LiverPerfusion::hepatic() const { return impl_->hepatic; }

std::vector<std::string> LiverPerfusion::notes() const {
  std::vector<std::string> all = impl_->portal.notes;
  all.insert(all.end(), impl_->hepatic.notes.begin(), impl_->hepatic.notes.end());
  if (!impl_->hasPortal) {
    all.emplace_back("No branches of a portal vein are known inside the liver, so what a plan devascularises is not known.");
  }
  if (!impl_->hasHepatic) {
    all.emplace_back("No branches of hepatic veins are known inside the liver, so what a plan congests is not known.");
  }
  return all;
}

PerfusionEstimate LiverPerfusion::effectOf(const ResectionPlan& plan) const {
  const Impl& my = *impl_;
  const std::vector<ImageResection> resections = toImage(plan, my.geometry);
  const std::optional<SidePieces> moved = switchedSides(my.whole, my.geometry, plan, resections);
  const SidePieces* sides = moved ? &*moved : nullptr;
  LostSites portal = lostSites(my.portal, my.geometry, resections, sides);
  LostSites hepatic = lostSites(my.hepatic, my.geometry, resections, sides);
  const LostRows lost = my.lostRows(portal, hepatic, resections, sides);
  std::array<std::int64_t, 8> units{};
  for (std::size_t n = kNoInflow; n < units.size(); ++n) {
    units[n] = my.remnantUnits(lost[n], resections, sides);
  }
  const double unitMl = my.geometry.voxelVolumeMm3() * kMlPerMm3 / kUnitsPerVoxel;
  const auto ml = [&](std::int64_t count) { return static_cast<double>(count) * unitMl; };
  PerfusionEstimate made;
  made.modelRevision = my.modelRevision;
  if (my.hasPortal) {
    made.devascularisedMl = ml(units[2] + units[3] + units[6] + units[7]);
  }
  if (my.hasHepatic) {
    made.congestedMl = ml(units[4] + units[5] + units[6] + units[7]);
  }
  made.devascularisedOrCongestedMl = ml(units[2] + units[3] + units[4] + units[5] + units[6] + units[7]);
  const std::int64_t functional = my.remnantUnits(my.functional, resections, sides);
  // Parts are rounded apart from the whole.
  const std::int64_t perfused = std::max<std::int64_t>(0, functional - units[3] - units[5] - units[7]);
  made.functionalRemnantMl = ml(functional);
  made.perfusedFlrMl = ml(perfused);
  const double whole = ml(static_cast<std::int64_t>(my.functional.voxels) << 32);
  made.perfusedFlrPercent = whole > 0 ? 100 * made.perfusedFlrMl / whole : 0.0;
  made.portalCuts = std::move(portal.cuts);
  made.hepaticCuts = std::move(hepatic.cuts);
  return made;
}

}  // namespace glisson
